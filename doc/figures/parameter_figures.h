// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_PARAMETER_FIGURES_H
#define MANUAL_FIGURES_PARAMETER_FIGURES_H

#include "Picture_book.h"
#include "segmentations.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/random_perturbation.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>
#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// Rows of pictures: one mesh, one parameter, some values; and the same with methods.
namespace manual_figures {

template <class Value>
std::string caption_of(const char* parameter, const Value& value, const Value& default_value)
{
  std::ostringstream out;
  out << std::boolalpha << parameter << ' ' << value;
  if (value == default_value)
    out << " (default)";
  return out.str();
}

// Draws a row of runs of `method` with several values of `member`, whose default is the method's.
template <class Class, class Value>
void draw_row(Picture_book& book, const char* parameter, Value Class::*member,
              const Engine_options& method, const Named_mesh& shape,
              const std::vector<Value>& values)
{
  Row_colors colors;
  for (const Value& value : values) {
    Engine_options options = method;
    options.*member = value;
    add_segments(book, parameter, shape, colors, segment(shape.mesh, options),
                 caption_of(parameter, value, method.*member));
  }
}

// Moves each coordinate of a vertex by at most `fraction` of the bounding box diagonal.
inline Named_mesh noisy(const Named_mesh& shape, double fraction)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Named_mesh result = shape;
  const CGAL::Bbox_3 box = PMP::bbox(shape.mesh);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  PMP::random_perturbation(result.mesh, fraction * diagonal,
                           CGAL::parameters::do_project(false).random_seed(0));
  return result;
}

// Draws the rows of thresholds, which are read off one tree, and of numbers.
inline void draw_thresholds_and_numbers(Picture_book& book, const Named_mesh& shape)
{
  const Segmentation_hierarchy tree = hierarchy(shape.mesh, Engine_options());
  Row_colors colors;
  for (double threshold : {0.9, 0.6, tree.salience_threshold(), 0.1})
    add_segments(book, "salience_threshold", shape, colors, labels_of_tree(tree, threshold),
                 caption_of("salience_threshold", threshold, tree.salience_threshold()));
  colors = Row_colors();
  for (std::size_t n : {2, 5, 10, 20}) {
    Engine_options o;
    o.number_of_segments = n; // the tree may have fewer leaves
    add_segments(book, "number_of_segments", shape, colors, segment(shape.mesh, o),
                 "number_of_segments " + std::to_string(n));
  }
}

// Draws several segmentations of a model of many components.
inline void draw_components(Picture_book& book, const Named_mesh& shape)
{
  Row_colors colors;
  const Segmentation_hierarchy tree = hierarchy(shape.mesh, Engine_options());
  add_segments(book, "components", shape, colors, labels_of_run(tree), "default");
  add_segments(book, "components", shape, colors, tree.labels(tree.nodes(6)),
               "number_of_segments 6");
  add_segments(book, "components", shape, colors, labels_of_tree(tree, 0.25),
               "salience_threshold 0.25");
  Engine_options separate;
  separate.keep_components_separate = true;
  add_segments(book, "components", shape, colors, segment(shape.mesh, separate),
               "keep_components_separate true");
}

inline double extent(const CGAL::Bbox_3& box)
{ return (std::max)({box.x_span(), box.y_span(), box.z_span()}); }

// Returns a mesh, whose up axis is y, with a pack at each side and a ball beside it.
inline Named_mesh with_equipment(const Named_mesh& shape)
{
  Named_mesh result = shape;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(shape.mesh);
  const double size = extent(box), width = (std::min)(box.x_span(), box.z_span());
  const Kernel::Vector_3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Kernel::Vector_3 right = box.x_span() < box.z_span() ? x : z,
                         front = box.x_span() < box.z_span() ? z : x;
  const Kernel::Point_3 center((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                               (box.zmin() + box.zmax()) / 2);
  Mesh ball;
  CGAL::make_icosahedron(ball, center + (width / 2 + 0.25 * size) * right -
                                 (box.y_span() / 2 - 0.09 * size) * y, 0.09 * size);
  result.mesh += ball;
  for (double side : {-1, 1}) {
    const Kernel::Vector_3 a = 0.2 * size * front, b = 0.16 * size * y, c = 0.1 * size * right;
    const Kernel::Point_3 p = center + side * 0.5 * width * right + 0.05 * size * y -
                              (a + b + c) / 2;
    Mesh pack;
    CGAL::make_hexahedron(p, p + a, p + a + b, p + b, p + b + c, p + c, p + a + c, p + a + b + c,
                          pack);
    CGAL::Polygon_mesh_processing::triangulate_faces(pack);
    result.mesh += pack;
  }
  return result;
}

// Returns a mesh with an inner wall, which points inward, `depth` below it.
inline Named_mesh hollow(const Named_mesh& shape, double depth)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh inner = shape.mesh;
  auto normals = inner.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  PMP::compute_vertex_normals(inner, normals);
  for (Mesh::Vertex_index v : inner.vertices())
    inner.point(v) = inner.point(v) - depth * normals[v];
  inner.remove_property_map(normals);
  PMP::reverse_face_orientations(inner);
  Named_mesh result = shape;
  result.mesh += inner;
  return result;
}

// Draws models of several components: one with equipment, and one half of a hollow body.
inline void draw_equipment(Picture_book& book, const Named_mesh& carrier, const Named_mesh& body)
{
  Row_colors colors;
  const Named_mesh loaded = with_equipment(carrier);
  add_segments(book, "equipment", loaded, colors, segment(loaded.mesh, Engine_options()),
               "with equipment");
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(body.mesh);
  const Named_mesh print = hollow(body, 0.01 * extent(box));
  const Labels labels = segment(print.mesh, Engine_options());
  Named_mesh half = {body.name, Mesh()};
  Labels labels_of_half;
  for (Mesh::Face_index f : print.mesh.faces()) {
    std::vector<Mesh::Vertex_index> corners;
    for (Mesh::Vertex_index v : print.mesh.vertices_around_face(print.mesh.halfedge(f)))
      corners.push_back(half.mesh.add_vertex(print.mesh.point(v)));
    if (half.mesh.point(corners[0]).z() < (box.zmin() + box.zmax()) / 2) {
      half.mesh.add_face(corners);
      labels_of_half.push_back(labels[f]);
    }
  }
  colors = Row_colors();
  add_segments(book, "equipment", half, colors, labels_of_half, "one half of a hollow body");
}

// Draws the camel by default and with seeds, which cut off its hind legs alike.
inline void draw_seeds(Picture_book& book, const Named_mesh& camel)
{
  const Named_mesh shape = {"camel from behind", camel.mesh};
  std::vector<int> seeds(shape.mesh.number_of_faces(), -1);
  seeds[2328] = seeds[2829] = 0;  // a hind leg and its thigh
  seeds[15684] = seeds[7714] = 1; // the other hind leg
  seeds[224] = 2;                 // the rump
  Labels labels(seeds.size());
  CGAL::segment_spectral_recursive(
    shape.mesh, CGAL::make_property_map(labels),
    CGAL::parameters::face_seed_map(CGAL::make_property_map(seeds)));
  Row_colors colors;
  add_segments(book, "seeds", shape, colors, segment(shape.mesh, Engine_options()), "default");
  add_segments(book, "seeds", shape, colors, labels, "with seeds");
}

inline void draw_parameters(Picture_book& book, const Named_mesh& limbs, const Named_mesh& coarse,
                            const Named_mesh& fine)
{
  const Engine_options calibrated = Engine_options(), paper = Engine_options::zhang_liu_2005();
  draw_thresholds_and_numbers(book, limbs);
  draw_row(book, "minimum_segment_size", &Engine_options::minimum_segment_size, calibrated, fine,
           {0.0, calibrated.minimum_segment_size, 0.02, 0.1});
  draw_row(book, "number_of_coarse_faces", &Engine_options::number_of_coarse_faces, calibrated,
           fine, {500, 1500, calibrated.number_of_coarse_faces, 0});
  const Named_mesh noise = noisy(coarse, 0.004);
  draw_row(book, "radius", &Engine_options::concavity_radius, calibrated, noise,
           {0.0, 0.01, calibrated.concavity_radius, 0.06});
  draw_row(book, "number_of_smoothing_iterations",
           &Engine_options::number_of_smoothing_iterations, paper, noise, {0, 1, 3, 10});
}

inline void draw_methods(Picture_book& book, const std::vector<const Named_mesh*>& shapes)
{
  for (const Named_mesh* shape : shapes) {
    Row_colors colors;
    add_segments(book, "methods", *shape, colors, segment(shape->mesh, Engine_options()),
                 "default");
    add_segments(book, "methods", *shape, colors,
                 segment(shape->mesh, Engine_options::zhang_liu_2005()), "zhang_liu_2005()");
  }
}

inline void draw_sdf_comparison(Picture_book& book, const std::vector<const Named_mesh*>& shapes)
{
  for (const Named_mesh* shape : shapes) {
    Row_colors colors;
    add_segments(book, "sdf", *shape, colors, segment(shape->mesh, Engine_options()),
                 "this package");
    const Sdf_segmentation sdf(shape->mesh);
    add_segments(book, "sdf", *shape, colors, sdf.by_default(), "SDF, default");
    for (std::size_t clusters : {5, 10})
      add_segments(book, "sdf", *shape, colors, sdf.by_flow_of_boost(clusters),
                   "SDF, Boost's flow, " + count(clusters, "clusters"));
  }
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_PARAMETER_FIGURES_H
