// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_LABELS_H
#define SPECTRAL_SEGMENTATION_TEST_LABELS_H

#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Labels of the faces of a mesh, by the index of the face.
namespace test_meshes {

typedef std::vector<std::size_t> Labels;

// The value of a label before it is written.
constexpr std::size_t untouched = 1234567;

inline auto map_to(Labels& labels, const Mesh& mesh)
{
  labels.assign(num_faces(mesh), untouched);
  return boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh));
}

inline std::size_t number_of(const Labels& labels)
{ return labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end()); }

template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class NamedParameters>
Labels labels_of(const Mesh& mesh, const NamedParameters& np)
{
  Labels labels;
  const std::size_t n =
    CGAL::segment_spectral_recursive<ConcurrencyTag>(mesh, map_to(labels, mesh), np);
  BOOST_TEST(n == number_of(labels));
  return labels;
}

template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class NamedParameters>
Labels labels_of(const Soup& soup, const NamedParameters& np)
{ return labels_of<ConcurrencyTag>(mesh_of(soup), np); }

// Checks that a run throws an exception whose text has the message, and writes nothing.
template <class NamedParameters>
void check_refused(const Mesh& mesh, const NamedParameters& np, const std::string& message = "")
{
  BOOST_TEST_CONTEXT(message) {
    Labels labels;
    const auto map = map_to(labels, mesh);
    BOOST_CHECK_EXCEPTION(
      CGAL::segment_spectral_recursive(mesh, map, np), std::invalid_argument,
      [&](const std::invalid_argument& e)
      { return std::string(e.what()).find(message) != std::string::npos; });
    BOOST_TEST(labels == Labels(num_faces(mesh), untouched), boost::test_tools::per_element());
  }
}

template <class NamedParameters>
CGAL::Spectral_segmentation::Segmentation_hierarchy hierarchy_of(const Mesh& mesh,
                                                                 const NamedParameters& np)
{
  CGAL::Spectral_segmentation::Segmentation_hierarchy result;
  labels_of(mesh, np.hierarchy(result));
  return result;
}

// Calls f with the named parameters of either method.
template <class Function>
void for_both_methods(const Function& f)
{
  namespace parameters = CGAL::Spectral_segmentation::parameters;
  BOOST_TEST_CONTEXT("default method") { f(parameters::number_of_searches(2)); } // 5 take longer
  BOOST_TEST_CONTEXT("method of the paper") { f(parameters::zhang_liu_2005()); }
}

// The sets of faces of equal label that are connected across edges. `for_each_neighbor(f, visit)`
// calls visit(g) for the neighbors of a face.
template <class ForEachNeighbor>
std::size_t number_of_connected_pieces(const Labels& labels,
                                       const ForEachNeighbor& for_each_neighbor)
{
  std::vector<char> is_reached(labels.size(), 0);
  std::size_t result = 0;
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (is_reached[seed])
      continue;
    ++result;
    std::vector<std::size_t> front(1, seed);
    is_reached[seed] = 1;
    while (!front.empty()) {
      const std::size_t f = front.back();
      front.pop_back();
      for_each_neighbor(f, [&](std::size_t g) {
        if (!is_reached[g] && labels[g] == labels[f]) {
          is_reached[g] = 1;
          front.push_back(g);
        }
      });
    }
  }
  return result;
}

inline std::size_t number_of_connected_pieces(const Mesh& mesh, const Labels& labels)
{
  return number_of_connected_pieces(
    labels, [&mesh](std::size_t f, const std::function<void(std::size_t)>& visit) {
      const Mesh::Halfedge_index start = mesh.halfedge(Mesh::Face_index(Mesh::size_type(f)));
      for (Mesh::Halfedge_index h : {start, mesh.next(start), mesh.prev(start)})
        if (!mesh.is_border(mesh.opposite(h)))
          visit(mesh.face(mesh.opposite(h)));
    });
}

// Returns the labels that a run assigned.
inline Labels run_labels(const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy)
{ return hierarchy.labels(hierarchy.nodes()); }

inline Labels labels_of_number(const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                               std::size_t n)
{ return hierarchy.labels(hierarchy.nodes(n)); }

inline Labels labels_above(const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                           double threshold, std::size_t maximum_number)
{ return hierarchy.labels(hierarchy.nodes_above(threshold, maximum_number)); }

// Checks that labels are contiguous and numbered by their first face.
inline void check_numbering(const Labels& labels)
{
  std::size_t next = 0;
  for (std::size_t label : labels) {
    BOOST_TEST_REQUIRE(label <= next);
    next += label == next;
  }
}

// And every segment of a connected mesh is connected. Returns the number of segments.
inline std::size_t check_labels(const Mesh& mesh, const Labels& labels)
{
  BOOST_TEST_REQUIRE(labels.size() == num_faces(mesh));
  check_numbering(labels);
  if (number_of_connected_pieces(mesh, Labels(labels.size(), 0)) == 1)
    BOOST_TEST(number_of_connected_pieces(mesh, labels) == number_of(labels));
  return number_of(labels);
}

// Returns the fraction of the pairs of faces that both segmentations join or both separate.
inline double rand_index(const Labels& a, const Labels& b)
{
  std::map<std::pair<std::size_t, std::size_t>, double> in_both;
  std::map<std::size_t, double> in_a, in_b;
  for (std::size_t f = 0; f < a.size(); ++f) {
    ++in_a[a[f]];
    ++in_b[b[f]];
    ++in_both[{a[f], b[f]}];
  }
  const auto pairs = [](double n) { return n * (n - 1) / 2; };
  const auto joined_pairs = [&](const auto& sizes) {
    double sum = 0;
    for (const auto& entry : sizes)
      sum += pairs(entry.second);
    return sum;
  };
  const double all = pairs(double(a.size()));
  return (all + 2 * joined_pairs(in_both) - joined_pairs(in_a) - joined_pairs(in_b)) / all;
}

} // namespace test_meshes

#endif // SPECTRAL_SEGMENTATION_TEST_LABELS_H
