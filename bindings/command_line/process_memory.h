// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PROCESS_MEMORY_H
#define SEGMENT_MESH_PROCESS_MEMORY_H

#include <cstddef>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace segment_mesh {

// Returns the largest memory of the process so far, in bytes; 0 if the system does not report it.
inline std::size_t peak_memory()
{
#if defined(__unix__) || defined(__APPLE__)
  rusage usage;
  if (getrusage(RUSAGE_SELF, &usage) != 0)
    return 0;
#ifdef __APPLE__
  return static_cast<std::size_t>(usage.ru_maxrss);
#else
  return 1024 * static_cast<std::size_t>(usage.ru_maxrss);
#endif
#else
  return 0;
#endif
}

// Limits the address space of the process while this object lives: more memory throws
// std::bad_alloc. Its end restores the former limit, so that there is memory for a message. Has no
// effect where the system has no such limit.
class Memory_limit
{
#if defined(__unix__) || defined(__APPLE__)
  rlimit before_;
  bool is_set_ = false;

public:
  explicit Memory_limit(double bytes)
  {
    if (getrlimit(RLIMIT_AS, &before_) != 0 || bytes >= static_cast<double>(before_.rlim_cur))
      return;
    rlimit limit = before_;
    limit.rlim_cur = static_cast<rlim_t>(bytes);
    is_set_ = setrlimit(RLIMIT_AS, &limit) == 0;
  }

  ~Memory_limit()
  {
    if (is_set_)
      setrlimit(RLIMIT_AS, &before_);
  }
#else
public:
  explicit Memory_limit(double) {}
#endif

  Memory_limit(const Memory_limit&) = delete;
  Memory_limit& operator=(const Memory_limit&) = delete;
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_PROCESS_MEMORY_H
