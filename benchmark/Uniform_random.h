// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_UNIFORM_RANDOM_H
#define SEGMENTATION_BENCHMARK_UNIFORM_RANDOM_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace segmentation_benchmark {

// The same numbers on every machine: the distributions of the standard library may differ.
class Uniform_random
{
  std::mt19937_64 bits_;

public:
  explicit Uniform_random(std::uint64_t seed) : bits_(seed) {}

  // At least 0, less than 1.
  double operator()() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }

  double operator()(double least, double largest) { return least + (largest - least) * (*this)(); }

  // Less than n.
  std::size_t below(std::size_t n)
  { return static_cast<std::size_t>(static_cast<double>(n) * (*this)()); }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_UNIFORM_RANDOM_H
