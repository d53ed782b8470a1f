// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FUZZ_CHECK_HIERARCHY_H
#define SPECTRAL_SEGMENTATION_TEST_FUZZ_CHECK_HIERARCHY_H

#include "run_of_soup.h"

#include <CGAL/Spectral_segmentation/internal/engine.h>
#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Checks the promises of the manual about a hierarchy, also after changes by hand.
namespace random_runs {

typedef Segmentation_hierarchy::Node Node;
typedef Segmentation_hierarchy::Cut_state Cut_state;

inline std::size_t number_of(const Labels& labels)
{ return labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end()); }

// The neighbors of each face: those that the library gives the triangles of a soup, which for a
// mesh are the faces across the edges. Groups are apart.
class Neighbors
{
  Surface surface_;

public:
  Neighbors(const Soup& soup, const std::vector<int>& groups, bool is_manifold)
    : surface_(CGAL::Spectral_segmentation::internal::read_triangle_soup(soup.points,
                                                                        soup.triangles))
  {
    if (std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to<int>()) != groups.end())
      surface_.groups.assign(groups.begin(), groups.end());
    CGAL::Spectral_segmentation::internal::connect(surface_);
    if (!is_manifold)
      return;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Index> > faces_at_edge;
    for (Index f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        faces_at_edge[std::minmax(soup.triangles[f][i], soup.triangles[f][(i + 1) % 3])]
          .push_back(f);
    std::vector<std::vector<Index> > expected(soup.triangles.size()), found(expected);
    for (const auto& [edge, faces] : faces_at_edge)
      if (faces.size() == 2 && (groups.empty() || groups[faces[0]] == groups[faces[1]])) {
        expected[faces[0]].push_back(faces[1]);
        expected[faces[1]].push_back(faces[0]);
      }
    for (Index h = 0; h < 3 * found.size(); ++h)
      if (surface_.neighbor(h) != h / 3)
        found[h / 3].push_back(surface_.neighbor(h));
    for (Index f = 0; f < found.size(); ++f)
      require(std::is_permutation(found[f].begin(), found[f].end(), expected[f].begin(),
                                  expected[f].end()),
              "two triangles alone at an edge are neighbors");
  }

  // Returns the number of connected sets of faces with the same label.
  std::size_t number_of_pieces(const Labels& labels) const
  {
    std::vector<char> is_reached(labels.size(), 0);
    std::size_t result = 0;
    for (Index seed = 0; seed < labels.size(); ++seed) {
      std::vector<Index> front(is_reached[seed] ? 0 : 1, seed);
      result += front.size();
      while (!front.empty()) {
        const Index f = front.back();
        front.pop_back();
        is_reached[f] = 1;
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
          if (const Index g = surface_.neighbor(h); !is_reached[g] && labels[g] == labels[f])
            front.push_back(g);
      }
    }
    return result;
  }
};

// Returns whether each segment of `fine` is within one of `coarse`.
inline bool is_nested(const Labels& fine, const Labels& coarse)
{
  std::vector<std::size_t> around(number_of(fine), std::size_t(-1));
  for (std::size_t f = 0; f < fine.size(); ++f) {
    std::size_t& label = around[fine[f]];
    if (label == std::size_t(-1))
      label = coarse[f];
    if (label != coarse[f])
      return false;
  }
  return true;
}

// After a leaf was cut like a part, areas come from two runs, which round points differently, and
// of which only one may count duplicate faces once.
inline void check_forest(const Segmentation_hierarchy& h, bool is_changed)
{
  std::vector<std::size_t> is_in_leaf(h.number_of_faces(), 0);
  std::size_t number_of_leaves = 0;
  double area = 0; // one far point costs all areas digits
  for (std::size_t i = 0; i < h.number_of_roots(); ++i)
    area += h.node(i).area;
  for (std::size_t i = 0; i < h.number_of_nodes(); ++i) {
    const Node& n = h.node(i);
    require(h.number_of_faces(i) > 0, "a node has faces");
    require((n.parent == Segmentation_hierarchy::null_node) == (i < h.number_of_roots()),
            "only roots have no parent");
    require(n.is_leaf() == (n.cut_state != Cut_state::CUT), "only leaves are not cut");
    require(n.area >= 0, "an area is a number that is not negative");
    require(!std::isnan(n.salience), "a salience is a number");
    if (n.is_leaf()) {
      ++number_of_leaves;
      require(std::is_sorted(h.faces(i).begin(), h.faces(i).end()), "faces of leaves ascend");
      for (std::size_t f : h.faces(i))
        require(f < is_in_leaf.size() && !is_in_leaf[f]++, "a face is in one leaf");
      continue;
    }
    const Node &a = h.node(n.children[0]), &b = h.node(n.children[1]);
    require(n.children[0] != n.children[1] && a.parent == i && b.parent == i,
            "children know their parent");
    require(h.number_of_faces(n.children[0]) + h.number_of_faces(n.children[1]) ==
              h.number_of_faces(i), "children have the faces of their parent");
    require(is_changed || (n.children[0] > i && n.children[1] > i), "children come after parents");
    require(a.area <= b.area, "the smaller child comes first");
    require(is_changed || !std::isfinite(n.area) ||
              std::abs(a.area + b.area - n.area) <= 1e-9 * n.area + 1e-15 * area,
            "children have the area of their parent: " + text(a.area) + " + " + text(b.area) +
              " and " + text(n.area));
  }
  require(std::count(is_in_leaf.begin(), is_in_leaf.end(), 1u) ==
            std::ptrdiff_t(is_in_leaf.size()), "each face is in a leaf");
  require(number_of_leaves == h.number_of_segments(), "leaves are counted");
}

// `number_of_components` is 0 where segments need not be connected.
inline void check_labels(const Segmentation_hierarchy& h, const Parameters& p,
                         const Neighbors& neighbors, std::size_t number_of_components)
{
  const std::size_t least = h.number_of_roots(), most = h.number_of_segments();
  Labels coarse;
  for (std::size_t k = 0; k <= most + 1; k += most > 60 && k > 20 ? 7 : 1) {
    const std::vector<std::size_t> nodes = h.nodes(k);
    const Labels labels = h.labels(nodes);
    const std::size_t expected = (std::min)((std::max)(k, least), most);
    require(nodes.size() == expected && number_of(labels) == expected,
            "labels(" + std::to_string(k) + ") has as many segments: " +
              std::to_string(nodes.size()) + " nodes, " + std::to_string(number_of(labels)) +
              " labels, " + std::to_string(least) + " to " + std::to_string(most));
    std::size_t next = 0;
    for (std::size_t label : labels) {
      require(label <= next, "labels(k) are numbered by their first face");
      next += label == next;
    }
    require(coarse.empty() || is_nested(labels, coarse),
            "labels(k + 1) are nested in labels(k)");
    if (number_of_components > 0) {
      const std::size_t pieces = neighbors.number_of_pieces(labels);
      require(pieces == expected, "the segments of labels(" + std::to_string(k) +
                                    ") are connected: " + std::to_string(pieces) + " pieces");
    }
    coarse = labels;
  }
}

inline void check_thresholds(const Segmentation_hierarchy& h, const Parameters& p,
                             bool knows_all)
{
  Labels coarse(h.number_of_faces(), 0);
  for (double threshold : {infinity, 0.9, 0.5, 0.2, 0., -infinity}) {
    std::vector<std::size_t> nodes;
    try {
      nodes = h.nodes_above(threshold, CGAL::Spectral_segmentation::unlimited);
    }
    catch (const std::out_of_range&) {
      require(!knows_all || threshold < h.salience_threshold(),
              "the segments of a threshold are known");
      continue;
    }
    const Labels labels = h.labels(nodes);
    require(number_of(labels) == nodes.size() && nodes.size() >= h.number_of_roots(),
            "each node of a threshold is a segment");
    require(is_nested(labels, coarse), "segments of a lower threshold are nested");
    coarse = labels;
  }
  if (p.options.method == Method::CALIBRATED)
    for (std::size_t i = h.number_of_roots(); i < h.number_of_nodes(); ++i)
      require(h.node(i).is_leaf() || h.node(i).salience <= h.node(h.node(i).parent).salience,
              "saliences never grow");
}

// Writes the hierarchy, and reads it back.
inline void check_file(const Segmentation_hierarchy& h)
{
  const std::string text = written(h);
  std::istringstream is(text);
  Segmentation_hierarchy again;
  try {
    again = CGAL::Spectral_segmentation::read_hierarchy(is);
  }
  catch (const std::runtime_error& e) {
    throw Broken_invariant(std::string("what is written can be read: ") + e.what());
  }
  require(again.nodes() == h.nodes(), "the nodes of the segments are read back");
  require(written(again) == text, "a hierarchy that is read is written alike");
  for (std::size_t k : {h.number_of_roots(), h.number_of_segments() / 2, h.number_of_segments()})
    require(again.labels(again.nodes(k)) == h.labels(h.nodes(k)), "labels(k) are read back");
}

inline void check_hierarchy(const Segmentation_hierarchy& h, const Parameters& p,
                            const Neighbors& neighbors, std::size_t number_of_components,
                            bool knows_all, bool is_changed = false)
{
  check_forest(h, is_changed);
  check_labels(h, p, neighbors, number_of_components);
  check_thresholds(h, p, knows_all);
  check_file(h);
}

inline std::size_t root_of(const Segmentation_hierarchy& h, std::size_t i)
{
  while (h.node(i).parent != Segmentation_hierarchy::null_node)
    i = h.node(i).parent;
  return i;
}

inline bool is_below(const Segmentation_hierarchy& h, std::size_t i, std::size_t j)
{
  while (i != j && i != Segmentation_hierarchy::null_node)
    i = h.node(i).parent;
  return i == j;
}

// Merges two segments or two nodes.
inline void merge(Segmentation_hierarchy& h, const Parameters& p, Random& random)
{
  const std::size_t k = random_number(random, 1, h.number_of_segments());
  const std::vector<std::size_t> nodes = h.nodes(k);
  const bool are_segments = !one_in(random, 3);
  const auto any = [&] { return random() % (are_segments ? nodes.size() : h.number_of_nodes()); };
  const std::size_t i = any(), j = any(), a = are_segments ? nodes[i] : i,
                    b = are_segments ? nodes[j] : j;
  const Segmentation_hierarchy before = h;
  try {
    const std::size_t c = h.merge(a, b);
    require(h.number_of_faces(c) == before.number_of_faces(a) + before.number_of_faces(b) &&
              h.node(a).parent == c && h.node(b).parent == c, "two nodes are merged");
    require(h.number_of_nodes() == before.number_of_nodes(), "nodes keep their indices");
  }
  catch (const std::invalid_argument&) {
    require(is_below(before, a, b) || is_below(before, b, a) ||
              root_of(before, a) != root_of(before, b), "nodes of one root can be merged");
    require(written(h) == written(before), "a change that is refused changes nothing");
    return;
  }
  if (are_segments && nodes.size() > h.number_of_roots()) {
    Labels expected = before.labels(nodes);
    std::replace(expected.begin(), expected.end(), j, i);
    const Labels labels = h.labels(h.nodes(nodes.size() - 1));
    require(is_nested(labels, expected) && is_nested(before.labels(nodes), labels),
            "two segments that were merged are one of one segment fewer");
  }
}

// Cuts a leaf like the run on its triangles with other parameters.
inline void split_leaf(Segmentation_hierarchy& h, const Soup& soup, Random& random)
{
  std::size_t leaf = random() % h.number_of_nodes();
  const bool is_leaf = h.node(leaf).is_leaf();
  Soup part{soup.points, {}};
  for (std::size_t f : h.faces(leaf))
    part.triangles.push_back(soup.triangles[f]);
  Parameters p;
  p.options.number_of_coarse_faces = 0;
  p.options.keep_components_separate = one_in(random, 4);
  p.options.salience_threshold = -infinity;
  Visitor visitor;
  const Segmentation_hierarchy cuts = run(part, p, visitor).hierarchy, before = h;
  try {
    h.split_leaf(leaf, cuts);
    require(is_leaf && cuts.number_of_roots() == 1, "only a leaf is cut, by a tree");
    require(h.number_of_segments() ==
              before.number_of_segments() + cuts.number_of_segments() - 1, "a leaf is cut");
  }
  catch (const std::invalid_argument&) {
    require(!is_leaf || cuts.number_of_roots() != 1, "a leaf can be cut by a tree");
    require(written(h) == written(before), "a change that is refused changes nothing");
  }
}

} // namespace random_runs

#endif // SPECTRAL_SEGMENTATION_TEST_FUZZ_CHECK_HIERARCHY_H
