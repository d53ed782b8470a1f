// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H

#include <CGAL/Spectral_segmentation/internal/base/Face_features.h>
#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/salience/Support_points.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

struct Face_at_distance
{
  Index face;
  double distance; // measured from the cut, between centroids
};

// Returns the halfedges along a cut on its side 0.
inline std::vector<Index> halfedges_of_cut(const Surface& part, const Sides& side)
{
  std::vector<Index> result;
  for (Index f = 0; f < part.number_of_faces(); ++f)
    if (side[f] == 0)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (side[part.neighbor(h)] != 0)
          result.push_back(h);
  return result;
}

// Collects the faces that Dijkstra examines, and ends the search beyond a radius.
class Near_face_visitor : public boost::dijkstra_visitor<>
{
  const std::vector<double>* distance_;
  double radius_;
  std::vector<Face_at_distance>* faces_;

public:
  struct Radius_reached {};

  Near_face_visitor(const std::vector<double>& distance, double radius,
                    std::vector<Face_at_distance>& faces)
    : distance_(&distance), radius_(radius), faces_(&faces) {}

  void examine_vertex(Index f, const Surface&) const
  {
    if ((*distance_)[f] > radius_)
      throw Radius_reached();
    faces_->push_back({f, (*distance_)[f]});
  }
};

// Returns the faces on both sides within `radius` of a cut, nearest first, then by their indices.
// Paths do not cross the cut. They start at the middles of its edges.
inline std::vector<Face_at_distance> faces_near_cut(const Surface& part, const Sides& side,
                                                    const std::vector<Index>& cut, double radius)
{
  std::vector<double> distance(part.number_of_faces(), infinite_distance);
  std::vector<Index> sources;
  for (Index h : cut) {
    const Vector middle =
      (part.points[part.source_vertex(h)] + part.points[part.target_vertex(h)]) / 2;
    for (Index f : {h / 3, part.neighbor(h)}) {
      if (distance[f] == infinite_distance)
        sources.push_back(f);
      distance[f] = (std::min)(distance[f], (part.centroid(f) - middle).norm());
    }
  }
  const auto step = [&](Index h) -> double {
    return side[h / 3] == side[part.neighbor(h)] ? part.weights[h].centroids : infinite_distance;
  };
  std::vector<Face_at_distance> result;
  try {
    run_dijkstra(part, sources, step, distance, Near_face_visitor(distance, radius, result));
  }
  catch (const Near_face_visitor::Radius_reached&) {}
  std::sort(result.begin(), result.end(), [](const Face_at_distance& a, const Face_at_distance& b)
    { return a.distance < b.distance || (a.distance == b.distance && a.face < b.face); });
  return result;
}

// Measures how far sets of faces of a part are from convex: the mean depth, by area, of their faces
// below their own convex hull, each along its normal. The hull is the convex hull of the extreme
// points in some directions. The point that supports it along a normal is found among the extreme
// points of the directions next to the normal.
class Convexity_defect
{
  const Support_points& extreme_points_;
  const Surface& part_;
  const std::vector<Index>& faces_; // the faces of the part, by their indices in the mesh
  Support_set part_extremes_;
  std::vector<float> depths_; // below the hull of the part; they hold for many other hulls

  float depth(Index f, const Support_set& extremes) const
  {
    const Face_plane& plane = extreme_points_.plane(faces_[f]);
    float depth = 0;
    for (int d : directions::neighbors()[plane.direction])
      depth = (std::max)(depth, plane.normal.dot(extreme_points_.point(extremes.points[d]) -
                                                 plane.center));
    return depth;
  }

  // Returns whether a hull differs from the hull of the part next to each direction.
  std::array<char, directions::number> changes(const Support_set& extremes) const
  {
    std::array<char, directions::number> differs, result;
    for (int d = 0; d < directions::number; ++d)
      differs[d] = extremes.points[d] != part_extremes_.points[d];
    for (int i = 0; i < directions::number; ++i) {
      result[i] = 0;
      for (int d : directions::neighbors()[i])
        result[i] |= differs[d];
    }
    return result;
  }

public:
  Convexity_defect(const Support_points& support_points, const Surface& part,
             const std::vector<Index>& faces)
    : extreme_points_(support_points), part_(part), faces_(faces),
      part_extremes_(support_points(faces))
  {
    depths_.reserve(faces.size());
    for (Index f = 0; f < faces.size(); ++f)
      depths_.push_back(depth(f, part_extremes_));
  }

  double part_defect() const
  {
    double sum = 0, area = 0;
    for (Index f = 0; f < depths_.size(); ++f) {
      sum += part_.areas[f] * depths_[f];
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : 0;
  }

  // Returns the defect of faces of the part, without repetition; 0 if they have no area.
  double operator()(const std::vector<Index>& faces) const
  {
    std::vector<Index> in_mesh;
    in_mesh.reserve(faces.size());
    for (Index f : faces)
      in_mesh.push_back(faces_[f]);
    const Support_set extremes = extreme_points_(in_mesh);
    const std::array<char, directions::number> is_changed = changes(extremes);
    double sum = 0, area = 0;
    for (Index f : faces) {
      const bool changes = is_changed[extreme_points_.plane(faces_[f]).direction];
      sum += part_.areas[f] * (changes ? depth(f, extremes) : depths_[f]);
      area += part_.areas[f];
    }
    return area > 0 ? sum / area : 0;
  }
};

// The data of the entire mesh that the factors of a cut need.
struct Evaluation_context
{
  double area_of_model;
  Support_points support_points;
  Face_features features;
  double feature_weight;

  explicit Evaluation_context(const Surface& mesh, Face_features face_features = Face_features(),
                              double weight = 0)
    : area_of_model(total_area(mesh)), support_points(mesh),
      features(std::move(face_features)), feature_weight(weight) {}
};

// Computes all factors of cuts of a part, including the factors beyond the paper (Section 6 and
// `Salience_factors`). A cut is given by the side of each face: 0 for Q, which has the smaller
// area, 1 for the rest.
class Cut_evaluator
{
  const Surface& part_;
  const std::vector<Index>& faces_; // the faces of the part, by their indices in the mesh
  const Evaluation_context& mesh_;
  Patch empty_;
  Convexity_defect convexity_defect_;
  double defect_of_part_;

  // Sets size, cut strength by length and protrusiveness; returns the length of the cut.
  double set_cut_factors(const std::vector<Index>& faces_of_q, const std::vector<Index>& cut,
                         Salience_factors& factors) const
  {
    Patch q = empty_;
    for (Index f : faces_of_q)
      q.add(f);
    factors = q.factors();
    double length = 0, concavity = 0;
    for (Index h : cut) {
      const double l = part_.length(h);
      length += l;
      concavity += l * part_.weights[h].concavity;
    }
    factors.cut_strength = length > 0 ? concavity / length : 0;
    return length;
  }

  // Returns the ratio of the second and the first standard deviation of the points of a cut.
  double roundness(const std::vector<Index>& cut, double length) const
  {
    Vector sum;
    const Vector origin = part_.points[part_.source_vertex(cut.front())];
    Symmetric_matrix squares;
    for (Index h : cut) {
      const Vector a = part_.points[part_.source_vertex(h)] - origin,
                   b = part_.points[part_.target_vertex(h)] - origin, middle = (a + b) / 2;
      const double fraction = part_.length(h) / length;
      sum += fraction * middle;
      squares += fraction / 6 * (Symmetric_matrix::square(a) + Symmetric_matrix::square(b) +
                                 4 * Symmetric_matrix::square(middle)); // Simpson's rule is exact
    }
    const Symmetric_matrix covariance = squares - Symmetric_matrix::square(sum);
    const double first = Eigen_decomposition(covariance).largest_eigenvalue();
    const double product = product_of_largest_eigenvalues(covariance);
    return first > 0 ? (std::min)(std::sqrt(product) / first, 1.) : 0;
  }

  // Returns the concavity below which a quarter of the length of a cut lies.
  double lower_quartile_of_concavity(const std::vector<Index>& cut, double length) const
  {
    std::vector<std::pair<float, double> > edges; // concavity and length
    for (Index h : cut)
      edges.emplace_back(part_.weights[h].concavity, part_.length(h));
    std::sort(edges.begin(), edges.end());
    double rest = length / 4;
    for (const auto& [concavity, l] : edges)
      if ((rest -= l) <= 0)
        return concavity;
    return edges.back().first;
  }

  typedef std::vector<Face_at_distance> Near_faces;

  // Returns the mean concavity, by length, of the edges of faces.
  double mean_concavity(Near_faces::const_iterator first, Near_faces::const_iterator end) const
  {
    double length = 0, concavity = 0;
    for (; first != end; ++first)
      for (Index h = 3 * first->face; h < 3 * first->face + 3; ++h)
        if (!part_.is_border(h)) {
          const double l = part_.length(h);
          length += l;
          concavity += l * part_.weights[h].concavity;
        }
    return length > 0 ? concavity / length : 0;
  }

  // Returns the area of the faces of one side relative to a strip along the cut.
  double expansion(Near_faces::const_iterator first, Near_faces::const_iterator end,
                   const Sides& side, char s, double area_of_strip) const
  {
    double area = 0;
    for (; first != end; ++first)
      if (side[first->face] == s)
        area += part_.areas[first->face];
    return area_of_strip > 0 ? (std::min)(area / area_of_strip, constants::largest_expansion)
                             : constants::largest_expansion;
  }

  // Returns the length of the mean normal of the faces of the rest.
  double flatness_of_rest(Near_faces::const_iterator first, Near_faces::const_iterator end,
                          const Sides& side) const
  {
    double area = 0;
    Vector sum;
    for (; first != end; ++first)
      if (side[first->face] == 1) {
        sum += part_.normal(first->face) / 2;
        area += part_.areas[first->face];
      }
    return area > 0 ? (std::min)(sum.norm() / area, 1.) : 1;
  }

  void set_factors_of_features(Near_faces::const_iterator first,
                               Near_faces::const_iterator end_of_near, const Sides& side,
                               Salience_factors& factors) const
  {
    Feature_variance sides(mesh_.features), near_cut(mesh_.features);
    for (Index f = 0; f < side.size(); ++f)
      sides.add(faces_[f], part_.areas[f], side[f]);
    for (; first != end_of_near; ++first)
      near_cut.add(faces_[first->face], part_.areas[first->face], side[first->face]);
    set_feature_factors(sides, near_cut, mesh_.area_of_model, factors);
    factors.feature_weight = mesh_.feature_weight;
  }

  void set_neighborhood_factors(const Sides& side, const std::vector<Index>& cut,
                                double area_of_q, double length, Salience_factors& factors,
                                std::vector<Index>* near_cut) const
  {
    const double radius = constants::neighborhood_radius * std::sqrt(area_of_q);
    const Near_faces faces =
      faces_near_cut(part_, side, cut, factors.is_boundary ? 2 * radius : radius);
    const auto first = faces.begin(), end = faces.end();
    const auto end_of_near = std::partition_point(first, end, [=](const Face_at_distance& f)
                                                  { return f.distance <= radius; });
    if (near_cut)
      for (auto f = first; f != end_of_near; ++f)
        near_cut->push_back(f->face);
    factors.concavity_near_cut = mean_concavity(first, end_of_near);
    if (!mesh_.features.empty())
      set_factors_of_features(first, end_of_near, side, factors);
    factors.expansion_behind_cut = expansion(first, end_of_near, side, 1, radius * length);
    if (!factors.is_boundary)
      return;
    factors.flatness_behind_cut = flatness_of_rest(first, end_of_near, side);
    factors.concavity_around_cut = mean_concavity(first, end);
    factors.expansion_before_cut = expansion(first, end, side, 0, 2 * radius * length);
  }

  void set_convexity_factors(const std::vector<Index> (&faces)[2], const double (&area)[2],
                             Salience_factors& factors) const
  {
    const double unit = std::sqrt(mesh_.area_of_model), whole = defect_of_part_ / unit;
    const double sides =
      (area[0] * convexity_defect_(faces[0]) + area[1] * convexity_defect_(faces[1])) /
      ((area[0] + area[1]) * unit);
    const double offset = constants::smallest_convexity_defect;
    factors.convexity_gain = whole - sides;
    factors.relative_convexity_gain = std::log((whole + offset) / (sides + offset));
  }

public:
  // Takes a part; `faces` are its faces, by their indices in the mesh.
  Cut_evaluator(const Surface& part, const std::vector<Index>& faces,
                const Evaluation_context& mesh)
    : part_(part), faces_(faces), mesh_(mesh), empty_(part),
      convexity_defect_(mesh.support_points, part, faces),
      defect_of_part_(convexity_defect_.part_defect())
  {}

  // Returns the factors of a candidate, or of the boundary of two regions. Both sides must have an
  // area. Appends the faces near the cut to `near_cut`, if given, nearest first.
  Salience_factors operator()(const Sides& side, bool is_boundary = false,
                              std::vector<Index>* near_cut = nullptr) const
  {
    std::vector<Index> faces[2];
    for (std::vector<Index>& f : faces)
      f.reserve(side.size());
    double area[2] = {0, 0};
    for (Index f = 0; f < side.size(); ++f) {
      faces[int(side[f])].push_back(f);
      area[int(side[f])] += part_.areas[f];
    }

    Salience_factors factors;
    const std::vector<Index> cut = halfedges_of_cut(part_, side);
    const double length = set_cut_factors(faces[0], cut, factors);
    factors.is_boundary = is_boundary;
    if (factors.is_boundary && length > 0) {
      factors.roundness = roundness(cut, length);
      factors.lower_quartile_of_concavity = lower_quartile_of_concavity(cut, length);
    }
    set_neighborhood_factors(side, cut, area[0], length, factors, near_cut);
    set_convexity_factors(faces, area, factors);
    factors.log_relative_part_area = std::log((area[0] + area[1]) / mesh_.area_of_model);
    return factors;
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SALIENCE_CUT_EVALUATOR_H
