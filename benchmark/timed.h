// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_TIMED_H
#define SEGMENTATION_BENCHMARK_TIMED_H

#define BOOST_CHRONO_HEADER_ONLY
#include <boost/chrono/duration.hpp>
#include <boost/chrono/system_clocks.hpp>
#include <boost/chrono/thread_clock.hpp>

#include <utility>

namespace segmentation_benchmark {

// A time in seconds.
struct Time
{
  double wall = 0;
  double thread = 0; // that the calling thread was at work
};

template <class Clock>
class Timer
{
  typename Clock::time_point start_ = Clock::now();

public:
  double seconds() const { return boost::chrono::duration<double>(Clock::now() - start_).count(); }
};

// Returns f() and the time that it takes.
template <class Function>
auto timed(const Function& f)
{
  const Timer<boost::chrono::steady_clock> wall;
  const Timer<boost::chrono::thread_clock> thread;
  auto result = f();
  return std::make_pair(std::move(result), Time{wall.seconds(), thread.seconds()});
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_TIMED_H
