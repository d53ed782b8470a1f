// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_SEGMENTATION_METRICS_H
#define SEGMENTATION_BENCHMARK_SEGMENTATION_METRICS_H

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Core>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <vector>

// The Rand error and the cut discrepancy of X. Chen, A. Golovinskiy, T. Funkhouser, A Benchmark for
// 3D Mesh Segmentation, SIGGRAPH 2009, Section 4, as the program of the authors computes them. For
// both, 0 is best.
namespace segmentation_benchmark {

// One label for each face; labels are contiguous and start at 0.
typedef std::vector<std::size_t> Labels;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// The errors of one segmentation with respect to another.
struct Errors
{
  double rand_error = 0, cut_discrepancy = 0; // NaN is undefined
};

// The data of a mesh that the metrics need.
struct Mesh_facts
{
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                boost::property<boost::edge_weight_t, double> > Vertex_graph;
  struct Interior_edge
  {
    std::size_t vertices[2], faces[2];
  };

  std::vector<double> face_areas;
  double average_radius = 0; // mean distance of the surface from its centroid
  std::vector<Interior_edge> interior_edges;
  Vertex_graph vertex_graph; // weighted by length
};

template <class SurfaceMesh>
double average_radius(const SurfaceMesh& mesh, const std::vector<double>& face_areas)
{
  typedef Eigen::Vector3d Vector;
  std::vector<Vector> centers;
  Vector center = Vector::Zero();
  double area = 0;
  for (const auto f : mesh.faces()) {
    Vector sum = Vector::Zero();
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      sum += Vector(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    centers.push_back(sum / 3);
    center += face_areas[f] * centers.back();
    area += face_areas[f];
  }
  center /= area;
  double sum = 0;
  for (std::size_t f = 0; f < centers.size(); ++f)
    sum += face_areas[f] * (centers[f] - center).norm();
  return sum / area;
}

// Returns the facts of a CGAL::Surface_mesh without removed elements.
template <class SurfaceMesh>
Mesh_facts mesh_facts(const SurfaceMesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh_facts facts;
  for (const auto f : mesh.faces())
    facts.face_areas.push_back(PMP::face_area(f, mesh));
  facts.average_radius = average_radius(mesh, facts.face_areas);
  facts.vertex_graph = Mesh_facts::Vertex_graph(mesh.number_of_vertices());
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    const std::size_t source = mesh.source(h), target = mesh.target(h);
    boost::add_edge(source, target, PMP::edge_length(h, mesh), facts.vertex_graph);
    if (!mesh.is_border(e))
      facts.interior_edges.push_back(
        {{source, target}, {mesh.face(h), mesh.face(mesh.opposite(h))}});
  }
  return facts;
}

inline std::size_t number_of_segments(const Labels& labels)
{ return labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end()); }

// Numbers any labels from 0, in the order in which they appear.
template <class AnyLabels>
Labels contiguous(const AnyLabels& labels)
{
  std::unordered_map<typename AnyLabels::value_type, std::size_t> number;
  Labels result;
  for (const auto& label : labels)
    result.push_back(number.emplace(label, number.size()).first->second);
  return result;
}

// Returns how many faces each segment of a, in rows, and each segment of b, in columns, have in
// common.
inline Eigen::ArrayXXd overlap(const Labels& a, const Labels& b)
{
  Eigen::ArrayXXd table = Eigen::ArrayXXd::Zero(number_of_segments(a), number_of_segments(b));
  for (std::size_t f = 0; f < a.size(); ++f)
    ++table(a[f], b[f]);
  return table;
}

inline Eigen::ArrayXXd overlap(const Labels& a, const Labels& b,
                               const std::vector<double>& face_areas)
{
  Eigen::ArrayXXd table = Eigen::ArrayXXd::Zero(number_of_segments(a), number_of_segments(b));
  for (std::size_t f = 0; f < a.size(); ++f)
    table(a[f], b[f]) += face_areas[f];
  return table;
}

// Returns the fraction of the pairs of faces that one side joins and the other does not. The
// program of the authors counts n floor((n - 1) / 2) pairs among n faces.
inline double rand_error(const Eigen::ArrayXXd& faces)
{
  const auto ordered_pairs = [](const auto& counts) { return (counts * (counts - 1)).sum(); };
  const double n = faces.sum();
  return (ordered_pairs(faces.rowwise().sum()) + ordered_pairs(faces.colwise().sum()) -
          2 * ordered_pairs(faces)) / 2 / (n * std::floor((n - 1) / 2));
}

inline double rand_error(const Labels& a, const Labels& b)
{ return rand_error(overlap(a, b)); }

// Returns the fraction of pairs of points of the surface, whatever its triangles, that one side
// joins and the other does not.
inline double rand_error_by_area(const Eigen::ArrayXXd& area)
{
  const double total = area.sum();
  return (area.rowwise().sum().square().sum() + area.colwise().sum().square().sum() -
          2 * area.square().sum()) / (total * total);
}

// Returns the vertices along the cuts, each once.
inline std::vector<std::size_t> cut_vertices(const Mesh_facts& facts, const Labels& labels)
{
  std::vector<std::size_t> vertices;
  for (const Mesh_facts::Interior_edge& e : facts.interior_edges)
    if (labels[e.faces[0]] != labels[e.faces[1]])
      vertices.insert(vertices.end(), std::begin(e.vertices), std::end(e.vertices));
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Returns the distance of each vertex from the nearest cut, along edges; infinite if there is none.
inline std::vector<double> distances_from_cuts(const Mesh_facts& facts, const Labels& labels)
{
  const std::vector<std::size_t> sources = cut_vertices(facts, labels);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances(boost::num_vertices(facts.vertex_graph), infinity);
  if (!sources.empty())
    boost::dijkstra_shortest_paths(
      facts.vertex_graph, sources.begin(), sources.end(), boost::dummy_property_map(),
      boost::make_iterator_property_map(distances.begin(),
                                        boost::get(boost::vertex_index, facts.vertex_graph)),
      boost::get(boost::edge_weight, facts.vertex_graph),
      boost::get(boost::vertex_index, facts.vertex_graph), std::less<double>(),
      boost::closed_plus<double>(infinity), infinity, 0., boost::dijkstra_visitor<>());
  return distances;
}

// Returns the mean distance of the vertices of each side's cuts from the cuts of the other side, in
// units of the average radius. Undefined if a side has no cut, or none that can be reached.
inline double cut_discrepancy(const Mesh_facts& facts, const std::vector<double>& distances_a,
                              const std::vector<double>& distances_b)
{
  double sum = 0;
  std::size_t number = 0;
  const auto add = [&](double here, double other) {
    if (here == 0 && std::isfinite(other)) {
      sum += other;
      ++number;
    }
  };
  for (std::size_t v = 0; v < distances_a.size(); ++v) {
    add(distances_a[v], distances_b[v]);
    add(distances_b[v], distances_a[v]);
  }
  return number == 0 ? undefined : sum / static_cast<double>(number) / facts.average_radius;
}

// Labels, and their distances from cuts, which are used many times.
struct Segmentation
{
  Labels labels;
  std::vector<double> cut_distances;
};

inline Segmentation segmentation(const Mesh_facts& facts, const Labels& labels)
{ return {labels, distances_from_cuts(facts, labels)}; }

inline Errors errors(const Mesh_facts& facts, const Segmentation& result,
                     const Segmentation& reference)
{
  return {rand_error(result.labels, reference.labels),
          cut_discrepancy(facts, result.cut_distances, reference.cut_distances)};
}

// The mean of those values that are defined.
class Mean
{
  double sum_ = 0;
  std::size_t count_ = 0;

public:
  void add(double value)
  {
    if (!std::isnan(value)) {
      sum_ += value;
      ++count_;
    }
  }
  double operator()() const
  { return count_ == 0 ? undefined : sum_ / static_cast<double>(count_); }
};

inline double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle
                                : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

inline Errors mean_errors(const std::vector<Errors>& all)
{
  Mean rand_error, cut_discrepancy;
  for (const Errors& e : all) {
    rand_error.add(e.rand_error);
    cut_discrepancy.add(e.cut_discrepancy);
  }
  return {rand_error(), cut_discrepancy()};
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SEGMENTATION_METRICS_H
