// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_HALFEDGE_MESH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_HALFEDGE_MESH_H

#include <CGAL/Spectral_segmentation/internal/mesh/Triangles.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The halfedges of a mesh as arrays. Halfedge 3f+i belongs to face f and leaves its corner i.
struct Halfedge_mesh
{
  typedef boost::container::small_vector<Index, 16> Index_list;

  std::vector<Corners> corners; // one per face; null_index first if the face is gone
  std::vector<Index> opposite;  // one per halfedge; null_index on the border
  std::vector<Vector> points;   // one per vertex

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index source(Index h) const { return corners[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); }
  bool is_gone(Index f) const { return corners[f][0] == null_index; }

  // Returns the halfedges that leave the source of h, one for each face around it.
  Index_list around_source(Index h) const
  {
    Index_list result;
    Index g = h;
    do {
      result.push_back(g);
      g = opposite[previous(g)];
    } while (g != null_index && g != h);
    if (g == null_index)
      for (g = h; opposite[g] != null_index;) {
        g = next(opposite[g]);
        result.push_back(g);
      }
    return result;
  }

  // Returns whether there are at most three faces around the source of h, and no border.
  bool has_few_faces_around(Index h) const
  {
    Index g = h;
    for (int i = 0; i < 3; ++i) {
      g = opposite[previous(g)];
      if (g == null_index || g == h)
        return g == h;
    }
    return false;
  }

  bool is_on_border(const Index_list& around) const
  {
    return std::any_of(around.begin(), around.end(), [&](Index h)
      { return opposite[h] == null_index || opposite[previous(h)] == null_index; });
  }

  Index_list neighbors(const Index_list& around) const
  {
    Index_list result;
    for (Index h : around) {
      result.push_back(target(h));
      result.push_back(source(previous(h)));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_MULTILEVEL_HALFEDGE_MESH_H
