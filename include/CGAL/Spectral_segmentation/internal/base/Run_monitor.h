// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_MONITOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_MONITOR_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/base/concurrency.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <type_traits>

namespace CGAL::Spectral_segmentation::internal {

// Thrown to leave a stage when the caller does not want to go further.
struct Run_stopped {};

// Stands between the stages, which may run in several threads, and the visitor of the caller: one
// call at a time. Keeps the share of the run that is done.
class Run_monitor
{
  Segmentation_visitor& visitor_;
  std::mutex mutex_;
  std::atomic<bool> is_stopped_{false};
  double start_ = 0, end_ = 0; // of the phase at hand, as shares of the run
  double done_ = 0;            // of the phase
  double reported_ = 0;        // of the run

  template <class Function>
  void call(const Function& f)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    call_isolated(f); // or this thread might take up a part that waits for the lock
  }

  void report()
  {
    constexpr double step = 0.002;
    const double share = start_ + (end_ - start_) * done_;
    if (is_stopped_ || share < reported_ + step)
      return;
    reported_ = share;
    visitor_.progress(share);
  }

public:
  explicit Run_monitor(Segmentation_visitor& visitor) : visitor_(visitor) {}

  void start_part(std::size_t part, std::size_t number_of_faces)
  { call([&] { visitor_.start_part(part, number_of_faces); }); }

  void end_part(std::size_t part)
  { call([&] { visitor_.end_part(part); }); }

  void part_cut(std::size_t part, const Salience_factors& factors, double salience,
                std::size_t number_of_segments)
  { call([&] { visitor_.part_cut(part, factors, salience, number_of_segments); }); }

  void cut_evaluated(const Evaluated_cut& cut) { call([&] { visitor_.cut_evaluated(cut); }); }

  bool is_stopped() const { return is_stopped_; }

  // After the first `false` the caller is not asked again.
  bool go_further()
  {
    if (!is_stopped_)
      call([&] {
        if (!is_stopped_) // by another thread, while this one waited
          is_stopped_ = !visitor_.go_further();
      });
    return !is_stopped_;
  }

  void check()
  {
    if (!go_further())
      throw Run_stopped();
  }

  // The next phase takes this share of the run.
  void start_phase(double share)
  {
    call([&] {
      start_ = end_;
      end_ = (std::min)(start_ + share, 1.);
      done_ = 0;
      report();
    });
  }

  // Some more of the phase is done.
  void advance(double share)
  {
    call([&] {
      done_ = (std::min)(done_ + share, 1.);
      report();
    });
  }

  // A share of what is left of the phase is done, where nobody knows how long it takes.
  void approach(double share)
  {
    call([&] {
      done_ += (1 - done_) * share;
      report();
    });
  }

  // So much of the phase is done, if not more.
  void advance_to(double share)
  {
    call([&] {
      done_ = (std::max)(done_, (std::min)(share, 1.));
      report();
    });
  }

  void finish()
  {
    if (!is_stopped_)
      call([&] { visitor_.progress(1); });
  }

  // The result of f(), which is the work of a stage.
  template <class Function>
  auto stage(Stage stage, std::size_t part, const Function& f)
  {
    call([&] { visitor_.start_stage(stage, part); });
    const auto end = [&] { call([&] { visitor_.end_stage(stage, part); }); };
    if constexpr (std::is_void<decltype(f())>::value) {
      f();
      end();
    }
    else {
      auto result = f();
      end();
      return result;
    }
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_MONITOR_H
