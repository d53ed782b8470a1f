// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_INTERSECTION_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_INTERSECTION_H

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <CGAL/Segmented_mesh/internal/base.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <CGAL/version.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_predicates;

inline Exact_predicates::Point_3 exact_point(const Vector& p) { return {p.x(), p.y(), p.z()}; }

inline Exact_predicates::Triangle_3 exact_triangle(const std::vector<Vector>& points,
                                                   const Corners& t)
{ return {exact_point(points[t[0]]), exact_point(points[t[1]]), exact_point(points[t[2]])}; }

// Moves the corners that another triangle has, too, to the front, and returns their number.
inline int move_common_corners_first(Corners& t, const Corners& other)
{
  const auto is_common = [&](Index v)
  { return std::find(other.begin(), other.end(), v) != other.end(); };
  return static_cast<int>(std::partition(t.begin(), t.end(), is_common) - t.begin());
}

// Returns the normal of a triangle; its length is twice the area.
inline Vector normal(const std::vector<Vector>& points, const Corners& t)
{ return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]); }

// Returns whether two triangles, which are not degenerate, meet outside their common corners and
// edges. CGAL 5.5 has this test for the faces of one mesh only, and 5.6 for triangle soups.
inline bool do_intersect(const std::vector<Vector>& points, Corners s, Corners t)
{
  const int n = move_common_corners_first(s, t);
  move_common_corners_first(t, s);
  if (n == 3)
    return true;
  const auto edge = [&](const Corners& c)
  { return Exact_predicates::Segment_3(exact_point(points[c[1]]), exact_point(points[c[2]])); };
  if (n == 2) {
    const auto v = exact_point(points[s[0]]), w = exact_point(points[s[1]]),
               p = exact_point(points[s[2]]), q = exact_point(points[t[2]]);
    return CGAL::coplanar(v, w, p, q) && CGAL::coplanar_orientation(v, w, p, q) == CGAL::POSITIVE;
  }
  if (n == 1)
    return CGAL::do_intersect(edge(s), exact_triangle(points, t)) ||
           CGAL::do_intersect(edge(t), exact_triangle(points, s));
  return CGAL::do_intersect(exact_triangle(points, s), exact_triangle(points, t));
}

// Returns the signed volume of a tetrahedron.
inline double tetrahedron_volume(const Vector& o, const Vector& p, const Vector& q,
                                 const Vector& r)
{ return (p - o).dot((q - o).cross(r - o)) / 6; }

inline bool is_degenerate(const std::vector<Vector>& points, const Corners& t)
{
  return CGAL::collinear(exact_point(points[t[0]]), exact_point(points[t[1]]),
                         exact_point(points[t[2]]));
}

// Returns whether two of a set of triangles, which are not degenerate, intersect each other.
inline bool do_self_intersect(const std::vector<Vector>& points,
                              const std::vector<Corners>& triangles)
{
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index> Box;
  struct Found {};
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    boxes.emplace_back(exact_triangle(points, triangles[i]).bbox(), static_cast<Index>(i));
  std::vector<const Box*> pointers; // they are faster to sort
  for (const Box& b : boxes)
    pointers.push_back(&b);
  try {
    CGAL::box_self_intersection_d(pointers.begin(), pointers.end(),
                                  [&](const Box* a, const Box* b) {
      if (do_intersect(points, triangles[a->info()], triangles[b->info()]))
        throw Found(); });
  }
  catch (const Found&) {
    return true;
  }
  return false;
}

// Tests triangles for intersection with the inserted ones. Triangles that were inserted after the
// last update are tested one by one.
class Triangle_tree
{
  class Primitive
  {
    Index id_ = null_index;
    const Triangle_tree* tree_ = nullptr;

  public:
    typedef Index Id;
    typedef Exact_predicates::Point_3 Point;
    typedef Exact_predicates::Triangle_3 Datum;
    typedef Datum Datum_reference;
    typedef Point Point_reference;

    Primitive() {}
    Primitive(Index id, const Triangle_tree& tree) : id_(id), tree_(&tree) {}

    Id id() const { return id_; }
    Datum datum() const { return exact_triangle(tree_->points_, tree_->triangles_[id_]); }
    Point reference_point() const
    { return exact_point(tree_->points_[tree_->triangles_[id_][0]]); }
  };

#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_traits_3<Exact_predicates, Primitive> Traits;
#else
  typedef CGAL::AABB_traits<Exact_predicates, Primitive> Traits;
#endif

  const std::vector<Vector>& points_;
  std::vector<Corners> triangles_;       // not degenerate
  CGAL::AABB_tree<Traits> tree_;         // the first `number_in_tree_`
  std::size_t number_in_tree_ = 0;
  std::size_t number_of_tests_ = 0;      // one by one, since the tree was built

  void build()
  {
    tree_.clear();
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      tree_.insert(Primitive(static_cast<Index>(i), *this));
    tree_.build();
    number_in_tree_ = triangles_.size();
    number_of_tests_ = 0;
  }

  CGAL::Bbox_3 box_of(const Corners& t) const { return exact_triangle(points_, t).bbox(); }

public:
  // Skips degenerate triangles, because CGAL does not intersect them.
  Triangle_tree(const std::vector<Vector>& points, const std::vector<Corners>& triangles)
    : points_(points)
  {
    insert(triangles);
    build();
  }

  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  // Appends triangles.
  void insert(const std::vector<Corners>& triangles)
  {
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(triangles_),
                 [&](const Corners& t) { return !is_degenerate(points_, t); });
  }

  void remove_last(std::size_t number)
  {
    triangles_.resize(triangles_.size() - number);
    if (number_in_tree_ > triangles_.size())
      build();
  }

  // Rebuilds the tree if the tests one by one have taken longer than that.
  void update()
  {
    if (number_of_tests_ > 10 * triangles_.size())
      build();
  }

  // Returns whether a triangle, which is not degenerate, intersects an inserted one.
  bool intersects(const Corners& t)
  {
    number_of_tests_ += triangles_.size() - number_in_tree_;
    const CGAL::Bbox_3 box = box_of(t);
    for (std::size_t i = number_in_tree_; i < triangles_.size(); ++i)
      if (CGAL::do_overlap(box, box_of(triangles_[i])) && do_intersect(points_, t, triangles_[i]))
        return true;
    if (number_in_tree_ == 0)
      return false;
    bool result = false;
    tree_.all_intersected_primitives(exact_triangle(points_, t),
      boost::make_function_output_iterator([&](Index i) {
        result = result || do_intersect(points_, t, triangles_[i]); }));
    return result;
  }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_INTERSECTION_H
