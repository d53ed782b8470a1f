// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PROCESS_MEMORY_H
#define SEGMENT_MESH_PROCESS_MEMORY_H

#include <cstddef>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace segment_mesh {

// The largest memory of the process so far, in bytes; 0 where the system does not tell it.
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

// More than this, in bytes of address space, is std::bad_alloc. Without effect where the system
// has no such limit.
inline void limit_memory([[maybe_unused]] double bytes)
{
#if defined(__unix__) || defined(__APPLE__)
  rlimit limit;
  if (getrlimit(RLIMIT_AS, &limit) != 0 || bytes >= static_cast<double>(limit.rlim_cur))
    return;
  limit.rlim_cur = static_cast<rlim_t>(bytes);
  setrlimit(RLIMIT_AS, &limit);
#endif
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PROCESS_MEMORY_H
