// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_RANDOM_NUMBERS_H
#define SEGMENTATION_BENCHMARK_RANDOM_NUMBERS_H

#include <cmath>
#include <random>

namespace segmentation_benchmark {

// Gives the same numbers on every machine, unless a distribution of the standard library is used.
typedef std::mt19937_64 Random_engine;

// Returns a number that is at least 0 and less than 1.
inline double uniform_random(Random_engine& random)
{ return std::ldexp(static_cast<double>(random() >> 11), -53); }

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_RANDOM_NUMBERS_H
