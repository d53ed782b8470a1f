// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_ACCESS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_ACCESS_H

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/internal/salience/Boundary_network.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Spectral_segmentation::internal {

// Gives access to the data of a hierarchy that are written and have no public name.
struct Hierarchy_access
{
  static const Cut_hierarchy& cuts(const Segmentation_hierarchy& h) { return h.cuts_; }

  static std::size_t maximum_number_of_segments(const Segmentation_hierarchy& h)
  { return h.maximum_number_of_segments_; }
};

constexpr const char* name_of_format = "CGAL Spectral_segmentation hierarchy";
constexpr std::size_t version_of_format = 1;

constexpr std::array<std::pair<Cut_state, const char*>, 4> names_of_cut_states = {{
  {Cut_state::NOT_SEARCHED, "not searched"},
  {Cut_state::NO_CUT, "no cut"},
  {Cut_state::REJECTED, "rejected"},
  {Cut_state::CUT, "cut"}}};

// Numbers that JSON does not have are strings.
constexpr const char* infinity_string = "infinity";
constexpr const char* minus_infinity_string = "-infinity";
constexpr const char* nan_string = "nan";

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_JSON_HIERARCHY_ACCESS_H
