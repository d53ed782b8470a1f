// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_METHOD_FIGURES_H
#define MANUAL_FIGURES_METHOD_FIGURES_H

#include "../../benchmark/paper_experiments/face_samples.h"
#include "../../benchmark/run_engine.h"
#include "Picture_book.h"
#include "segmentations.h"

#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/nystrom_embedding.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>
#include <CGAL/Spectral_segmentation/internal/surface/Moments.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <CGAL/Kernel/global_functions.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The figures that show how the method of the paper works, by internal functions of the library.
namespace manual_figures {

namespace internal = CGAL::Spectral_segmentation::internal;
using segmentation_benchmark::Edge_weights;
using segmentation_benchmark::Execution;
using segmentation_benchmark::Surface;
using segmentation_benchmark::Index;
using segmentation_benchmark::paper_graph;

constexpr Rgb white = {245, 245, 245}, light = {205, 205, 205}, dark = {120, 120, 120},
              red = {200, 30, 30}, blue = {40, 90, 200}, orange = {250, 150, 20};

inline Kernel::Point_3 centroid(const Mesh& mesh, Index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(f));
  return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
}

inline Kernel::Point_3 point(const Mesh& mesh, Index v)
{ return mesh.point(Mesh::Vertex_index(v)); }

// Returns a mix of two colors, with the given fraction of b.
inline Rgb mixed(const Rgb& a, const Rgb& b, double fraction)
{
  Rgb result;
  for (int i = 0; i < 3; ++i)
    result[i] = static_cast<std::uint8_t>(std::lround(a[i] + fraction * (b[i] - a[i])));
  return result;
}

inline Rgb blue_white_red(double x)
{ return x < 0.5 ? mixed(blue, white, 2 * x) : mixed(white, red, 2 * x - 1); }

// Draws the dual graph of a small mesh: edges by the sign of their angle, arcs by their weight.
inline void draw_dual_graph(Picture_book& book, const Named_mesh& shape)
{
  const Surface graph = paper_graph(shape.mesh);
  Picture edges{shape, "edges of the mesh: concave in red, convex in blue",
                std::vector<Rgb>(graph.number_of_faces(), white)};
  Picture arcs{shape, "arcs of the dual graph: the darker and thicker, the longer",
               std::vector<Rgb>(graph.number_of_faces(), white)};
  for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
    if (graph.is_border(h) || h > graph.opposite[h])
      continue;
    const Edge_weights& e = graph.weights[h];
    const Kernel::Point_3 a = point(shape.mesh, graph.source_vertex(h)),
                          b = point(shape.mesh, graph.target_vertex(h));
    const bool is_concave = e.concavity > 0;
    edges.add_tube(a, b, is_concave ? red : blue, is_concave ? 1.5 : 0.7);
    const Rgb color = mixed({190, 190, 190}, is_concave ? red : Rgb{0, 0, 0}, e.combined);
    const Kernel::Point_3 middle = CGAL::midpoint(a, b);
    for (Index f : {h / 3, graph.neighbor(h)})
      arcs.add_tube(centroid(shape.mesh, f), middle, color, 0.4 + 1.6 * e.combined);
  }
  book.add("face_graph", edges);
  book.add("face_graph", arcs);
}

// Returns each face's context as a color: its three principal components are red, green and blue.
inline std::vector<Rgb> context_colors(const internal::Shape_contexts& contexts)
{
  Eigen::MatrixXd vectors = contexts.values.transpose().cast<double>();
  vectors.colwise() -= vectors.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(vectors * vectors.transpose());
  Eigen::MatrixXd components = solver.eigenvectors().rightCols(3).transpose() * vectors;
  std::vector<Rgb> colors(vectors.cols());
  for (int i = 0; i < 3; ++i) {
    const double smallest = components.row(i).minCoeff(), largest = components.row(i).maxCoeff();
    for (Eigen::Index f = 0; f < vectors.cols(); ++f)
      colors[f][i] = static_cast<std::uint8_t>(
        40 + 200 * (components(i, f) - smallest) / (largest - smallest));
  }
  return colors;
}

inline std::vector<Rgb> context_norm_colors(const internal::Shape_contexts& contexts)
{
  std::vector<double> norms;
  for (Eigen::Index f = 0; f < contexts.values.rows(); ++f)
    norms.push_back(contexts.values.row(f).norm());
  const auto [smallest, largest] = std::minmax_element(norms.begin(), norms.end());
  std::vector<Rgb> colors;
  for (double norm : norms)
    colors.push_back(blue_white_red((norm - *smallest) / (*largest - *smallest)));
  return colors;
}

inline void add_samples(Picture& picture, const internal::Sample_faces& samples)
{
  picture.add_ball(centroid(picture.shape.mesh, samples.s), red);
  picture.add_ball(centroid(picture.shape.mesh, samples.t), orange);
}

inline internal::Shape_contexts contexts_of(const Surface& graph)
{
  return internal::shape_contexts(
    graph, internal::farthest_face_from_center(Execution::SEQUENTIAL, graph),
    Engine_options::zhang_liu_2005().number_of_reference_faces, [] {});
}

inline void draw_contexts(Picture_book& book, const Named_mesh& shape)
{
  const Surface graph = paper_graph(shape.mesh);
  const internal::Shape_contexts contexts = contexts_of(graph);
  Picture colors{shape, "reference faces, and contexts: like colors are like contexts",
                 context_colors(contexts)};
  for (Index reference : contexts.references)
    colors.add_ball(centroid(shape.mesh, reference), {0, 0, 0});
  book.add("contexts", colors);
  Picture norms{shape, "norm of the context, from blue to red, and the two samples",
                context_norm_colors(contexts)};
  add_samples(norms, internal::sample_faces(Execution::SEQUENTIAL, contexts));
  book.add("contexts", norms);
}

// Returns colors from blue to red by the rank of each face on the spectral line.
inline std::vector<Rgb> rank_colors(const Surface& graph, const std::vector<Index>& samples)
{
  const Eigen::VectorXd z =
    internal::spectral_coordinates(internal::face_eigenpairs(graph, samples), samples);
  std::vector<Index> line(graph.number_of_faces());
  std::iota(line.begin(), line.end(), Index(0));
  std::sort(line.begin(), line.end(), [&](Index f, Index g) { return z[f] < z[g]; });
  std::vector<Rgb> colors(line.size());
  for (std::size_t i = 0; i < line.size(); ++i)
    colors[line[i]] = blue_white_red(static_cast<double>(i) / static_cast<double>(line.size()));
  return colors;
}

inline void draw_embedding(Picture_book& book, const Named_mesh& shape)
{
  const Surface graph = paper_graph(shape.mesh);
  const internal::Sample_faces two =
    internal::sample_faces(Execution::SEQUENTIAL, contexts_of(graph));
  Picture with_two{shape, "two samples, by shape context", rank_colors(graph, {two.s, two.t})};
  add_samples(with_two, two);
  book.add("embedding", with_two);
  const std::vector<Index> samples = segmentation_benchmark::farthest_first(
    graph.number_of_faces(), two.s, 100,
    [&](Index f) { return internal::shortest_paths(graph, &Edge_weights::combined, f); });
  book.add("embedding", Picture{shape, "100 samples", rank_colors(graph, samples)});
}

// The line of two samples, and the cuts along it.
struct Searched_line
{
  internal::Sample_faces samples;
  std::vector<double> from_s, from_t;
  std::vector<Index> order;
  std::optional<internal::Cut> best;
  Json steps = Json::array();

  static std::vector<double> distances(const Surface& graph, Index source)
  { return internal::shortest_paths(graph, &Edge_weights::combined, source); }

  Searched_line(const Surface& graph, const internal::Sample_faces& given)
    : samples(given),
      from_s(distances(graph, samples.s)),
      from_t(distances(graph, samples.t)),
      order(internal::spectral_order(from_s, from_t))
  {
    const Engine_options options = Engine_options::zhang_liu_2005();
    const double minimum_area = options.minimum_segment_size * internal::total_area(graph);
    best = internal::line_search(Execution::SEQUENTIAL, graph, order, options.part_salience,
                                 minimum_area);
    const internal::Growth growth = internal::grow_along(graph, order);
    internal::for_each_cut(
      growth.faces, internal::sizes_of_cuts(graph, growth), minimum_area,
      internal::Patch(graph),
      [&](const internal::Patch& q, std::size_t size) {
        const CGAL::Spectral_segmentation::Salience_factors f = q.factors();
        steps.push_back({size, f.size, f.cut_strength, f.protrusiveness,
                         options.part_salience(f)});
        return true;
      });
  }
};

inline void add_cut(Picture& picture, const Surface& graph, const internal::Cut& cut)
{
  const Mesh& mesh = picture.shape.mesh;
  for (Index h = 0; h < graph.number_of_halfedges(); ++h)
    if (cut.side[h / 3] == 0 && cut.side[graph.neighbor(h)] == 1)
      picture.add_tube(point(mesh, graph.source_vertex(h)), point(mesh, graph.target_vertex(h)),
                       red, 3);
}

// Draws the regions of two samples and the best cut along their line, like Figure 1 of the paper.
inline void draw_regions(Picture_book& book, const std::string& figure, const Named_mesh& shape,
                         const Surface& graph, const Searched_line& line,
                         const std::string& caption)
{
  std::vector<Rgb> colors;
  for (Index f = 0; f < graph.number_of_faces(); ++f)
    colors.push_back(line.from_s[f] < line.from_t[f] ? dark : light);
  char salience[20];
  std::snprintf(salience, sizeof salience, "%.2f", line.best->salience);
  Picture picture{shape, caption + ": salience of the best cut " + salience, colors};
  add_samples(picture, line.samples);
  add_cut(picture, graph, *line.best);
  book.add(figure, picture);
}

// Returns the face nearest to a point.
inline Index face_at(const Mesh& mesh, const Kernel::Point_3& place)
{
  Index best = 0;
  for (Index f = 1; f < mesh.number_of_faces(); ++f)
    if (CGAL::compare_distance_to_point(place, centroid(mesh, f), centroid(mesh, best)) ==
        CGAL::SMALLER)
      best = f;
  return best;
}

// Draws samples by shape context and samples in one part, each with the best cut, and the line of
// the first. `same_part` holds two points on one part of the shape.
inline void draw_samples_and_line(Picture_book& book, const Named_mesh& shape,
                                  const std::array<Kernel::Point_3, 2>& same_part)
{
  const Surface graph = paper_graph(shape.mesh);
  const Searched_line good(graph,
                           internal::sample_faces(Execution::SEQUENTIAL, contexts_of(graph)));
  const Searched_line bad(graph, {face_at(shape.mesh, same_part[0]),
                                  face_at(shape.mesh, same_part[1])});
  draw_regions(book, "samples", shape, graph, good, "(a) samples by shape context");
  draw_regions(book, "samples", shape, graph, bad, "(b) two samples in one part");

  std::vector<Rgb> rank(graph.number_of_faces());
  for (std::size_t i = 0; i < good.order.size(); ++i)
    rank[good.order[i]] = blue_white_red(static_cast<double>(i) / (good.order.size() - 1));
  Picture order{shape, "order of the faces on the line, from blue to red", rank};
  add_cut(order, graph, *good.best);
  book.add("line", order);
  std::vector<Rgb> sides;
  for (char side : good.best->side)
    sides.push_back(side == 0 ? orange : light);
  book.add("line", {shape, "best cut: Q in orange, the rest in grey", sides});
  book.add_chart("line_search", {{"good", good.steps}, {"bad", bad.steps},
                                 {"number_of_faces", graph.number_of_faces()},
                                 {"threshold",
                                  CGAL::Spectral_segmentation::default_salience_threshold}});
}

// Draws the tree of cuts, and its segments for some numbers of segments.
inline void draw_tree(Picture_book& book, const Named_mesh& shape)
{
  const Segmentation_hierarchy tree = hierarchy(shape.mesh, Engine_options());
  Row_colors colors;
  const Labels regions = tree.labels(tree.nodes(tree.number_of_segments()));
  for (std::size_t n : {2, 4, 8})
    add_segments(book, "tree", shape, colors, tree.labels(tree.nodes(n)),
                 "nodes(" + std::to_string(n) + ")");
  const std::vector<Rgb> region_colors = colors(regions);
  book.add("tree",
           {shape, "all leaves: " + count(tree.number_of_segments(), "regions"), region_colors});

  Json nodes = Json::array();
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& node = tree.node(i);
    Json entry = {{"salience", node.salience}, {"color", region_colors[*tree.faces(i).begin()]}};
    if (!node.is_leaf())
      entry["children"] = {node.children[0], node.children[1]};
    nodes.push_back(std::move(entry));
  }
  book.add_chart("tree", {{"nodes", std::move(nodes)}, {"threshold", tree.salience_threshold()}});
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_METHOD_FIGURES_H
