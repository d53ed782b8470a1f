// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_DENDROGRAM_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_DENDROGRAM_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

enum class Cut_state { NOT_SEARCHED, NO_CUT, REJECTED, ACCEPTED };

constexpr std::size_t null_node = static_cast<std::size_t>(-1);

// Two sets of leaves become one. Each is named by any of its leaves, so a merge stays what it is when
// others are added, moved or removed.
struct Merge
{
  Index leaves[2];
  double salience = 0;
  Salience_factors factors{};   // of the smaller set
  std::size_t node = null_node; // what it makes, in a hierarchy whose nodes keep their numbers

  // NO_CUT and REJECTED are decisions of the paper's method on a part that became a leaf, which is
  // named twice.
  Cut_state state = Cut_state::ACCEPTED;
  bool is_cut() const { return state == Cut_state::ACCEPTED; }
};

// What a run makes: regions of faces, and how they are merged. In reverse the merges are the cuts of
// the run, in their order.
struct Dendrogram
{
  std::vector<Index> leaf;   // of each face
  std::vector<double> areas; // of each leaf
  std::vector<Merge> merges;
  bool is_ultrametric = false; // no merge is less salient than one before it, and all are known
  bool is_complete = true;     // false: some cuts are lost, as no face was left for a side
  std::vector<std::size_t> node_of_leaf; // where nodes keep their numbers; otherwise empty

  std::size_t number_of_leaves() const { return areas.size(); }
};

// Replays the merges. `value` has a value for each leaf; for a merge of two sets, that of the union
// becomes join(k, a, b), where k is the number of the merge, and a and b are the values of the sets.
// Returns the sets that are left; `value` becomes theirs.
template <class Value, class Join>
Components replay(const Dendrogram& d, std::vector<Value>& value, const Join& join)
{
  Joined_sets sets(d.number_of_leaves());
  for (std::size_t k = 0; k < d.merges.size(); ++k) {
    if (!d.merges[k].is_cut())
      continue;
    const Index a = sets[d.merges[k].leaves[0]], b = sets[d.merges[k].leaves[1]];
    Value joined = join(k, std::as_const(value[a]), std::as_const(value[b]));
    CGAL_assertion_code(const bool were_apart =) sets.join(a, b);
    CGAL_assertion(were_apart);
    value[sets[a]] = std::move(joined);
  }
  const Components result = numbered_sets(sets, d.number_of_leaves());
  std::vector<Value> of_set(result.number);
  for (Index leaf = 0; leaf < d.number_of_leaves(); ++leaf)
    of_set[result[leaf]] = value[sets[leaf]];
  value = std::move(of_set);
  return result;
}

// Numbers labels from 0 on, in the order of their first faces, and returns the old ones.
template <class Label>
std::vector<Label> number_by_first_faces(std::vector<Label>& labels)
{
  std::vector<Label> old, number;
  for (Label& label : labels) {
    if (number.size() <= label)
      number.resize(label + 1, static_cast<Label>(-1));
    if (number[label] == static_cast<Label>(-1)) {
      number[label] = static_cast<Label>(old.size());
      old.push_back(label);
    }
    label = number[label];
  }
  return old;
}

// The dendrogram whose leaves are those of the components of a surface, without merges.
inline Dendrogram uncut_dendrogram(const Surface& surface)
{
  Dendrogram result;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    result.leaf.push_back(surface.components[f]);
  result.areas = component_areas(surface, surface.components);
  return result;
}

inline void set_areas(const Surface& surface, Dendrogram& d)
{
  std::fill(d.areas.begin(), d.areas.end(), 0.);
  for (std::size_t f = 0; f < d.leaf.size(); ++f)
    d.areas[d.leaf[f]] += surface.areas[f];
}

// Numbers the leaves by their first faces. Those without a face go, and the merges of which they are
// a side.
inline void number_leaves_by_first_faces(Dendrogram& d)
{
  std::vector<Index> number(d.number_of_leaves(), null_index);
  const std::vector<Index> old = number_by_first_faces(d.leaf);
  for (Index i = 0; i < old.size(); ++i)
    number[old[i]] = i;
  std::vector<Index> left = number; // of each set: one of its leaves
  std::vector<Merge> merges = d.merges;
  replay(d, left, [&](std::size_t k, Index a, Index b) {
    merges[k].leaves[0] = a;
    merges[k].leaves[1] = b;
    return a == null_index ? b : a;
  });
  for (Merge& m : merges)
    if (!m.is_cut())
      m.leaves[0] = m.leaves[1] = number[m.leaves[0]];
  const auto is_lost = [](const Merge& m)
  { return m.leaves[0] == null_index || m.leaves[1] == null_index; };
  merges.erase(std::remove_if(merges.begin(), merges.end(), is_lost), merges.end());
  d.is_complete = d.is_complete && old.size() == d.number_of_leaves();
  d.merges = std::move(merges);
  std::vector<double> areas;
  for (Index leaf : old)
    areas.push_back(d.areas[leaf]);
  d.areas = std::move(areas);
}

// Returns what contains each leaf, then what contains each merge: the number of a merge, counted
// after the leaves; null_node if nothing does.
inline std::vector<std::size_t> parents(const Dendrogram& d)
{
  const std::size_t leaves = d.number_of_leaves();
  std::vector<std::size_t> result(leaves + d.merges.size(), null_node), top(leaves);
  std::iota(top.begin(), top.end(), std::size_t(0));
  replay(d, top, [&](std::size_t k, std::size_t a, std::size_t b)
    { return result[a] = result[b] = leaves + k; });
  return result;
}

// Raises each salience to the largest of the merges within, and brings the merges in the order of
// their saliences.
inline void make_ultrametric(Dendrogram& d)
{
  std::vector<double> largest(d.number_of_leaves(), -std::numeric_limits<double>::infinity());
  std::vector<Merge> merges = d.merges;
  replay(d, largest, [&](std::size_t k, double a, double b)
    { return merges[k].salience = (std::max)({merges[k].salience, a, b}); });
  std::stable_sort(merges.begin(), merges.end(),
                   [](const Merge& a, const Merge& b) { return a.salience < b.salience; });
  d.merges = std::move(merges);
  d.is_ultrametric = true;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DENDROGRAM_DENDROGRAM_H
