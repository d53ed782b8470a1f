// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_TREE_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_TREE_H

#include <CGAL/Segmented_mesh/internal/capping/triangle_intersection.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Finds whether a triangle intersects those that it holds. Triangles that were inserted after the
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
  CGAL::AABB_tree<Traits> tree_;         // of the first triangles
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
  // Leaves degenerate triangles out, because CGAL does not intersect them.
  Triangle_tree(const std::vector<Vector>& points, const std::vector<Corners>& triangles)
    : points_(points)
  {
    insert(triangles);
    build();
  }

  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  std::size_t size() const { return triangles_.size(); }

  // Adds triangles at the end.
  void insert(const std::vector<Corners>& triangles)
  {
    std::copy_if(triangles.begin(), triangles.end(), std::back_inserter(triangles_),
                 [&](const Corners& t) { return !is_degenerate(points_, t); });
  }

  // Removes triangles at the end.
  void resize(std::size_t size)
  {
    triangles_.resize(size);
    if (number_in_tree_ > size)
      build();
  }

  // Puts the triangles in the tree if to test them one by one has taken longer than that.
  void update()
  {
    if (number_of_tests_ > 10 * triangles_.size())
      build();
  }

  // Returns whether a triangle, which is not degenerate, intersects one that the tree holds.
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

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_TRIANGLE_TREE_H
