// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SOUP_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SOUP_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Makes a surface of the triangles of a soup: finds opposite half-edges and orients the faces.
//
// Two faces alone at an edge are neighbors. Of more, those pairs become neighbors, one after the
// other, that are oriented alike and bend the least, then those that have to be turned; of equals
// those of the smallest faces. At an edge of very many faces none are.
//
// Connected faces are oriented alike; where that is not possible, as on a Moebius strip, an edge
// becomes border. Faces that are oriented alike already stay as they are. Others are oriented
// outwards if their surface is closed, and otherwise as most of its area is.
class Triangle_connection
{
  static constexpr std::size_t most_faces_at_edge = 16;

  Surface& surface_;
  std::vector<Index>& opposite_;
  std::vector<char> is_turned_; // each face, against its orientation in the soup

  bool are_alike(Index h, Index g) const { return surface_.source(h) != surface_.source(g); }

  void join(Index h, Index g)
  {
    opposite_[h] = g;
    opposite_[g] = h;
  }

  // The half-edges of one edge, ascending.
  void join_pairs(const std::vector<Index>& halfedges)
  {
    if (halfedges.size() < 2 || halfedges.size() > most_faces_at_edge)
      return;
    if (halfedges.size() == 2) {
      join(halfedges[0], halfedges[1]);
      return;
    }
    std::vector<std::pair<Index, Index> > pairs;
    std::vector<double> keys; // the bending, and those that have to be turned after the others
    for (Index h : halfedges)
      for (Index g : halfedges)
        if (h < g) {
          const double cosine = surface_.area_vector(h / 3).stably_normalized().dot(
            surface_.area_vector(g / 3).stably_normalized());
          pairs.emplace_back(h, g);
          keys.push_back(quantized(are_alike(h, g) ? -cosine : cosine + 4));
        }
    for (Index i : sorted_indices(keys)) {
      const auto [h, g] = pairs[i];
      if (surface_.is_border(h) && surface_.is_border(g))
        join(h, g);
    }
  }

  void find_opposites()
  {
    const auto ends = [this](Index h)
    { return std::minmax({surface_.source(h), surface_.target(h)}); };
    const Rows halfedges(surface_.points.size(), opposite_.size(),
                         [&](Index h) { return ends(h).first; });
    std::vector<Index> at_vertex, of_edge; // those whose smaller vertex it is; those of one edge
    for (Index v = 0; v < halfedges.number(); ++v) {
      at_vertex.assign(halfedges[v].begin(), halfedges[v].end());
      std::sort(at_vertex.begin(), at_vertex.end(), [&](Index g, Index h)
        { return std::make_pair(ends(g).second, g) < std::make_pair(ends(h).second, h); });
      for (auto i = at_vertex.begin(); i != at_vertex.end();) {
        const auto j = std::find_if(i, at_vertex.end(), [&](Index h)
          { return ends(h).second != ends(*i).second; });
        of_edge.assign(i, j);
        if (surface_.source(*i) != surface_.target(*i))
          join_pairs(of_edge);
        i = j;
      }
    }
  }

  // Finds which faces of the component of a face are turned against it.
  std::vector<Index> orient_alike(Index seed, std::vector<char>& is_reached)
  {
    std::vector<Index> faces(1, seed);
    is_reached[seed] = 1;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
        const Index g = opposite_[h];
        if (g == h)
          continue;
        const char turned = is_turned_[h / 3] ^ char(!are_alike(h, g));
        if (!is_reached[g / 3]) {
          is_reached[g / 3] = 1;
          is_turned_[g / 3] = turned;
          faces.push_back(g / 3);
        }
        else if (is_turned_[g / 3] != turned) {
          opposite_[h] = h;
          opposite_[g] = g;
        }
      }
    return faces;
  }

  // Turns a component if it is mixed, and mostly inwards.
  void orient_outwards(const std::vector<Index>& component)
  {
    double area[2] = {0, 0}; // of the faces as they are, and of those that are turned
    double volume = 0;
    bool is_closed = true, is_mixed = false;
    const Vector origin = surface_.points[surface_.source(3 * component.front())];
    for (Index f : component) {
      const Vector a = surface_.area_vector(f);
      area[int(is_turned_[f])] += a.norm();
      volume += (is_turned_[f] ? -1 : 1) * a.dot(surface_.points[surface_.source(3 * f)] - origin);
      is_mixed = is_mixed || is_turned_[f];
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_closed = is_closed && !surface_.is_border(h);
    }
    if (is_mixed && (is_closed && volume != 0 ? volume < 0 : area[1] > area[0]))
      for (Index f : component)
        is_turned_[f] = !is_turned_[f];
  }

public:
  explicit Triangle_connection(Surface& surface)
    : surface_(surface), opposite_(surface.opposite), is_turned_(surface.number_of_faces(), 0) {}

  void operator()()
  {
    opposite_.resize(3 * surface_.number_of_faces());
    std::iota(opposite_.begin(), opposite_.end(), Index(0));
    find_opposites();
    std::vector<char> is_reached(is_turned_.size(), 0);
    for (Index f = 0; f < is_turned_.size(); ++f)
      if (!is_reached[f])
        orient_outwards(orient_alike(f, is_reached));
    for (Index f = 0; f < is_turned_.size(); ++f)
      if (is_turned_[f])
        std::swap(surface_.corners[f][1], surface_.corners[f][2]);
    renumber_halfedges(surface_, [this](Index h)
      { return is_turned_[h / 3] ? h - h % 3 + (2 - h % 3) : h; });
    start_at_smallest_vertices(surface_);
  }
};

inline void connect_triangles(Surface& surface)
{
  Triangle_connection connection(surface);
  connection();
}

// Returns for each point the first one at its place.
inline std::vector<Index> first_points_at_places(const std::vector<Vector>& points)
{
  const auto coordinates = [&](Index v)
  { return std::make_tuple(points[v].x(), points[v].y(), points[v].z()); };
  std::vector<Index> order(points.size()), result(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(), [&](Index v, Index w)
    { return std::make_pair(coordinates(v), v) < std::make_pair(coordinates(w), w); });
  for (std::size_t i = 0; i < order.size(); ++i)
    result[order[i]] = i > 0 && coordinates(order[i - 1]) == coordinates(order[i])
      ? result[order[i - 1]] : order[i];
  return result;
}

// Returns for each face the first one with the same three points, in any order, which may be the
// face itself. Points must differ: faces in one point or line are no twins. `place` is that of
// first_points_at_places().
inline std::vector<Index> first_twins(const Surface& surface, const std::vector<Index>& place)
{
  const auto places = [&](Index f) {
    const Corners& c = surface.corners[f];
    Corners result = {place[c[0]], place[c[1]], place[c[2]]};
    std::sort(result.begin(), result.end());
    return result;
  };
  const Rows faces(surface.points.size(), surface.number_of_faces(),
                   [&](Index f) { return places(f)[0]; });
  std::vector<Index> result(surface.number_of_faces());
  std::vector<std::pair<Corners, Index> > at_place; // the faces whose smallest place it is
  for (Index p = 0; p < faces.number(); ++p) {
    at_place.clear();
    for (Index f : faces[p])
      at_place.emplace_back(places(f), f);
    std::sort(at_place.begin(), at_place.end());
    for (std::size_t i = 0; i < at_place.size(); ++i) {
      const auto& [c, f] = at_place[i];
      const bool is_twin =
        i > 0 && at_place[i - 1].first == c && c[0] != c[1] && c[1] != c[2];
      result[f] = is_twin ? result[at_place[i - 1].second] : f;
    }
  }
  return result;
}

// The faces that `first_twin` maps to themselves, connected as a soup whose points at one place are
// one: what several faces at one place separated may be a surface.
inline Surface without_twins(const Surface& surface, const std::vector<Index>& first_twin,
                             const std::vector<Index>& place)
{
  Surface result;
  result.points = surface.points;
  for (Index f = 0; f < first_twin.size(); ++f)
    if (first_twin[f] == f) {
      const Corners& c = surface.corners[f];
      result.corners.push_back({place[c[0]], place[c[1]], place[c[2]]});
    }
  connect_triangles(result);
  return result;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_SOUP_H
