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

namespace CGAL::Spectral_segmentation::internal {

// Receives the progress of the engine and may stop it, by the functions of `Segmentation_visitor`.
// No two are called at the same time.
class Run_control
{
public:
  virtual ~Run_control() = default;

  virtual void before_stage(Stage, std::size_t /* part */) {}
  virtual void after_stage(Stage, std::size_t /* part */) {}
  virtual void before_part(std::size_t /* part */, std::size_t /* number_of_faces */) {}
  virtual void after_part(std::size_t /* part */) {}
  virtual void after_cut(std::size_t /* part */, const Salience_factors&, double /* salience */,
                         std::size_t /* number_of_segments */) {}
  virtual void progress(double /* fraction */) {}
  virtual bool go_further() { return true; }
};

// Thrown to leave a stage after the caller stopped the run.
struct Run_stopped {};

// Passes the calls of the stages, which may run in several threads, to the control of the caller,
// one call at a time. Keeps the fraction of the run that is done.
class Run_monitor
{
  Run_control& control_;
  std::mutex mutex_;
  std::atomic<bool> is_stopped_{false};
  std::atomic<std::size_t> steps_{0}; // steps since the last question
  double start_ = 0, end_ = 0; // the range of the current phase within the run
  double done_ = 0;            // the fraction of the phase that is done
  double reported_ = 0;        // the fraction of the run that was reported last

  template <class Function>
  void call(const Function& f)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    call_isolated(f); // otherwise this thread might start a part that waits for the lock
  }

  void report()
  {
    constexpr double step = 0.002;
    const double fraction = start_ + (end_ - start_) * done_;
    if (is_stopped_ || fraction < reported_ + step)
      return;
    reported_ = fraction;
    control_.progress(fraction);
  }

public:
  explicit Run_monitor(Run_control& control) : control_(control) {}

  void before_part(std::size_t part, std::size_t number_of_faces)
  { call([&] { control_.before_part(part, number_of_faces); }); }

  void after_part(std::size_t part)
  { call([&] { control_.after_part(part); }); }

  void after_cut(std::size_t part, const Salience_factors& factors, double salience,
                 std::size_t number_of_segments)
  { call([&] { control_.after_cut(part, factors, salience, number_of_segments); }); }

  bool is_stopped() const { return is_stopped_; }

  // Returns false, without asking again, once the caller has declined.
  bool go_further()
  {
    if (!is_stopped_)
      call([&] {
        if (!is_stopped_) // another thread may have stopped the run meanwhile
          is_stopped_ = !control_.go_further();
      });
    return !is_stopped_;
  }

  void check()
  {
    if (!go_further())
      throw Run_stopped();
  }

  // Counts short steps, and asks the caller every few milliseconds. The answer only affects later
  // stages, but an exception of the caller ends the loop.
  void count_steps(std::size_t number)
  {
    constexpr std::size_t steps_between_questions = 1 << 17;
    const std::size_t steps = steps_.load(std::memory_order_relaxed) + number; // may lose some
    steps_.store(steps % steps_between_questions, std::memory_order_relaxed);
    if (steps >= steps_between_questions)
      go_further();
  }

  // Starts a phase that takes this fraction of the run.
  void start_phase(double fraction)
  {
    call([&] {
      start_ = end_;
      end_ = (std::min)(start_ + fraction, 1.);
      done_ = 0;
      report();
    });
  }

  // Adds to the completed fraction of the phase.
  void advance(double fraction)
  {
    call([&] {
      done_ = (std::min)(done_ + fraction, 1.);
      report();
    });
  }

  // Marks a fraction of the rest of the phase as done, if the length of the phase is unknown.
  void approach(double fraction)
  {
    call([&] {
      done_ += (1 - done_) * fraction;
      report();
    });
  }

  // Marks at least this fraction of the phase as done.
  void advance_to(double fraction)
  {
    call([&] {
      done_ = (std::max)(done_, (std::min)(fraction, 1.));
      report();
    });
  }

  void finish()
  {
    if (!is_stopped_)
      call([&] { control_.progress(1); });
  }

  // Runs f(), which is the work of a stage, and returns its result.
  template <class Function>
  auto stage(Stage stage, std::size_t part, const Function& f)
  {
    call([&] { control_.before_stage(stage, part); });
    auto result = f();
    call([&] { control_.after_stage(stage, part); });
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_RUN_MONITOR_H
