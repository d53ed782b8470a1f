// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_REFINEMENT_BOUNDARY_REFINEMENT_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_REFINEMENT_BOUNDARY_REFINEMENT_H

#include <CGAL/Spectral_segmentation/internal/mesh/Face_graph.h>
#include <CGAL/Spectral_segmentation/internal/mesh/connected_components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// How the faces of a mesh are to be split, so that smooth curves separate its segments.
//
// A point on an edge cuts the edge into two halves. The side of a face along its edge i is the
// halves 2i, at corner i, and 2i+1, at the next corner; without a point both have one label.
struct Refinement
{
  struct Edge_point
  {
    Index halfedge;  // 3f+i is the i-th edge of face f
    double position; // 0 at its source, 1 at its target
  };

  struct Split_face
  {
    Index face;
    std::array<Index, 3> points;  // of each edge; `null_index` if it has none
    bool has_center;              // joined to all corners and points
    std::array<double, 3> center; // its barycentric coordinates
    int diagonal;                 // of the quadrilateral between two points: 0 from the point after
                                  // the corner that is cut off, 1 from the point before it
    std::array<Index, 6> labels;  // of the halves, and so of the new faces along them
  };

  std::vector<Edge_point> points;
  std::vector<Split_face> split_faces;
  std::vector<std::pair<Index, Index> > other_labels; // of faces that are not split
};

// Finds the refinement. The share of each segment in the angle at a vertex is smoothed by
// diffusion in a band around the boundaries, and each vertex takes the label of its largest share.
// Where the ends of an edge have two labels, the boundary crosses it where both shares are equal,
// and where the corners of a face have three, the boundaries meet inside of it. A boundary that
// comes close to a vertex passes through it. Then the points on edges slide until the boundaries
// are taut.
//
// Where a segment would vanish or fall apart, faces are frozen: they keep their label, and the
// boundary there follows their edges. In the end all faces are frozen at worst.
class Boundary_refinement
{
  static constexpr int band_width = 3;                // in rings of vertices around the boundary
  static constexpr double smooth_turn = 0.25;         // of a boundary that is smooth at a vertex
  static constexpr int smooth_distance = 3;           // in edges to a vertex where it is not smooth
  static constexpr double snapping_distance = 0.05;   // from a vertex, in lengths of the edge
  static constexpr double smallest_area = 1e-3;       // of a new face, in mean areas of faces
  static constexpr double smallest_split_area = 1e-2; // of a face that is held to the smallest area
  static constexpr double smallest_rest = 0.5;        // of the area of a segment
  static constexpr int number_of_slides = 10;
  static constexpr int number_of_local_rounds = 4;

  enum class Crossing_place { NONE, INSIDE, AT_SOURCE, AT_TARGET };

  // Of the segments with the largest shares in a vertex, in the order of their labels. Others have
  // so little that they are left out, or many tiny segments would take much time.
  struct Shares
  {
    static constexpr int capacity = 6;
    int size = 0;
    std::array<std::pair<Index, double>, capacity> entries;

    double operator[](Index label) const
    {
      for (int i = 0; i < size; ++i)
        if (entries[i].first == label)
          return entries[i].second;
      return 0;
    }

    Index largest() const // of equals the one with the smallest label
    {
      int best = 0;
      for (int i = 1; i < size; ++i)
        if (entries[i].second > entries[best].second)
          best = i;
      return entries[best].first;
    }
  };

  // A sum of shares of any number of segments.
  class Sum_of_shares
  {
    std::vector<std::pair<Index, double> > entries_;
    double weight_ = 0;

  public:
    void clear()
    {
      entries_.clear();
      weight_ = 0;
    }

    void add(Index label, double weight)
    {
      weight_ += weight;
      for (auto& entry : entries_)
        if (entry.first == label) {
          entry.second += weight;
          return;
        }
      entries_.emplace_back(label, weight);
    }

    void add(const Shares& shares, double weight)
    {
      for (int i = 0; i < shares.size; ++i)
        add(shares.entries[i].first, weight * shares.entries[i].second);
    }

    Shares mean()
    {
      const auto is_larger = [](const auto& a, const auto& b)
      { return a.second > b.second || (a.second == b.second && a.first < b.first); };
      std::sort(entries_.begin(), entries_.end(), is_larger);
      Shares result;
      result.size = static_cast<int>((std::min)(entries_.size(), std::size_t(Shares::capacity)));
      for (int i = 0; i < result.size; ++i)
        result.entries[i] = {entries_[i].first, entries_[i].second / weight_};
      std::sort(result.entries.begin(), result.entries.begin() + result.size);
      return result;
    }
  };

  struct Crossing
  {
    Index halfedge; // the smaller one of the edge
    double position;
    Crossing_place place;
  };

  // A face at which something changes.
  struct Cut
  {
    Index face;
    bool is_frozen;
    bool has_center;
    std::array<Index, 6> labels;
  };

  const Face_graph& graph_;
  const std::vector<Index>& labels_; // of the faces, below `number_of_segments_`
  const std::size_t number_of_segments_;
  double mean_area_ = 0;

  std::vector<unsigned char> ring_; // of each vertex; band_width + 1 beyond the band
  std::vector<Index> band_faces_;   // with a vertex in the band, but for those of the last ring
  std::vector<Index> share_of_vertex_;
  std::vector<Shares> shares_;
  std::vector<Index> vertex_label_;

  std::vector<Index> crossing_of_halfedge_;
  std::vector<Crossing> crossings_;
  std::vector<Index> cut_of_face_;
  std::vector<Cut> cuts_;

  Index size() const { return static_cast<Index>(graph_.number_of_faces()); }

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }

  void find_band()
  {
    ring_.assign(graph_.points.size(), band_width + 1);
    const auto reach = [&](Index v, int ring) {
      if (ring_[v] > ring)
        ring_[v] = static_cast<unsigned char>(ring);
    };
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h)
      if (labels_[h / 3] != labels_[graph_.neighbors[h]]) {
        reach(graph_.source_vertex(h), 0);
        reach(graph_.target_vertex(h), 0);
      }
    for (int ring = 1; ring <= band_width; ++ring)
      for (const Corners& c : graph_.corners)
        if (ring_[c[0]] < ring || ring_[c[1]] < ring || ring_[c[2]] < ring)
          for (Index v : c)
            reach(v, ring);
    for (Index f = 0; f < size(); ++f) {
      const Corners& c = graph_.corners[f];
      if ((std::min)({ring_[c[0]], ring_[c[1]], ring_[c[2]]}) < band_width)
        band_faces_.push_back(f);
    }
  }

  // Of the edges of the boundary at a vertex.
  struct Boundary_vertex
  {
    int number_of_edges = 0;
    std::array<Index, 2> neighbors = {null_index, null_index}; // along the first two of them
    std::array<Index, 2> labels = {null_index, null_index};    // beside the last
  };

  double turn_at(Index v, const Boundary_vertex& b) const
  {
    const Vector before = graph_.points[v] - graph_.points[b.neighbors[0]];
    const Vector after = graph_.points[b.neighbors[1]] - graph_.points[v];
    return std::atan2(before.cross(after).norm(), before.dot(after));
  }

  // The vertices from which the boundary is smooth for some edges in both directions.
  std::map<Index, Boundary_vertex> vertices_of_smooth_boundaries() const
  {
    std::map<Index, Boundary_vertex> result;
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h) {
      const Index a = labels_[h / 3], b = labels_[graph_.neighbors[h]];
      if (a >= b)
        continue;
      const std::array<Index, 2> ends = {graph_.source_vertex(h), graph_.target_vertex(h)};
      for (int i : {0, 1}) {
        Boundary_vertex& v = result[ends[i]];
        if (v.number_of_edges < 2)
          v.neighbors[v.number_of_edges] = ends[1 - i];
        ++v.number_of_edges;
        v.labels = {a, b};
      }
    }
    std::vector<Index> rough; // a boundary that ends at a border goes on smoothly
    for (const auto& [v, b] : result)
      if (b.number_of_edges > 2 || (b.number_of_edges == 2 && turn_at(v, b) > smooth_turn))
        rough.push_back(v);
    for (int distance = 0; distance < smooth_distance; ++distance) {
      std::vector<Index> next;
      for (Index v : rough) {
        const auto found = result.find(v);
        if (found == result.end())
          continue;
        const Boundary_vertex b = found->second;
        result.erase(found);
        for (int i = 0; i < 2; ++i)
          if (b.neighbors[i] != null_index)
            next.push_back(b.neighbors[i]);
      }
      rough.swap(next);
    }
    return result;
  }

  double angle_at(Index h) const
  {
    const Vector& p = graph_.points[graph_.source_vertex(h)];
    const Vector u = graph_.points[graph_.target_vertex(h)] - p;
    const Vector v = graph_.points[graph_.source_vertex(next(next(h)))] - p;
    return std::atan2(u.cross(v).norm(), u.dot(v));
  }

  // How strongly the face joins the ends of its edge. It is positive for each face, and that of an
  // edge grows with its distance across and falls with its length.
  double weight(Index h) const
  {
    const double squared_length =
      (graph_.points[graph_.target_vertex(h)] - graph_.points[graph_.source_vertex(h)])
        .squared_norm();
    const double area = graph_.areas[h / 3], largest = 4;
    return squared_length * largest <= area ? largest : area / squared_length + 0.02;
  }

  void smooth_shares(std::size_t number_of_iterations)
  {
    share_of_vertex_.assign(graph_.points.size(), null_index);
    std::vector<Index> band;
    for (Index f : band_faces_)
      for (Index v : graph_.corners[f])
        if (share_of_vertex_[v] == null_index) {
          share_of_vertex_[v] = static_cast<Index>(band.size());
          band.push_back(v);
        }

    // The neighbors of the vertex i of the band are those from first[i] to first[i + 1].
    typedef std::pair<Index, double> Neighbor;
    std::vector<std::size_t> first(band.size() + 1, 0);
    const auto for_each_pair = [&](const auto& visit) {
      for (Index f : band_faces_)
        for (Index h = 3 * f; h < 3 * f + 3; ++h) {
          const Index v = share_of_vertex_[graph_.source_vertex(h)];
          const Index w = share_of_vertex_[graph_.target_vertex(h)];
          visit(v, w, h);
          visit(w, v, h);
        }
    };
    for_each_pair([&](Index v, Index, Index) { ++first[v + 1]; });
    for (std::size_t i = 0; i < band.size(); ++i)
      first[i + 1] += first[i];
    std::vector<Neighbor> neighbors(first.back());
    std::vector<std::size_t> end(first.begin(), first.end() - 1);
    for_each_pair([&](Index v, Index w, Index h) { neighbors[end[v]++] = {w, weight(h)}; });

    std::vector<std::vector<std::pair<Index, double> > > angles(band.size());
    for (Index f : band_faces_)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        angles[share_of_vertex_[graph_.source_vertex(h)]].emplace_back(labels_[f],
                                                                       angle_at(h) + 1e-6);
    Sum_of_shares sum;
    shares_.resize(band.size());
    for (std::size_t i = 0; i < band.size(); ++i) {
      sum.clear();
      for (const auto& [label, angle] : angles[i])
        sum.add(label, angle);
      shares_[i] = sum.mean();
    }
    std::vector<char> is_fixed(band.size(), 0);
    for (const auto& [v, b] : vertices_of_smooth_boundaries()) {
      const Index i = share_of_vertex_[v];
      shares_[i].size = 2;
      shares_[i].entries[0] = {b.labels[0], 0.5};
      shares_[i].entries[1] = {b.labels[1], 0.5};
      is_fixed[i] = 1;
    }

    std::vector<Shares> old_shares;
    for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration) {
      old_shares = shares_;
      for (std::size_t i = 0; i < band.size(); ++i) {
        if (is_fixed[i] || ring_[band[i]] >= band_width)
          continue;
        double weights = 0;
        sum.clear();
        for (std::size_t k = first[i]; k < first[i + 1]; ++k) {
          sum.add(old_shares[neighbors[k].first], neighbors[k].second);
          weights += neighbors[k].second;
        }
        sum.add(old_shares[i], weights / 2);
        shares_[i] = sum.mean();
      }
    }
  }

  // Vertices of the last ring keep the label of their faces, as they keep their shares.
  void label_vertices()
  {
    vertex_label_.resize(graph_.points.size(), 0);
    for (Index f = 0; f < size(); ++f)
      for (Index v : graph_.corners[f])
        vertex_label_[v] = labels_[f];
    for (Index f : band_faces_)
      for (Index v : graph_.corners[f])
        vertex_label_[v] = shares_[share_of_vertex_[v]].largest();
  }

  void find_crossings()
  {
    crossing_of_halfedge_.assign(graph_.number_of_halfedges(), null_index);
    std::vector<std::pair<Index, Index> > snapped; // vertices, with the label that they have too
    for (Index f : band_faces_)
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index v = graph_.source_vertex(h), w = graph_.target_vertex(h);
        const Index a = vertex_label_[v], b = vertex_label_[w];
        const Index o = graph_.is_border(h) ? h : graph_.opposite(h);
        if (a == b || o < h)
          continue;
        const Shares &at_v = shares_[share_of_vertex_[v]], &at_w = shares_[share_of_vertex_[w]];
        const double to_v = at_v[a] - at_v[b], to_w = at_w[b] - at_w[a];
        const double position = to_v + to_w > 0 ? to_v / (to_v + to_w) : 0.5;
        crossing_of_halfedge_[h] = crossing_of_halfedge_[o] = static_cast<Index>(crossings_.size());
        crossings_.push_back({h, position, Crossing_place::INSIDE});
        if (position < snapping_distance)
          snapped.emplace_back(v, b);
        if (1 - position < snapping_distance)
          snapped.emplace_back(w, a);
      }
    std::sort(snapped.begin(), snapped.end());
    const auto is_snapped = [&](Index v, Index w) {
      return std::binary_search(snapped.begin(), snapped.end(),
                                std::make_pair(v, vertex_label_[w]));
    };
    for (Crossing& c : crossings_) {
      const Index v = graph_.source_vertex(c.halfedge), w = graph_.target_vertex(c.halfedge);
      const bool source = is_snapped(v, w), target = is_snapped(w, v);
      if (source && (!target || c.position < 0.5))
        c.place = Crossing_place::AT_SOURCE;
      else if (target)
        c.place = Crossing_place::AT_TARGET;
    }
  }

  // As seen from the face of the half-edge.
  Crossing_place crossing_place(Index h) const
  {
    if (crossing_of_halfedge_[h] == null_index)
      return Crossing_place::NONE;
    const Crossing& c = crossings_[crossing_of_halfedge_[h]];
    if (c.halfedge == h || c.place == Crossing_place::INSIDE)
      return c.place;
    return c.place == Crossing_place::AT_SOURCE ? Crossing_place::AT_TARGET
                                                : Crossing_place::AT_SOURCE;
  }

  double position(Index h) const
  {
    const Crossing& c = crossings_[crossing_of_halfedge_[h]];
    return c.halfedge == h ? c.position : 1 - c.position;
  }

  Cut cut_of(Index f) const
  {
    const Corners& c = graph_.corners[f];
    const std::array<Index, 3> label = {vertex_label_[c[0]], vertex_label_[c[1]],
                                        vertex_label_[c[2]]};
    const std::array<Crossing_place, 3> place = {
      crossing_place(3 * f), crossing_place(3 * f + 1), crossing_place(3 * f + 2)};
    Cut cut{f, false, false, {}};
    cut.labels.fill(label[0]);

    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Crossing_place p = place[i], q = place[k];
      // Corner i alone has its label.
      if (label[j] == label[k] && label[i] != label[j]) {
        cut.labels.fill(label[j]);
        if (p == Crossing_place::AT_SOURCE || q == Crossing_place::AT_TARGET)
          return cut;
        cut.labels[2 * i] = cut.labels[2 * k + 1] = label[i];
        if (p == Crossing_place::AT_TARGET)
          cut.labels[2 * i + 1] = label[i];
        if (q == Crossing_place::AT_SOURCE)
          cut.labels[2 * k] = label[i];
        if (p == Crossing_place::AT_TARGET && q == Crossing_place::AT_SOURCE)
          cut.labels.fill(label[i]);
        return cut;
      }
      // Of three labels, that of corner i vanishes into it.
      if (label[i] != label[j] && label[j] != label[k] && label[k] != label[i] &&
          p == Crossing_place::AT_SOURCE && q == Crossing_place::AT_TARGET) {
        cut.labels.fill(place[j] == Crossing_place::AT_SOURCE ? label[k] : label[j]);
        if (place[j] == Crossing_place::INSIDE)
          cut.labels[2 * j + 1] = cut.labels[2 * k] = cut.labels[2 * k + 1] = label[k];
        return cut;
      }
    }
    if (label[0] == label[1])
      return cut;
    cut.has_center = true;
    for (int i = 0; i < 3; ++i) {
      const Index at_source = label[i], at_target = label[(i + 1) % 3];
      cut.labels[2 * i] = place[i] == Crossing_place::AT_SOURCE ? at_target : at_source;
      cut.labels[2 * i + 1] = place[i] == Crossing_place::AT_TARGET ? at_source : at_target;
    }
    return cut;
  }

  bool is_changed(const Cut& cut) const
  {
    const Index old_label = labels_[cut.face];
    return std::any_of(cut.labels.begin(), cut.labels.end(),
                       [old_label](Index label) { return label != old_label; });
  }

  void find_cuts()
  {
    cut_of_face_.assign(size(), null_index);
    for (Index f : band_faces_) {
      const Cut cut = cut_of(f);
      if (is_changed(cut)) {
        cut_of_face_[f] = static_cast<Index>(cuts_.size());
        cuts_.push_back(cut);
      }
    }
  }

  void freeze(Cut& cut)
  {
    cut.is_frozen = true;
    cut.has_center = false;
    cut.labels.fill(labels_[cut.face]);
  }

  // Of half an edge of a face.
  Index label(Index h, int half) const
  {
    const Index cut = cut_of_face_[h / 3];
    return cut == null_index ? labels_[h / 3] : cuts_[cut].labels[2 * (h % 3) + half];
  }

  static bool has_label(const Cut& cut, Index label)
  { return std::find(cut.labels.begin(), cut.labels.end(), label) != cut.labels.end(); }

  std::vector<std::size_t> numbers_of_old_components() const
  {
    Face_components components(size());
    for (Index f = 0; f < size(); ++f)
      components.add(f);
    for (Index h = 0; h < graph_.number_of_halfedges(); ++h) {
      const Index f = h / 3, g = graph_.neighbors[h];
      if (f < g && labels_[f] == labels_[g])
        components.join(f, g);
    }
    std::vector<std::size_t> numbers(number_of_segments_, 0);
    for (Index f = 0; f < size(); ++f)
      numbers[labels_[f]] += components.representative(f) == f;
    return numbers;
  }

  // Of the refined mesh, in which the part of a face with one label is a piece.
  class Pieces
  {
    const Boundary_refinement& owner_;
    std::vector<Index> first_of_cut_; // its piece of labels[0] is that of the face
    std::vector<Index> label_;        // of the further pieces
    Face_components components_;

    static std::size_t number_of_pieces(const Boundary_refinement& owner)
    { return owner.size() + 2 * owner.cuts_.size(); }

  public:
    // The pieces of a cut are numbered f, n + 2c and n + 2c + 1.
    Index piece(Index f, Index label) const
    {
      const Index c = owner_.cut_of_face_[f];
      if (c == null_index)
        return f;
      const std::array<Index, 6>& labels = owner_.cuts_[c].labels;
      if (labels[0] == label)
        return f;
      const Index other =
        *std::find_if(labels.begin(), labels.end(), [&](Index l) { return l != labels[0]; });
      return owner_.size() + 2 * c + (other == label ? 0 : 1);
    }

    explicit Pieces(const Boundary_refinement& owner)
      : owner_(owner), components_(number_of_pieces(owner))
    {
      const Face_graph& graph = owner.graph_;
      label_.assign(number_of_pieces(owner), null_index);
      for (Index f = 0; f < owner.size(); ++f)
        label_[f] = owner.label(3 * f, 0);
      for (const Cut& cut : owner.cuts_)
        for (Index label : cut.labels)
          label_[piece(cut.face, label)] = label;
      for (Index p = 0; p < label_.size(); ++p)
        if (label_[p] != null_index)
          components_.add(p);
      for (Index h = 0; h < graph.number_of_halfedges(); ++h) {
        const Index f = h / 3, g = graph.neighbors[h];
        if (f >= g)
          continue;
        if (owner.cut_of_face_[f] == null_index && owner.cut_of_face_[g] == null_index) {
          if (owner.labels_[f] == owner.labels_[g])
            components_.join(f, g);
          continue;
        }
        const Index o = graph.opposite(h);
        for (int half : {0, 1}) {
          const Index label = owner.label(h, half);
          if (label == owner.label(o, 1 - half))
            components_.join(piece(f, label), piece(g, label));
        }
      }
    }

    Index component(Index p) { return components_.representative(p); }

    std::vector<std::size_t> numbers_of_components()
    {
      std::vector<std::size_t> numbers(owner_.number_of_segments_, 0);
      for (Index p = 0; p < label_.size(); ++p)
        if (label_[p] != null_index)
          numbers[label_[p]] += components_.representative(p) == p;
      return numbers;
    }

    // Whether the component lies in faces that had another label.
    std::vector<char> is_gained()
    {
      std::vector<char> result(label_.size(), 1);
      for (Index p = 0; p < label_.size(); ++p)
        if (label_[p] != null_index) {
          const Index f = p < owner_.size() ? p : owner_.cuts_[(p - owner_.size()) / 2].face;
          if (owner_.labels_[f] == label_[p])
            result[component(p)] = 0;
        }
      return result;
    }
  };

  // Freezes faces that a segment has lost between two of its components, and those in which it has
  // gained a component. Returns whether there was any.
  bool freeze_locally(const std::vector<char>& is_bad, Pieces& pieces)
  {
    typedef std::pair<Index, Index> Vertex_of_segment;
    const auto loses = [&](const Cut& cut) { return !cut.is_frozen && is_bad[labels_[cut.face]]; };
    std::map<Vertex_of_segment, Index> cut_at;
    Face_components clusters(cuts_.size()); // of lost faces that touch
    for (Index c = 0; c < cuts_.size(); ++c)
      if (loses(cuts_[c])) {
        clusters.add(c);
        for (Index v : graph_.corners[cuts_[c].face])
          clusters.join(c, cut_at.emplace(Vertex_of_segment(v, labels_[cuts_[c].face]), c)
                             .first->second);
      }

    std::vector<Index> component(cuts_.size(), null_index); // that each cluster touches
    std::vector<char> is_between(cuts_.size(), 0);
    const auto touch = [&](Index f, Index label) {
      if (!is_bad[label])
        return;
      const Index here = pieces.component(pieces.piece(f, label));
      for (Index v : graph_.corners[f]) {
        const auto found = cut_at.find({v, label});
        if (found == cut_at.end())
          continue;
        const Index cluster = clusters.representative(found->second);
        if (component[cluster] == null_index)
          component[cluster] = here;
        is_between[cluster] |= component[cluster] != here;
      }
    };
    for (Index f : band_faces_) {
      if (cut_of_face_[f] == null_index)
        touch(f, labels_[f]);
      else
        for (Index label : cuts_[cut_of_face_[f]].labels)
          touch(f, label);
    }

    bool has_frozen = false;
    std::vector<char> is_gained = pieces.is_gained();
    std::vector<Index> to_freeze;
    for (Index c = 0; c < cuts_.size(); ++c) {
      const Cut& cut = cuts_[c];
      if (cut.is_frozen)
        continue;
      bool is_to_freeze = false;
      if (loses(cut)) {
        const Index cluster = clusters.representative(c);
        is_to_freeze = is_between[cluster] || component[cluster] == null_index;
      }
      for (Index label : cut.labels)
        is_to_freeze |= is_bad[label] && is_gained[pieces.component(pieces.piece(cut.face, label))];
      if (is_to_freeze)
        to_freeze.push_back(c);
    }
    for (Index c : to_freeze) {
      freeze(cuts_[c]);
      has_frozen = true;
    }
    return has_frozen;
  }

  // Of each bad segment all faces that it has lost or gained, so that it is what it was.
  void freeze_segments(const std::vector<char>& is_bad)
  {
    for (Cut& cut : cuts_)
      if (is_bad[labels_[cut.face]] ||
          std::any_of(cut.labels.begin(), cut.labels.end(),
                      [&](Index label) { return is_bad[label] != 0; }))
        freeze(cut);
  }

  // The share of the area of a face that has the label.
  double share_of(const Cut& cut, Index label) const
  {
    const Index h = 3 * cut.face;
    std::array<double, 3> positions, center_of_face = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
      positions[i] = crossing_of_halfedge_[h + i] == null_index ? 0.5 : position(h + i);
    if (cut.has_center)
      center_of_face = center(cut.face);

    double share = 0;
    bool is_uniform = true;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Index before = cut.labels[2 * i], after = cut.labels[2 * i + 1];
      if (cut.has_center) {
        share += center_of_face[k] * (before == label ? positions[i] : 0);
        share += center_of_face[k] * (after == label ? 1 - positions[i] : 0);
      }
      else if (before != after && cut.labels[2 * k] != cut.labels[2 * k + 1]) {
        const double corner = positions[i] * (1 - positions[k]);
        return before == label ? corner : after == label ? 1 - corner : 0;
      }
      else if (before != after && cut.labels[2 * j] == cut.labels[2 * j + 1])
        return before == label ? positions[i] : after == label ? 1 - positions[i] : 0;
      is_uniform &= before == after;
    }
    return is_uniform && !cut.has_center ? double(cut.labels[0] == label) : share;
  }

  std::vector<char> segments_that_lose_much(const std::vector<double>& old_areas) const
  {
    std::vector<double> areas = old_areas;
    for (const Cut& cut : cuts_) {
      areas[labels_[cut.face]] -= graph_.areas[cut.face];
      std::array<Index, 6> labels = cut.labels;
      std::sort(labels.begin(), labels.end());
      for (auto l = labels.begin(); l != labels.end(); l = std::upper_bound(l, labels.end(), *l))
        areas[*l] += share_of(cut, *l) * graph_.areas[cut.face];
    }
    std::vector<char> result(number_of_segments_, 0);
    for (std::size_t s = 0; s < number_of_segments_; ++s)
      result[s] = areas[s] < smallest_rest * old_areas[s];
    return result;
  }

  void keep_segments()
  {
    const auto has_any = [](const std::vector<char>& v)
    { return std::find(v.begin(), v.end(), 1) != v.end(); };
    const std::vector<std::size_t> old_numbers = numbers_of_old_components();
    std::vector<double> old_areas(number_of_segments_, 0);
    for (Index f = 0; f < size(); ++f)
      old_areas[labels_[f]] += graph_.areas[f];
    for (int round = 0;; ++round) {
      std::vector<char> is_bad = segments_that_lose_much(old_areas);
      if (has_any(is_bad)) {
        freeze_segments(is_bad);
        continue;
      }
      Pieces pieces(*this);
      const std::vector<std::size_t> numbers = pieces.numbers_of_components();
      for (std::size_t s = 0; s < number_of_segments_; ++s)
        is_bad[s] = numbers[s] == 0 || numbers[s] > old_numbers[s];
      if (!has_any(is_bad))
        return;
      if (round >= number_of_local_rounds || !freeze_locally(is_bad, pieces))
        freeze_segments(is_bad);
    }
  }

  // Whether the crossing is needed, as a label changes along one side of the edge.
  bool is_cut(Index h) const
  {
    return crossing_place(h) == Crossing_place::INSIDE &&
           (label(h, 0) != label(h, 1) ||
            (!graph_.is_border(h) &&
             label(graph_.opposite(h), 0) != label(graph_.opposite(h), 1)));
  }

  // What each new face must have of the length of the edges, so that its area is not too small.
  double smallest_share(Index f) const
  {
    const double area = graph_.areas[f];
    if (!(area > 0) || area < smallest_split_area * mean_area_)
      return snapping_distance;
    return (std::max)(snapping_distance,
                      1.02 * std::sqrt(smallest_area * mean_area_ / area));
  }

  double clamped(Index h, double position) const
  {
    double share = smallest_share(h / 3);
    if (!graph_.is_border(h))
      share = (std::max)(share, smallest_share(graph_.neighbors[h]));
    return (std::min)((std::max)(position, share), 1 - share);
  }

  Vector point(Index h) const
  {
    const Vector& p = graph_.points[graph_.source_vertex(h)];
    return p + position(h) * (graph_.points[graph_.target_vertex(h)] - p);
  }

  // The mean of the places where the three boundaries enter the face.
  std::array<double, 3> center(Index f) const
  {
    std::array<double, 3> result = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      const Crossing_place place = crossing_place(3 * f + i);
      const double t = place == Crossing_place::INSIDE      ? position(3 * f + i)
                       : place == Crossing_place::AT_TARGET ? 1
                                                            : 0;
      result[i] += (1 - t) / 3;
      result[(i + 1) % 3] += t / 3;
    }
    const double smallest = (std::min)({result[0], result[1], result[2]});
    const double share = smallest_share(f);
    if (smallest < share) {
      const double to_middle = (share - smallest) / (1. / 3 - smallest);
      for (double& x : result)
        x += to_middle * (1. / 3 - x);
    }
    return result;
  }

  Vector point_at(Index f, const std::array<double, 3>& barycentric) const
  {
    const Corners& c = graph_.corners[f];
    return barycentric[0] * graph_.points[c[0]] + barycentric[1] * graph_.points[c[1]] +
           barycentric[2] * graph_.points[c[2]];
  }

  // The next point of the boundary in the face of a half-edge that it crosses. Returns false where
  // it follows an edge.
  bool next_point(Index h, Vector& result) const
  {
    const Index c = cut_of_face_[h / 3];
    if (c == null_index || label(h, 0) == label(h, 1))
      return false;
    if (cuts_[c].has_center) {
      result = point_at(h / 3, center(h / 3));
      return true;
    }
    for (Index k : {next(h), next(next(h))})
      if (label(k, 0) != label(k, 1)) {
        result = point(k);
        return true;
      }
    result = graph_.points[graph_.source_vertex(next(next(h)))];
    return true;
  }

  // Moves each point on an edge to where the boundary through it is shorter: one step of
  // Weiszfeld's method for the sum of the distances to the points before and after it.
  void slide_crossings(std::vector<Index>& needed)
  {
    for (int step = 0; step < number_of_slides; ++step)
      for (Index c : needed) {
        Crossing& crossing = crossings_[c];
        const Index h = crossing.halfedge;
        Vector p, q;
        if (graph_.is_border(h) || !next_point(h, p) || !next_point(graph_.opposite(h), q))
          continue;
        const Vector here = point(h), start = graph_.points[graph_.source_vertex(h)];
        const Vector edge = graph_.points[graph_.target_vertex(h)] - start;
        const double to_p = (p - here).norm(), to_q = (q - here).norm();
        const double squared_length = edge.squared_norm();
        if (!(to_p > 0) || !(to_q > 0) || !(squared_length > 0))
          continue;
        const Vector middle = (p * to_q + q * to_p) / (to_p + to_q);
        crossing.position = clamped(h, (middle - start).dot(edge) / squared_length);
      }
  }

  // The diagonal that leaves the larger smallest height.
  int better_diagonal(Index after, Index before) const
  {
    const Vector p = point(after), q = point(before);
    const Vector &j = graph_.points[graph_.target_vertex(after)],
                 &k = graph_.points[graph_.source_vertex(before)];
    const auto quality = [](const Vector& a, const Vector& b, const Vector& c) {
      const double longest = (std::max)(
        {(b - a).squared_norm(), (c - b).squared_norm(), (a - c).squared_norm()});
      return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
    };
    const double of_first = (std::min)(quality(p, j, k), quality(p, k, q));
    const double of_second = (std::min)(quality(p, j, q), quality(j, k, q));
    return of_first >= of_second ? 0 : 1;
  }

  Refinement refinement()
  {
    std::vector<Index> needed, point_of_crossing(crossings_.size(), null_index);
    for (Index c = 0; c < crossings_.size(); ++c)
      if (is_cut(crossings_[c].halfedge)) {
        crossings_[c].position = clamped(crossings_[c].halfedge, crossings_[c].position);
        needed.push_back(c);
      }
    slide_crossings(needed);

    Refinement result;
    for (Index c : needed) {
      point_of_crossing[c] = static_cast<Index>(result.points.size());
      result.points.push_back({crossings_[c].halfedge, crossings_[c].position});
    }
    for (Index f : band_faces_) {
      const Index c = cut_of_face_[f];
      Refinement::Split_face split{f, {}, false, {}, 0, {}};
      int number_of_points = 0;
      for (int i = 0; i < 3; ++i) {
        const Index crossing = crossing_of_halfedge_[3 * f + i];
        split.points[i] = crossing == null_index ? null_index : point_of_crossing[crossing];
        number_of_points += split.points[i] != null_index;
        split.labels[2 * i] = label(3 * f + i, 0);
        split.labels[2 * i + 1] = label(3 * f + i, 1);
      }
      if (c != null_index && cuts_[c].has_center) {
        split.has_center = true;
        split.center = center(f);
      }
      if (number_of_points == 2)
        for (int i = 0; i < 3; ++i)
          if (split.points[i] != null_index && split.points[(i + 2) % 3] != null_index)
            split.diagonal = better_diagonal(3 * f + i, 3 * f + (i + 2) % 3);
      if (number_of_points > 0 || split.has_center)
        result.split_faces.push_back(split);
      else if (split.labels[0] != labels_[f])
        result.other_labels.emplace_back(f, split.labels[0]);
    }
    return result;
  }

public:
  // The labels of the faces must be less than `number_of_segments`, and each must have a face.
  Boundary_refinement(const Face_graph& graph, const std::vector<Index>& labels,
                      std::size_t number_of_segments)
    : graph_(graph), labels_(labels), number_of_segments_(number_of_segments)
  {
    for (double area : graph.areas)
      mean_area_ += area / static_cast<double>(graph.number_of_faces());
  }

  Refinement operator()(std::size_t number_of_iterations)
  {
    find_band();
    if (band_faces_.empty())
      return Refinement();
    smooth_shares(number_of_iterations);
    label_vertices();
    find_crossings();
    find_cuts();
    keep_segments();
    return refinement();
  }
};

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_REFINEMENT_BOUNDARY_REFINEMENT_H
