// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The right form of what is wrong in the other files: compiles.

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, int> Segment_ids;
namespace params = CGAL::Spectral_segmentation::parameters;

struct Own_salience
{
  float operator()(const CGAL::Spectral_segmentation::Salience_factors& f) const
  { return float(f.cut_strength); }
};

std::size_t run(const Mesh& mesh, Segment_ids ids, CGAL::Spectral_segmentation::Segmentation_hierarchy& tree)
{
  return CGAL::segment_spectral_recursive(mesh, ids) +
         CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
           mesh, ids, CGAL::parameters::random_seed(1)) +
         CGAL::segment_spectral_recursive(
           mesh, ids, params::from(CGAL::parameters::random_seed(1)).salience_threshold(0.3)) +
         CGAL::segment_spectral_recursive(
           mesh, ids, params::zhang_liu_2005().part_salience(Own_salience()).concavity_radius(0)
                        .single_source_orderings(true).thickness_orderings(true)
                        .number_of_candidates(14).number_of_refined_candidates(4)
                        .number_of_regions(20).number_of_searched_faces(4000)) +
         CGAL::segment_spectral_recursive(
           mesh, ids, params::random_seed(1).salience_threshold(0.3).maximum_number_of_segments(2)
                        .boundary_smoothing(true).salience_weights(0.1, 0.6, 0.3)
                        .hierarchy(tree));
}
