// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_RUN_WATCH_H
#define SEGMENT_MESH_RUN_WATCH_H

#include "../meshes/Failure.h"

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <limits>
#include <map>
#include <string>

namespace segment_mesh {

// Takes the time of each phase of the program and of each stage of the segmentation, and shows a
// line of progress on standard error once a run has lasted, or will last, for a second. Ends a run
// that lasts too long.
class Run_watch : public CGAL::Spectral_segmentation::Segmentation_visitor
{
public:
  typedef CGAL::Spectral_segmentation::Stage Stage;

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds_since(Clock::time_point start)
  { return std::chrono::duration<double>(Clock::now() - start).count(); }

  Clock::time_point start_ = Clock::now();
  std::map<std::size_t, Clock::time_point> start_of_stage_; // one per part
  std::map<Stage, double> seconds_of_stage_;
  std::map<std::string, double> seconds_of_phase_;
  std::string phase_, shown_name_;
  Clock::time_point start_of_phase_ = start_;
  double begin_ = 0, end_ = 0; // the range of the phase, as fractions of the run
  double share_ = 0;           // the fraction of the run that is done
  const bool shows_progress_;
  const double time_limit_; // in seconds
  std::size_t shown_length_ = 0;
  double last_shown_ = 0;

  static const char* name_of(Stage stage)
  {
    return stage == Stage::INITIALIZATION ? "simplifying" :
           stage == Stage::PROJECTION ? "carrying cuts over" : "cutting";
  }

  void show(std::string line)
  {
    const std::size_t length = line.size();
    line.resize((std::max)(length, shown_length_), ' ');
    shown_length_ = length;
    std::cerr << '\r' << line << std::flush;
  }

  void check_time() const
  {
    if (seconds() > time_limit_)
      throw Failure(Status::TIME, "the run takes longer than its time limit");
  }

  void show_progress()
  {
    last_shown_ = seconds();
    std::string line = std::to_string(static_cast<int>(100 * share_)) + " %, " + shown_name_ +
                       ", " + std::to_string(static_cast<long>(last_shown_)) + " s";
    if (share_ > 0.05)
      line += ", " + std::to_string(static_cast<long>(last_shown_ * (1 - share_) / share_ + 1)) +
              " s to go";
    show(line);
  }

public:
  explicit Run_watch(bool shows_progress,
                     double time_limit = std::numeric_limits<double>::infinity())
    : shows_progress_(shows_progress), time_limit_(time_limit) {}

  ~Run_watch() { hide(); }

  Run_watch(const Run_watch&) = delete;
  Run_watch& operator=(const Run_watch&) = delete;

  void hide()
  {
    if (shown_length_ == 0)
      return;
    show("");
    std::cerr << '\r' << std::flush;
  }

  double seconds() const { return seconds_since(start_); }

  // Returns the seconds of a stage, summed over all parts, some of which several threads search at
  // the same time.
  double seconds(Stage stage) const
  {
    const auto found = seconds_of_stage_.find(stage);
    return found == seconds_of_stage_.end() ? 0 : found->second;
  }

  double seconds(const std::string& phase) const
  {
    const auto found = seconds_of_phase_.find(phase);
    return found == seconds_of_phase_.end() ? 0 : found->second;
  }

  // Ends the current phase and starts another, which has a weight by its expected seconds and those
  // of all later phases.
  void start_phase(const std::string& name, double seconds_expected, double seconds_after)
  {
    end_phase();
    phase_ = shown_name_ = name;
    start_of_phase_ = Clock::now();
    begin_ = share_ = end_;
    end_ += (1 - begin_) * seconds_expected / (seconds_expected + seconds_after);
    if (shows_progress_ && (seconds() > 1 || seconds_expected + seconds_after > 5))
      show_progress();
  }

  void end_phase()
  {
    if (!phase_.empty())
      seconds_of_phase_[phase_] += seconds_since(start_of_phase_);
    phase_.clear();
    check_time();
  }

  void before_stage(Stage stage, std::size_t part)
  {
    start_of_stage_[part] = Clock::now();
    shown_name_ = name_of(stage);
  }

  void after_stage(Stage stage, std::size_t part)
  { seconds_of_stage_[stage] += seconds_since(start_of_stage_[part]); }

  // Sets the progress of the segmentation.
  void progress(double share) { share_ = begin_ + share * (end_ - begin_); }

  bool go_further()
  {
    check_time();
    if (shows_progress_ && seconds() > 1 && seconds() > last_shown_ + 0.2)
      show_progress();
    return true;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_RUN_WATCH_H
