// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SEGMENTATION_METHODS_H
#define SEGMENTATION_BENCHMARK_SEGMENTATION_METHODS_H

#include "run_engine.h"

#include <CGAL/mesh_segmentation.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// The methods that can be compared: a line here is a row in the tables.
namespace segmentation_benchmark {

namespace params = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

// Triangles that need not form a manifold.
struct Triangle_soup
{
  std::vector<Mesh::Point> points;
  std::vector<std::vector<std::size_t> > triangles; // three points each
};

// A method of this package, which cuts on down to a threshold or up to a number of segments.
struct Tree_method
{
  const char* name;
  double default_threshold;
  bool has_whole_trees; // whatever the threshold
  std::function<Segmentation_hierarchy(const Mesh&, double threshold,
                                       std::size_t maximum_number_of_segments)> segment;
  std::function<Segmentation_hierarchy(const Triangle_soup&, double threshold,
                                       std::size_t maximum_number_of_segments)>
    segment_soup = nullptr;
};

// A method that gives labels only.
struct Label_method
{
  const char* name;
  Labels (*segment)(const Mesh&);
};

template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class NamedParameters>
Segmentation_hierarchy hierarchy(const Mesh& mesh, const NamedParameters& np)
{
  Segmentation_hierarchy result;
  CGAL::segment_spectral_recursive<ConcurrencyTag>(
    mesh, boost::vector_property_map<std::size_t>(mesh.num_faces()), np.hierarchy(result));
  return result;
}

template <class NamedParameters>
Segmentation_hierarchy hierarchy(const Triangle_soup& soup, const NamedParameters& np)
{
  Segmentation_hierarchy result;
  CGAL::segment_spectral_recursive(
    soup.points, soup.triangles,
    boost::vector_property_map<std::size_t>(static_cast<unsigned>(soup.triangles.size())),
    np.hierarchy(result));
  return result;
}

// Makes a method of its named parameters, parameters(threshold, maximum_number_of_segments).
template <class Parameters>
Tree_method make_tree_method(const char* name, double default_threshold, bool has_whole_trees,
                             const Parameters& parameters)
{
  const auto segment = [parameters](const auto& input, double threshold, std::size_t n)
    { return hierarchy(input, parameters(threshold, n)); };
  return {name, default_threshold, has_whole_trees, segment, segment};
}

inline const std::vector<Tree_method>& tree_methods()
{
  static const std::vector<Tree_method> methods = {
    make_tree_method("calibrated", CGAL::Spectral_segmentation::default_probability_threshold, true,
                     [](double threshold, std::size_t n) {
                       return params::salience_threshold(threshold).maximum_number_of_segments(n);
                     }),
    make_tree_method("paper", CGAL::Spectral_segmentation::default_salience_threshold, false,
                     [](double threshold, std::size_t n) {
                       return params::zhang_liu_2005().salience_threshold(threshold)
                                .maximum_number_of_segments(n);
                     }),
  };
  return methods;
}

// Returns the tree method of this name, or a null pointer.
inline const Tree_method* tree_method(const std::string& name)
{
  for (const Tree_method& method : tree_methods())
    if (method.name == name)
      return &method;
  return nullptr;
}

// Returns the labels of CGAL's segmentation by shape diameter, by its defaults.
inline Labels segment_by_sdf(const Mesh& mesh)
{
  std::vector<double> values(mesh.number_of_faces());
  std::vector<std::size_t> ids(values.size());
  const auto index = get(CGAL::face_index, mesh);
  const auto value_map = boost::make_iterator_property_map(values.begin(), index);
  CGAL::sdf_values(mesh, value_map);
  CGAL::segmentation_from_sdf_values(mesh, value_map,
                                     boost::make_iterator_property_map(ids.begin(), index));
  return contiguous(ids);
}

inline const std::vector<Label_method>& label_methods()
{
  static const std::vector<Label_method> methods = {
    {"sdf", segment_by_sdf},
    {"one", [](const Mesh& mesh) { return Labels(mesh.number_of_faces(), 0); }},
  };
  return methods;
}

// The errors of each person with respect to the others.
constexpr const char* people_method = "people";

inline std::vector<std::string> method_names()
{
  std::vector<std::string> names;
  for (const Tree_method& method : tree_methods())
    names.push_back(method.name);
  for (const Label_method& method : label_methods())
    names.push_back(method.name);
  return names;
}

// No limit on the number of segments, and no threshold.
constexpr std::size_t any_number = (std::numeric_limits<std::size_t>::max)();
constexpr double any_salience = -std::numeric_limits<double>::infinity();

// Returns the labels of a method at its default threshold, if it has one.
inline Labels default_labels(const std::string& method_name, const Mesh& mesh)
{
  if (const Tree_method* method = tree_method(method_name))
    return labels_of_run(method->segment(mesh, method->default_threshold, any_number));
  for (const Label_method& method : label_methods())
    if (method.name == method_name)
      return method.segment(mesh);
  throw std::invalid_argument("there is no method " + method_name);
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SEGMENTATION_METHODS_H
