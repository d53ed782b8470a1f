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
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

// The metrics of X. Chen, A. Golovinskiy, T. Funkhouser, A Benchmark for 3D Mesh Segmentation,
// SIGGRAPH 2009, Section 4, as the program of the authors computes them. All are errors: 0 is best.
namespace segmentation_benchmark {

// One label for each face; labels are contiguous and start at 0.
typedef std::vector<std::size_t> Labels;

enum Metric {
  RAND_ERROR, HAMMING, MISSING_RATE, FALSE_ALARM_RATE, // the last three by area
  GCE, LCE,                                            // global, local consistency error by area
  GCE_FACES, LCE_FACES,                                // the same by number of faces
  CUT_DISCREPANCY,
  NUMBER_OF_METRICS
};

constexpr std::array<const char*, NUMBER_OF_METRICS> metric_names =
  {"ri", "hd", "rm", "rf", "gce", "lce", "gcef", "lcef", "cd"};

// The errors of one segmentation with respect to another, by Metric. NaN is undefined.
typedef std::array<double, NUMBER_OF_METRICS> Errors;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

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

// The facts of a CGAL::Surface_mesh without removed elements.
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

// How much the segments of two segmentations, in rows and columns, have in common.
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

// The share of the pairs of faces that one side joins and the other does not. The program of the
// authors counts n floor((n - 1) / 2) pairs among n faces.
inline double rand_error(const Eigen::ArrayXXd& faces)
{
  const auto ordered_pairs = [](const auto& counts) { return (counts * (counts - 1)).sum(); };
  const double n = faces.sum();
  return (ordered_pairs(faces.rowwise().sum()) + ordered_pairs(faces.colwise().sum()) -
          2 * ordered_pairs(faces)) / 2 / (n * std::floor((n - 1) / 2));
}

inline double rand_error(const Labels& a, const Labels& b)
{ return rand_error(overlap(a, b)); }

// The same of pairs of points of the surface, whatever its triangles; no metric of the benchmark.
inline double rand_error_by_area(const Eigen::ArrayXXd& area)
{
  const double total = area.sum();
  return (area.rowwise().sum().square().sum() + area.colwise().sum().square().sum() -
          2 * area.square().sum()) / (total * total);
}

// Returns, for the segment of each column, the greatest intersection over union with one of a row.
inline Eigen::ArrayXd greatest_overlaps(const Eigen::ArrayXXd& area)
{
  const Eigen::ArrayXd of_rows = area.rowwise().sum(), of_columns = area.colwise().sum();
  Eigen::ArrayXd result(area.cols());
  for (Eigen::Index column = 0; column < area.cols(); ++column)
    result(column) =
      (area.col(column) / (of_rows + of_columns(column) - area.col(column))).maxCoeff();
  return result;
}

inline void set_hamming_errors(const Eigen::ArrayXXd& area, Errors& errors)
{
  const double total = area.sum();
  errors[MISSING_RATE] = (std::max)(0., 1 - area.colwise().maxCoeff().sum() / total);
  errors[FALSE_ALARM_RATE] = (std::max)(0., 1 - area.rowwise().maxCoeff().sum() / total);
  errors[HAMMING] = (errors[MISSING_RATE] + errors[FALSE_ALARM_RATE]) / 2;
}

// The global and the local consistency error. The share of a face's segment that the other
// segmentation puts elsewhere is measured by `size`, and averaged over the faces.
inline std::pair<double, double> consistency_errors(const Eigen::ArrayXXd& faces,
                                                    const Eigen::ArrayXXd& size)
{
  const Eigen::ArrayXd in_a = size.rowwise().sum(), in_b = size.colwise().sum();
  double of_a = 0, of_b = 0, local = 0;
  const auto share_elsewhere = [](double common, double all)
  { return all > 0 ? 1 - common / all : 0; };
  for (Eigen::Index a = 0; a < size.rows(); ++a)
    for (Eigen::Index b = 0; b < size.cols(); ++b) {
      const double error_a = share_elsewhere(size(a, b), in_a(a));
      const double error_b = share_elsewhere(size(a, b), in_b(b));
      of_a += faces(a, b) * error_a;
      of_b += faces(a, b) * error_b;
      local += faces(a, b) * (std::min)(error_a, error_b);
    }
  const double n = faces.sum();
  return {(std::min)(of_a, of_b) / n, local / n};
}

inline void set_consistency_errors(const Eigen::ArrayXXd& faces, const Eigen::ArrayXXd& area,
                                   Errors& errors)
{
  // With one segment in all, or one a face, each segmentation refines the other.
  const auto is_trivial = [n = faces.sum()](Eigen::Index segments)
  { return segments == 1 || static_cast<double>(segments) == n; };
  if (is_trivial(faces.rows()) || is_trivial(faces.cols())) {
    errors[GCE] = errors[LCE] = errors[GCE_FACES] = errors[LCE_FACES] = 0;
    return;
  }
  std::tie(errors[GCE], errors[LCE]) = consistency_errors(faces, area);
  std::tie(errors[GCE_FACES], errors[LCE_FACES]) = consistency_errors(faces, faces);
}

// The vertices along the cuts, each once.
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

// The distance of each vertex from the nearest cut, along edges; infinite where there is none.
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

// The mean distance of the vertices of each side's cuts from the cuts of the other, in units of the
// average radius. Undefined where a side has no cut, or none that can be reached.
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
  const Eigen::ArrayXXd faces = overlap(result.labels, reference.labels);
  const Eigen::ArrayXXd area = overlap(result.labels, reference.labels, facts.face_areas);
  Errors e;
  e[RAND_ERROR] = rand_error(faces);
  set_hamming_errors(area, e);
  set_consistency_errors(faces, area, e);
  e[CUT_DISCREPANCY] = cut_discrepancy(facts, result.cut_distances, reference.cut_distances);
  return e;
}

// The mean of the values that are defined.
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

template <class ErrorsRange>
Errors mean_errors(const ErrorsRange& all)
{
  Errors result;
  for (std::size_t metric = 0; metric < NUMBER_OF_METRICS; ++metric) {
    Mean mean;
    for (const Errors& e : all)
      mean.add(e[metric]);
    result[metric] = mean();
  }
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_SEGMENTATION_METRICS_H
