// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_SHORTEST_PATHS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_SHORTEST_PATHS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/two_bit_color_map.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The distance of unreachable faces.
constexpr double infinite_distance = std::numeric_limits<double>::infinity();

// Runs BGL's Dijkstra on the dual graph of a part, from all `sources` at once. `distance` holds the
// distances at which the sources start, and infinity for all other faces; `weight(h)` is the length
// of the step across the halfedge h.
template <class Weight, class Visitor>
void run_dijkstra(const Surface& part, const std::vector<Index>& sources, const Weight& weight,
                  std::vector<double>& distance, const Visitor& visitor)
{
  const boost::typed_identity_property_map<Index> index;
  boost::dijkstra_shortest_paths_no_init(
    part, sources.begin(), sources.end(), boost::dummy_property_map(),
    boost::make_iterator_property_map(distance.begin(), index),
    boost::make_function_property_map<Index, double>(weight), index, std::less<double>(),
    std::plus<double>(), 0., visitor, boost::make_two_bit_color_map(part.number_of_faces(), index));
}

// One of the three weightings of Section 3: geodesic, angle or combined.
typedef float Edge_weights::* Weighting;

// Returns the distances of all faces from `source`.
inline std::vector<double> shortest_paths(const Surface& part, Weighting weighting, Index source)
{
  std::vector<double> distance(part.number_of_faces(), infinite_distance);
  distance[source] = 0;
  run_dijkstra(part, {source}, [&](Index h) -> double { return part.weights[h].*weighting; },
               distance, boost::dijkstra_visitor<>());
  return distance;
}

struct Geodesic_paths
{
  std::vector<double> lengths;
  std::vector<float> angles;    // the sums of the angle distances along the paths
  std::vector<Index> previous;  // faces; the source itself, and unreachable faces, have none
};

// Sums the angle distances along shortest geodesic paths. Ties between paths to a face go to the
// path over the nearest neighbor, then over the first, so that the sum does not depend on the order
// in which Dijkstra visits equal faces, unless a step has no length.
class Angle_visitor : public boost::dijkstra_visitor<>
{
  Geodesic_paths* paths_;

public:
  explicit Angle_visitor(Geodesic_paths& paths) : paths_(&paths) {}

  void edge_relaxed(Index h, const Surface& part) const
  {
    const Index f = source(h, part), g = target(h, part);
    paths_->previous[g] = f;
    paths_->angles[g] = paths_->angles[f] + part.weights[h].angle;
  }

  void edge_not_relaxed(Index h, const Surface& part) const
  {
    const Index f = source(h, part), g = target(h, part), rival = paths_->previous[g];
    const double weight = part.weights[h].geodesic;
    if (weight > 0 && f < rival && rival != null_index &&
        paths_->lengths[f] == paths_->lengths[rival] &&
        paths_->lengths[f] + weight == paths_->lengths[g])
      edge_relaxed(h, part);
  }
};

// Returns the shortest geodesic paths from `source` to all faces.
inline Geodesic_paths geodesic_paths(const Surface& part, Index source)
{
  const std::size_t n = part.number_of_faces();
  Geodesic_paths paths{std::vector<double>(n, infinite_distance), std::vector<float>(n, 0),
                       std::vector<Index>(n, null_index)};
  paths.lengths[source] = 0;
  run_dijkstra(part, {source}, [&](Index h) -> double { return part.weights[h].geodesic; },
               paths.lengths, Angle_visitor(paths));
  return paths;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_WEIGHTS_SHORTEST_PATHS_H
