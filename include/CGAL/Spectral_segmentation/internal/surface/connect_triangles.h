// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_CONNECT_TRIANGLES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_CONNECT_TRIANGLES_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Connects the triangles of a soup to a surface: finds their neighbors and orients them.
//
// If only two faces meet at an edge, they are neighbors. If more faces bound solids there, their
// front and back sides alternate around the edge, and the two faces of each solid are neighbors.
// Otherwise pairs become neighbors one by one: first consistently oriented pairs, the flattest pair
// first, then pairs that need a reversal. Ties go to the smallest coordinates. At an edge of very
// many faces none are neighbors.
//
// Connected faces are oriented consistently. If that is not possible, such as on a Moebius strip,
// an edge becomes a border. Consistently oriented components stay unchanged. Other components are
// oriented outward if they are closed, otherwise like most of their area.
class Triangle_connection
{
  static constexpr std::size_t most_faces_at_edge = 16;

  Surface& surface_;
  std::vector<Index>& opposite_;
  std::vector<char> is_reversed_; // one per face, relative to the soup
  bool points_inward_ = false;    // most of the volume is on the front sides

  Index source(Index h) const { return surface_.source_vertex(h); }
  Index target(Index h) const { return surface_.target_vertex(h); }
  bool are_alike(Index h, Index g) const { return source(h) != source(g); }

  void join(Index h, Index g)
  {
    opposite_[h] = g;
    opposite_[g] = h;
  }

  const Vector& apex(Index h) const { return surface_.points[target(Surface::next(h))]; }

  static auto coordinates(const Vector& p) { return std::make_tuple(p.x(), p.y(), p.z()); }

  // A face around an edge: its angle, whether the solid behind it begins there, and its halfedge.
  struct Face_at_edge
  {
    double angle;
    bool begins_solid;
    Index halfedge;
  };

  // Returns the faces around an edge in the order of their angles. Where faces coincide, those that
  // end a solid come first.
  std::vector<Face_at_edge> faces_around(const std::vector<Index>& halfedges,
                                         bool points_inward, double tolerance) const
  {
    const Vector origin = surface_.points[source(halfedges[0])],
                 axis = (surface_.points[target(halfedges[0])] - origin).stably_normalized();
    const auto direction = [&](Index h) {
      const Vector d = apex(h) - origin;
      return (d - axis.dot(d) * axis).stably_normalized();
    };
    const Vector x = direction(halfedges[0]), y = axis.cross(x);
    std::vector<Face_at_edge> result;
    for (Index h : halfedges) {
      const Vector d = direction(h);
      const bool runs_along = source(h) == source(halfedges[0]);
      result.push_back({std::atan2(y.dot(d), x.dot(d)), runs_along == points_inward, h});
    }
    const auto is_before = [](const Face_at_edge& a, const Face_at_edge& b)
      { return std::make_pair(a.angle, a.begins_solid) < std::make_pair(b.angle, b.begins_solid); };
    std::sort(result.begin(), result.end(), is_before);
    double first = -4; // the first angle of the current faces that coincide; less than all at first
    for (Face_at_edge& f : result)
      f.angle = first = f.angle > first + tolerance ? f.angle : first;
    const double turn = 2 * std::acos(-1.);
    for (Face_at_edge& f : result)
      if (f.angle + tolerance > result[0].angle + turn)
        f.angle = result[0].angle;
    std::sort(result.begin(), result.end(), is_before);
    return result;
  }

  // Joins the halfedges of an edge where solids meet. Returns false if the faces bound no solids.
  bool join_solids(const std::vector<Index>& halfedges, bool points_inward, double tolerance)
  {
    const std::vector<Face_at_edge> faces = faces_around(halfedges, points_inward, tolerance);
    const auto next = [&](std::size_t i) -> const Face_at_edge&
      { return faces[(i + 1) % faces.size()]; };
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces[i].begins_solid == next(i).begins_solid)
        return false;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces[i].begins_solid)
        join(faces[i].halfedge, next(i).halfedge);
    return true;
  }

  // Joins pairs of the halfedges of one edge.
  void join_pairs(std::vector<Index>& halfedges)
  {
    if (halfedges.size() < 2 || halfedges.size() > most_faces_at_edge)
      return;
    if (halfedges.size() == 2) {
      join(halfedges[0], halfedges[1]);
      return;
    }
    const bool have_area = std::all_of(halfedges.begin(), halfedges.end(), [this](Index h)
      { return surface_.normal(h / 3).squared_norm() > 0; });
    if (halfedges.size() % 2 == 0 && have_area)
      for (double tolerance : {1e-5, 1e-3}) // of angles
        for (bool points_inward : {points_inward_, !points_inward_})
          if (join_solids(halfedges, points_inward, tolerance))
            return;
    const auto place = [this](Index h) {
      return std::make_tuple(coordinates(apex(h)), coordinates(surface_.points[source(h)]), h);
    };
    std::sort(halfedges.begin(), halfedges.end(),
              [&](Index h, Index g) { return place(h) < place(g); });
    std::vector<std::pair<Index, Index> > pairs;
    std::vector<double> keys; // the flattest first; pairs that need a reversal come last
    for (std::size_t i = 0; i < halfedges.size(); ++i)
      for (std::size_t j = i + 1; j < halfedges.size(); ++j) {
        const Index h = halfedges[i], g = halfedges[j];
        const double cosine = surface_.normal(h / 3).stably_normalized().dot(
          surface_.normal(g / 3).stably_normalized());
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
    const auto ends = [this](Index h) { return std::minmax({source(h), target(h)}); };
    // Sorts the halfedges by the smaller of their vertices, then by the larger.
    std::vector<Index> first(surface_.points.size() + 1, 0);
    for (Index h = 0; h < opposite_.size(); ++h)
      ++first[ends(h).first + 1];
    for (std::size_t v = 1; v < first.size(); ++v)
      first[v] += first[v - 1];
    std::vector<std::pair<Index, Index> > sorted(opposite_.size()); // larger vertices, halfedges
    std::vector<Index> next(first), edge_halfedges;
    for (Index h = 0; h < opposite_.size(); ++h)
      sorted[next[ends(h).first]++] = {ends(h).second, h};
    for (Index v = 0; v + 1 < first.size(); ++v) {
      const auto begin = sorted.begin() + first[v], end = sorted.begin() + first[v + 1];
      std::sort(begin, end);
      for (auto i = begin; i != end;) {
        const Index w = i->first;
        edge_halfedges.clear();
        for (; i != end && i->first == w; ++i)
          edge_halfedges.push_back(i->second);
        if (v != w)
          join_pairs(edge_halfedges);
      }
    }
  }

  // Returns the component of a face, and sets which of its faces are reversed.
  std::vector<Index> orient_alike(Index seed, std::vector<char>& is_reached)
  {
    std::vector<Index> faces(1, seed);
    is_reached[seed] = 1;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Index h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
        const Index g = opposite_[h];
        if (g == h)
          continue;
        const char reversed = is_reversed_[h / 3] ^ char(!are_alike(h, g));
        if (!is_reached[g / 3]) {
          is_reached[g / 3] = 1;
          is_reversed_[g / 3] = reversed;
          faces.push_back(g / 3);
        }
        else if (is_reversed_[g / 3] != reversed) {
          opposite_[h] = h;
          opposite_[g] = g;
        }
      }
    return faces;
  }

  // Reverses a component if some of its faces are reversed and it points inward.
  void orient_outwards(const std::vector<Index>& faces)
  {
    double area[2] = {0, 0}; // the totals of the unreversed and the reversed faces
    double volume = 0;       // six times the volume of the surface
    bool is_closed = true;
    const Vector origin = surface_.points[source(3 * faces.front())];
    for (Index f : faces) {
      const Vector a = surface_.normal(f) / 2;
      area[int(is_reversed_[f])] += a.norm();
      volume += (is_reversed_[f] ? -1 : 1) * a.dot(surface_.points[source(3 * f)] - origin);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        is_closed = is_closed && !surface_.is_border(h);
    }
    const bool is_mixed = std::any_of(faces.begin(), faces.end(),
                                      [&](Index f) { return is_reversed_[f] != 0; });
    if (is_mixed && (is_closed && volume != 0 ? volume < 0 : area[1] > area[0]))
      for (Index f : faces)
        is_reversed_[f] = !is_reversed_[f];
  }

  void orient_components()
  {
    std::vector<char> is_reached(is_reversed_.size(), 0);
    for (Index f = 0; f < is_reversed_.size(); ++f)
      if (!is_reached[f])
        orient_outwards(orient_alike(f, is_reached));
  }

  void reverse_faces()
  {
    for (Index f = 0; f < is_reversed_.size(); ++f)
      if (is_reversed_[f])
        std::swap(surface_.corners[f][1], surface_.corners[f][2]);
    renumber_halfedges(surface_, [this](Index h)
      { return is_reversed_[h / 3] ? h - h % 3 + (2 - h % 3) : h; });
  }

public:
  explicit Triangle_connection(Surface& surface)
    : surface_(surface), opposite_(surface.opposite), is_reversed_(surface.number_of_faces(), 0)
  {
    opposite_ = first_indices(3 * surface.number_of_faces());
  }

  void operator()()
  {
    double volume = 0;
    const Bounding_box box(surface_.points);
    const Vector center = box.smallest / 2 + box.largest / 2;
    for (Index f = 0; f < surface_.number_of_faces(); ++f)
      volume += surface_.normal(f).dot(surface_.points[source(3 * f)] - center);
    points_inward_ = volume < 0;
    find_opposites();
    bool are_all_alike = true;
    for (Index h = 0; h < opposite_.size(); ++h)
      are_all_alike = are_all_alike && (surface_.is_border(h) || are_alike(h, opposite_[h]));
    if (!are_all_alike)
      orient_components();
    for (Index h = 0; h < opposite_.size(); ++h)
      if (surface_.neighbor(h) == h / 3) // the face is glued to itself
        opposite_[h] = h;
    if (!are_all_alike)
      reverse_faces();
    start_at_smallest_vertices(surface_);
  }
};

inline void connect_triangles(Surface& surface)
{
  Triangle_connection connection(surface);
  connection();
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_CONNECT_TRIANGLES_H
