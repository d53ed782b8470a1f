// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MONITOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MONITOR_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>

#include <cstddef>
#include <mutex>
#include <type_traits>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// Thrown to leave the recursion when the visitor does not want to go further.
struct Run_stopped {};

// Stands between the stages and the visitor of the caller: one call at a time.
template <class Visitor>
class Monitor
{
  Visitor& visitor_;
  std::mutex mutex_;

  template <class Function>
  void call(const Function& f)
  {
    if constexpr (!std::is_same<Visitor, Segmentation_visitor>::value) {
      const std::lock_guard<std::mutex> lock(mutex_);
      call_isolated(f); // lest the thread meets a part that locks again
    }
  }

public:
  explicit Monitor(Visitor& visitor) : visitor_(visitor) {}

  void start_part(std::size_t part, std::size_t number_of_faces)
  { call([&] { visitor_.start_part(part, number_of_faces); }); }

  void end_part(std::size_t part)
  { call([&] { visitor_.end_part(part); }); }

  void part_cut(std::size_t part, const Salience_factors& factors, double salience,
                std::size_t number_of_segments)
  { call([&] { visitor_.part_cut(part, factors, salience, number_of_segments); }); }

  bool go_further()
  {
    bool result = true;
    call([&] { result = visitor_.go_further(); });
    return result;
  }

  void check()
  {
    if (!go_further())
      throw Run_stopped();
  }

  // The result of f(), which is the work of a stage.
  template <class Function>
  auto stage(Stage stage, std::size_t part, const Function& f)
  {
    call([&] { visitor_.start_stage(stage, part); });
    auto result = f();
    call([&] { visitor_.end_stage(stage, part); });
    return result;
  }
};

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MONITOR_H
