// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PEAK_MEMORY_H
#define SEGMENTATION_BENCHMARK_PEAK_MEMORY_H

#include <malloc.h>

#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>

namespace segmentation_benchmark {

// The largest memory of the process since this was made, beyond what it had then. Linux counts the
// resident pages, so that it does not matter which library asked for them, and how. On meshes of a
// few thousand faces it is mostly the allocator's rounding.
class Peak_memory
{
  std::size_t before_;

  static std::size_t bytes(const std::string& field)
  {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (word == field) {
        std::size_t kilobytes;
        status >> kilobytes;
        return 1024 * kilobytes;
      }
    throw std::runtime_error("there is no " + field + " in /proc/self/status");
  }

public:
  Peak_memory()
  {
    malloc_trim(0);
    if (!(std::ofstream("/proc/self/clear_refs") << 5 << std::flush)) // makes VmHWM forget
      throw std::runtime_error("cannot write into /proc/self/clear_refs");
    before_ = bytes("VmRSS:");
  }

  std::size_t bytes() const
  {
    const std::size_t peak = bytes("VmHWM:");
    return peak > before_ ? peak - before_ : 0;
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PEAK_MEMORY_H
