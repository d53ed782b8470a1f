// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_HIERARCHIES_H
#define SPECTRAL_SEGMENTATION_TEST_HIERARCHIES_H

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace test_meshes {

using CGAL::Spectral_segmentation::Segmentation_hierarchy;

// Returns the labels, or nothing where they are not known.
inline Labels labels_or_nothing(const Segmentation_hierarchy& h, std::size_t n, double threshold)
{
  try {
    return labels_above(h, threshold, n);
  }
  catch (const std::out_of_range&) {
    return {};
  }
}

// A salience as strange as a user-defined one may be.
struct Strange_salience
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double operator()(const CGAL::Spectral_segmentation::Salience_factors& f) const
  { return f.size > 0.3 ? infinity : f.size < 0.1 ? -infinity : -f.size / 3; }
};

// Calls a function with hierarchies of many kinds, to be written and read.
template <class Function>
void for_each_hierarchy(const Function& f)
{
  namespace parameters = CGAL::Spectral_segmentation::parameters;
  f(Segmentation_hierarchy());
  const auto check_runs = [&](const Mesh& mesh, const auto& np) {
    f(hierarchy_of(mesh, np));
    f(hierarchy_of(mesh, np.number_of_segments(25)));
    f(hierarchy_of(mesh, np.salience_threshold(-Strange_salience::infinity)
                           .maximum_number_of_segments(6)
                           .part_salience(Strange_salience())));
  };
  for (const Mesh& mesh : {mesh_of(doll()), mesh_of(dumbbell(8, 8)),
                           mesh_of(disjoint_union(dumbbell(14, 10), torus(3, 1, 20, 10)))})
    check_runs(mesh, parameters::zhang_liu_2005());
  check_runs(mesh_of(disjoint_union(dumbbell(8, 8), torus(3, 1, 20, 10))),
             parameters::default_values());
}

} // namespace test_meshes

#endif // SPECTRAL_SEGMENTATION_TEST_HIERARCHIES_H
