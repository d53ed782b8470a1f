// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_EVENT_VISITOR_H
#define SPECTRAL_SEGMENTATION_TEST_EVENT_VISITOR_H

#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>

#include <cstddef>

// Calls `event()` of a derived class at each event of a run.
template <class Derived>
class Event_visitor : public CGAL::Spectral_segmentation::Segmentation_visitor
{
  typedef CGAL::Spectral_segmentation::Stage Stage;

  void event() { static_cast<Derived*>(this)->event(); }

public:
  void before_stage(Stage, std::size_t) { event(); }
  void after_stage(Stage, std::size_t) { event(); }
  void before_part(std::size_t, std::size_t) { event(); }
  void after_part(std::size_t) { event(); }
  void after_cut(std::size_t, const CGAL::Spectral_segmentation::Salience_factors&, double,
                 std::size_t) { event(); }
  void progress(double) { event(); }

  bool go_further()
  {
    event();
    return true;
  }
};

#endif // SPECTRAL_SEGMENTATION_TEST_EVENT_VISITOR_H
