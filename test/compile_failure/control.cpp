// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The right form of the lines that are wrong in the other files: compiles.

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, int> Segment_ids;
namespace params = CGAL::Spectral_segmentation::parameters;

struct Own_salience
{
  float operator()(const CGAL::Spectral_segmentation::Salience_factors& f) const
  { return float(f.cut_strength); }
};

auto in_a_chain(const Mesh& mesh, CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy)
{
  CGAL::Spectral_segmentation::Segmentation_visitor visitor;
  return params::vertex_point_map(mesh.points()).face_index_map(get(CGAL::face_index, mesh))
    .geom_traits(Kernel()).random_seed(1).visitor(visitor).maximum_number_of_segments(2)
    .minimum_segment_size(0.1f).feature_weight(0.5f).salience_threshold(1).part_salience(Own_salience())
    .salience_weights(0.1, 0.6f, 0).distance_weights(0.1, 1, 0.1f).number_of_reference_faces(3u)
    .number_of_coarse_faces(0).number_of_searches(1).number_of_smoothing_iterations(std::size_t(1))
    .hierarchy(hierarchy).zhang_liu_2005();
}

auto at_the_start(const Mesh& mesh, CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                  CGAL::Spectral_segmentation::Segmentation_visitor& visitor)
{
  params::vertex_point_map(mesh.points());
  params::face_index_map(get(CGAL::face_index, mesh));
  params::geom_traits(Kernel());
  params::random_seed(1);
  params::visitor(std::ref(visitor));
  params::number_of_segments(2);
  params::vertex_point_map(mesh.points()).number_of_segments(2);
  params::from(CGAL::parameters::vertex_point_map(mesh.points())).number_of_segments(2);
  params::maximum_number_of_segments(2);
  params::minimum_segment_size(0.1);
  params::feature_weight(1);
  const std::vector<float>* vectors = nullptr;
  params::face_feature_map(vectors);
  const std::array<double, 3>* colors = nullptr;
  params::face_feature_map(colors);
  const int* labels = nullptr;
  params::face_feature_map(labels);
  params::salience_threshold(1);
  params::part_salience(Own_salience());
  params::salience_weights(0.1, 0.6, 0.3);
  params::distance_weights(0.1, 1, 0.1);
  params::number_of_reference_faces(3);
  params::number_of_coarse_faces(0);
  params::number_of_searches(1);
  params::number_of_smoothing_iterations(1);
  params::keep_components_separate(true);
  params::hierarchy(hierarchy);
  return params::zhang_liu_2005();
}

void with_a_pack_of_CGAL(const Mesh& mesh, Segment_ids ids,
                         CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy)
{
  const auto pack = CGAL::parameters::vertex_point_map(mesh.points()).random_seed(1);
  CGAL::segment_spectral_recursive(
    mesh, ids, CGAL::parameters::hierarchy(hierarchy).vertex_point_map(mesh.points()));
  CGAL::segment_spectral_recursive(
    mesh, ids, CGAL::parameters::combine(pack, CGAL::parameters::number_of_segments(2)));
  CGAL::segment_spectral_recursive(mesh, ids, CGAL::parameters::combine(
    CGAL::parameters::hierarchy(hierarchy).feature_weight(1), pack, params::random_seed(2)));
}

// A user's functions with the names of parameters are preferred to these.
namespace user {

struct Model {};

template <class T> Model number_of_segments(const T&);
template <class T> Model hierarchy(T&);
Model options(const Model&);
template <class T, class U> Model combine(const T&, const U&);

} // namespace user

void with_functions_of_the_same_names()
{
  using namespace user;
  using namespace CGAL::parameters;
  user::Model model;
  model = number_of_segments(5);
  model = hierarchy(model);
  model = options(model);
  model = combine(model, model);
}

std::size_t of_a_mesh(const Mesh& mesh, Segment_ids ids,
                      CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy)
{
  return CGAL::segment_spectral_recursive(mesh, ids) +
         CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
           mesh, ids, CGAL::parameters::random_seed(1)) +
         CGAL::segment_spectral_recursive(
           mesh, ids, params::from(CGAL::parameters::random_seed(1)).salience_threshold(0.3)) +
         CGAL::segment_spectral_recursive(mesh, ids, in_a_chain(mesh, hierarchy)) +
         hierarchy.write(mesh, ids, hierarchy.nodes(3)) +
         hierarchy.write(mesh, ids, hierarchy.nodes_above(0.9),
                         params::face_index_map(get(CGAL::face_index, mesh)));
}

std::size_t of_a_soup(const std::vector<std::array<double, 3> >& points,
                      const std::vector<std::array<int, 3> >& triangles, std::vector<int>& ids)
{
  const auto map = boost::make_iterator_property_map(
    ids.begin(), boost::typed_identity_property_map<std::size_t>());
  return CGAL::segment_spectral_recursive(points, triangles, map) +
         CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
           points, triangles, map, params::zhang_liu_2005().salience_threshold(0.3));
}
