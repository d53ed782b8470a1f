// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_RUN_WATCH_H
#define SEGMENT_MESH_RUN_WATCH_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>

#include <chrono>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>

namespace segment_mesh {

// Takes the time of each stage, and shows a line of progress on standard error once a run has
// lasted for a second.
class Run_watch : public CGAL::Spectral_segmentation::Segmentation_visitor
{
public:
  typedef CGAL::Spectral_segmentation::Stage Stage;

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds_since(Clock::time_point start)
  { return std::chrono::duration<double>(Clock::now() - start).count(); }

  Clock::time_point start_ = Clock::now();
  std::map<std::size_t, Clock::time_point> start_of_stage_; // of each part
  std::map<Stage, double> seconds_;
  bool shows_progress_;
  double last_shown_ = 0;
  double share_ = 0; // of the run that is done

  void show_progress()
  {
    const double seconds = this->seconds();
    if (!shows_progress_ || seconds < 1 || seconds < last_shown_ + 0.2)
      return;
    last_shown_ = seconds;
    std::cerr << "\r" << std::setw(3) << static_cast<int>(100 * share_) << " %, "
              << static_cast<long>(seconds) << " s" << std::flush;
  }

public:
  explicit Run_watch(bool shows_progress) : shows_progress_(shows_progress) {}

  ~Run_watch()
  {
    if (last_shown_ > 0)
      std::cerr << "\r" << std::string(20, ' ') << "\r" << std::flush;
  }

  Run_watch(const Run_watch&) = delete;
  Run_watch& operator=(const Run_watch&) = delete;

  double seconds() const { return seconds_since(start_); }

  // Summed over the parts, some of which are searched at the same time by several threads.
  double seconds(Stage stage) const
  {
    const auto found = seconds_.find(stage);
    return found == seconds_.end() ? 0 : found->second;
  }

  void start_stage(Stage, std::size_t part) { start_of_stage_[part] = Clock::now(); }

  void end_stage(Stage stage, std::size_t part)
  { seconds_[stage] += seconds_since(start_of_stage_[part]); }

  void progress(double share) { share_ = share; }

  bool go_further()
  {
    show_progress();
    return true;
  }
};

} // namespace segment_mesh

#endif // SEGMENT_MESH_RUN_WATCH_H
