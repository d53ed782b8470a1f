// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FUZZ_CHECK_RESULTS_H
#define SPECTRAL_SEGMENTATION_TEST_FUZZ_CHECK_RESULTS_H

#include "check_hierarchy.h"

#include <CGAL/Segmented_mesh/close_segments.h>
#include <CGAL/Segmented_mesh/refine_segment_boundaries.h>
#include <CGAL/Segmented_mesh/split_into_segments.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Checks the promises of the manual about the functions that take a segmentation.
namespace random_runs {

typedef std::vector<int> Ids;

inline bool is_same(const Soup& a, const Soup& b) // also if coordinates are no numbers
{
  return a.triangles == b.triangles && a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0;
}

// Returns the soup with its largest coordinate about 1.
inline Soup normalized(Soup soup)
{
  double largest = 0;
  for (const auto& t : soup.triangles)
    for (std::size_t v : t)
      for (int i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::abs(soup.points[v][i]));
  const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
  for (Point& p : soup.points)
    p = Point(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
              std::ldexp(p.z(), exponent));
  return soup;
}

inline std::map<int, double> areas(const Soup& soup, const Ids& ids)
{
  const Soup s = normalized(soup);
  std::map<int, double> result;
  for (std::size_t f = 0; f < ids.size(); ++f) {
    const auto& t = s.triangles[f];
    result[ids[f]] +=
      std::sqrt(CGAL::squared_area(s.points[t[0]], s.points[t[1]], s.points[t[2]]));
  }
  return result;
}

inline double sum(const std::map<int, double>& values)
{
  double result = 0;
  for (const auto& value : values)
    result += value.second;
  return result;
}

inline void check_refinement(const Soup& before, const Ids& old_ids, const Soup& after,
                             const Ids& ids)
{
  require(std::memcmp(before.points.data(), after.points.data(),
                      before.points.size() * sizeof(Point)) == 0, "refinement moves no point");
  const std::map<int, double> old_areas = areas(before, old_ids), new_areas = areas(after, ids);
  const double all = sum(old_areas), tolerance = 1e-9 * all + 1e-12 * double(ids.size());
  require(std::abs(sum(new_areas) - all) <= tolerance,
          "refinement keeps the area: " + text(sum(new_areas) - all));
  require(old_areas.size() == new_areas.size(), "refinement loses and makes no segment");
  for (const auto& [id, area] : old_areas) {
    require(new_areas.count(id) == 1, "refinement loses no segment");
    require(new_areas.at(id) >= area / 2 - tolerance, "no segment loses half of its area");
  }
}

inline Labels labels_of(const Ids& ids) { return Labels(ids.begin(), ids.end()); }

// Returns the triangles and ids of a mesh.
template <class IdMap>
std::pair<Soup, Ids> soup_of(const Mesh& mesh, IdMap id)
{
  std::pair<Soup, Ids> result;
  for (Mesh::Vertex_index v : mesh.vertices())
    result.first.points.push_back(mesh.point(v));
  for (Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    result.first.triangles.push_back(
      {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
    result.second.push_back(id[f]);
  }
  return result;
}

inline Mesh::Property_map<Mesh::Face_index, int> add_ids(Mesh& mesh, const Ids& ids)
{
  const auto result = mesh.add_property_map<Mesh::Face_index, int>("f:id").first;
  for (Mesh::Face_index f : mesh.faces())
    result[f] = ids[f];
  return result;
}

inline std::size_t number_of_border_edges(const Mesh& mesh)
{
  std::size_t result = 0;
  for (Mesh::Edge_index e : mesh.edges())
    result += mesh.is_border(e);
  return result;
}

inline void check_refinement_of_mesh(const Mesh& mesh, const Ids& ids, const Soup& refined_soup,
                                     const Ids& refined_ids, int iterations)
{
  Mesh after = mesh;
  const auto id = add_ids(after, ids);
  const auto before = soup_of(after, id);
  const std::size_t number = CGAL::refine_segment_boundaries(
    after, id, parameters::number_of_iterations(iterations));
  require(CGAL::is_triangle_mesh(after) &&
            CGAL::is_valid_polygon_mesh(after) == CGAL::is_valid_polygon_mesh(mesh),
          "a refined mesh is as valid as the mesh"); // which is not if a vertex has no face
  require((number == 0) == (num_faces(after) == num_faces(mesh)), "split faces are counted");
  require((number_of_border_edges(after) == 0) == (number_of_border_edges(mesh) == 0),
          "refinement opens no mesh");
  const auto [soup, new_ids] = soup_of(after, id);
  check_refinement(before.first, before.second, soup, new_ids);
  const std::size_t pieces = Neighbors(before.first, {}, true).number_of_pieces(labels_of(ids));
  require(Neighbors(soup, {}, true).number_of_pieces(labels_of(new_ids)) <= pieces,
          "no segment falls into more components by refinement");
  require(soup.triangles.size() == refined_soup.triangles.size() &&
            soup.points.size() == refined_soup.points.size(),
          "triangles are refined like the faces of their mesh");
  const auto of_mesh = areas(soup, new_ids), of_soup = areas(refined_soup, refined_ids);
  for (const auto& [label, area] : of_mesh)
    require(std::abs(of_soup.at(label) - area) <= 1e-9, "both refinements have the same segments");
}

// Gives bad input, which must be refused and left as it is.
template <class Function>
void check_refused(const Soup& soup, const Ids& ids, Random& random, const Function& f)
{
  Soup bad = soup;
  Ids bad_ids = ids;
  if (one_in(random, 4))
    bad_ids.push_back(0);
  else
    spoil(bad, random);
  const Soup before = bad;
  const Ids old_ids = bad_ids;
  try {
    f(bad, bad_ids);
  }
  catch (const std::invalid_argument& e) {
    require(std::string(e.what()).size() > 40, "an exception has a message");
    require(is_same(bad, before) && bad_ids == old_ids, "an exception changes nothing");
    return;
  }
  throw Broken_invariant("bad triangles are refused");
}

// `mesh` has the faces of the soup; null where they are no manifold.
inline void check_refining(const Soup& before, const Ids& ids, const Mesh* mesh, Random& random)
{
  const int iterations = one_in(random, 2) ? 15 : int(random() % 40);
  Soup soup = before;
  Ids new_ids = ids;
  const auto refinement = CGAL::refine_segment_boundaries(
    soup.points, soup.triangles, new_ids, parameters::number_of_iterations(iterations));
  require(soup.points.size() == before.points.size() + refinement.points.size() &&
            soup.triangles.size() == before.triangles.size() + refinement.triangles.size() &&
            new_ids.size() == soup.triangles.size(), "what is appended is counted");
  check_refinement(before, ids, soup, new_ids);
  if (mesh)
    check_refinement_of_mesh(*mesh, ids, soup, new_ids, iterations);
  check_refused(before, ids, random, [](Soup& s, Ids& i)
    { CGAL::refine_segment_boundaries(s.points, s.triangles, i); });
}

// Returns six times the sum of the volumes.
inline double volume(const Soup& soup)
{
  const Soup s = normalized(soup);
  double result = 0;
  for (const auto& t : s.triangles)
    result += 6 * CGAL::volume(s.points[s.triangles[0][0]], s.points[t[0]], s.points[t[1]],
                               s.points[t[2]]);
  return result;
}

inline void check_closing(const Soup& before, const Ids& old_ids, const Mesh* mesh,
                          Random& random)
{
  Soup soup = before;
  Ids ids = old_ids;
  const auto segments = CGAL::close_segments(soup.points, soup.triangles, ids);
  require(ids.size() == soup.triangles.size(), "each triangle of a cap has an id");
  require(std::equal(before.triangles.begin(), before.triangles.end(), soup.triangles.begin()) &&
            std::equal(old_ids.begin(), old_ids.end(), ids.begin()), "caps come last");
  std::map<std::tuple<int, std::size_t, std::size_t>, std::size_t> number_at_edge;
  for (std::size_t f = 0; f < ids.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [v, w] = std::minmax(soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]);
      if (v != w)
        ++number_at_edge[{ids[f], v, w}];
    }
  std::set<int> other_than_two; // the segments with other edges than such of two triangles
  for (const auto& [edge, number] : number_at_edge) {
    require(number % 2 == 0, "an edge of a closed segment has an even number of triangles");
    if (number != 2)
      other_than_two.insert(std::get<0>(edge));
  }
  for (const auto& segment : segments)
    require(!segment.is_closed || other_than_two.count(segment.id) == 0,
            "an edge of a closed segment has two triangles");
  if (mesh && CGAL::is_closed(*mesh))
    require(std::abs(volume(soup) - volume(before)) <= 1e-9 * double(ids.size()),
            "closed segments have the volume of the closed mesh");
  check_refused(before, old_ids, random, [](Soup& s, Ids& i)
    { CGAL::close_segments(s.points, s.triangles, i); });
}

// Returns what CGAL finds with a kernel that makes no errors.
inline bool does_self_intersect(const Mesh& mesh)
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> copy;
  CGAL::copy_face_graph(mesh, copy);
  return CGAL::Polygon_mesh_processing::does_self_intersect(copy);
}

inline void check_splitting(const Mesh& mesh, const Ids& ids, bool close_parts)
{
  Mesh copy = mesh;
  const auto id = add_ids(copy, ids);
  const Ids sorted = [&] {
    Ids result = ids;
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }();
  std::vector<Mesh> parts;
  std::vector<std::vector<Mesh::Face_index> > faces_of_parts;
  const auto segments = CGAL::split_into_segments(
    copy, id, parts, parameters::close_parts(close_parts).faces_of_parts(faces_of_parts));
  require(parts.size() == sorted.size() && faces_of_parts.size() == sorted.size(),
          "each segment is a part");
  std::size_t number_of_faces = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    require(CGAL::is_valid_polygon_mesh(parts[i]), "a part is a valid mesh");
    require(parts[i].number_of_faces() == faces_of_parts[i].size(), "a part has its faces");
    if (close_parts)
      require((segments[i].is_manifold && !segments[i].has_self_intersections) ==
                (CGAL::is_closed(parts[i]) && !does_self_intersect(parts[i])),
              "a part is told to be closed and free of self-intersections if it is");
    for (Mesh::Face_index f : faces_of_parts[i])
      if (f != Mesh::null_face()) {
        ++number_of_faces;
        require(ids[f] == sorted[i], "a part has the faces of its segment");
      }
  }
  require(number_of_faces == num_faces(mesh), "each face is in a part");
}

} // namespace random_runs

#endif // SPECTRAL_SEGMENTATION_TEST_FUZZ_CHECK_RESULTS_H
