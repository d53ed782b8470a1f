// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_LINE_SEARCH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_LINE_SEARCH_H

#include <CGAL/Spectral_segmentation/internal/salience/Patch.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// The line search of Section 5.3.

// The growth of Q along the line: the faces in the order in which they join Q, and the sizes of Q
// after each visited face that joined, together with all faces that waited for it.
struct Growth
{
  std::vector<Index> faces;
  std::vector<Index> sizes;
};

// Grows Q along an order. A visited face that does not touch Q waits, with a special label, until a
// face that it touches joins Q.
inline Growth grow_along(const Surface& part, const std::vector<Index>& order)
{
  enum Label : char { NOT_VISITED, WAITING, JOINED };
  std::vector<Label> label(part.number_of_faces(), NOT_VISITED);
  Growth q;
  q.faces.reserve(order.size());
  q.sizes.reserve(order.size());
  for (Index visited : order) {
    label[visited] = WAITING;
    bool touches = q.faces.empty();
    for (Index h = 3 * visited; h < 3 * visited + 3; ++h)
      touches = touches || label[part.neighbor(h)] == JOINED;
    if (!touches)
      continue;
    std::size_t next = q.faces.size();
    label[visited] = JOINED;
    q.faces.push_back(visited);
    for (; next < q.faces.size(); ++next)
      for (int i = 0; i < 3; ++i) {
        const Index g = part.neighbor(3 * q.faces[next] + i);
        if (label[g] == WAITING) {
          label[g] = JOINED;
          q.faces.push_back(g);
        }
      }
    q.sizes.push_back(static_cast<Index>(q.faces.size()));
  }
  return q;
}

// Returns for each number i whether the part is still connected without the first i of `faces`,
// that is, whether Q has no holes. Adds the faces back from last to first, with union-find.
inline std::vector<bool> rest_is_connected(const Surface& part,
                                           const std::vector<Index>& faces)
{
  const std::size_t n = faces.size();
  Disjoint_sets components(n);
  std::vector<char> is_in_rest(n, 0);
  std::vector<bool> result(n + 1, false);
  for (std::size_t i = n; i-- > 0;) {
    const Index f = faces[i];
    is_in_rest[f] = 1;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (is_in_rest[part.neighbor(h)])
        components.join(f, part.neighbor(h));
    result[i] = components.number() == i + 1; // the first i faces are not joined yet
  }
  return result;
}

// Returns the sizes of Q after the steps that leave two connected sides.
inline std::vector<Index> sizes_of_cuts(const Surface& part, const Growth& growth)
{
  const std::vector<bool> is_cut = rest_is_connected(part, growth.faces);
  std::vector<Index> result;
  result.reserve(growth.sizes.size());
  std::copy_if(growth.sizes.begin(), growth.sizes.end(), std::back_inserter(result),
               [&](Index size) { return is_cut[size]; });
  return result;
}

// Adds faces to the empty patch Q. Calls `visit(q, size of q)` at each of the sizes, which ascend,
// where both sides have an area, and not below `minimum_area`. Ends once `visit` returns false.
template <class AnyPatch, class Visit>
void for_each_cut(const std::vector<Index>& faces, const std::vector<Index>& sizes,
                  double minimum_area, AnyPatch q, const Visit& visit)
{
  // Rounding may leave this area for a rest that has none.
  const double rounding = 1e-12 * q.area_of_part();
  Index size = 0;
  for (Index size_of_cut : sizes) {
    for (; size < size_of_cut; ++size) {
      if (size + 8 < faces.size())
        q.prefetch_face(faces[size + 8]);
      q.add(faces[size]);
    }
    if (q.smaller_area() > rounding && q.smaller_area() >= minimum_area &&
        !visit(std::as_const(q), size))
      return;
  }
}

// Returns 0 for the first faces that joined Q, 1 for the others.
inline Sides sides_of(const Growth& growth, std::size_t size)
{
  Sides side(growth.faces.size(), 1);
  for (std::size_t i = 0; i < size; ++i)
    side[growth.faces[i]] = 0;
  return side;
}

// The most salient cut that a sweep from one end of an order meets.
struct Swept_cut
{
  Index size = 0; // the size of the patch; 0: there is no cut
  double area = 0, area_of_rest = 0;
  Salience_factors factors;
  double salience = -std::numeric_limits<double>::infinity();
};

// Returns the most salient cut; ties go to the first or the last that the sweep meets. Saliences
// are compared as quantized, so that rounding does not choose between cuts that mirror each other.
template <class PartSalience>
Swept_cut sweep(const std::vector<Index>& faces, const std::vector<Index>& sizes,
                double minimum_area, const Patch& empty,
                const PartSalience& part_salience, bool takes_last)
{
  Swept_cut best;
  double best_key = best.salience;
  for_each_cut(
    faces, sizes, minimum_area, empty, [&](const Patch& patch, Index size) {
      const Salience_factors factors = patch.factors();
      const double salience = salience_of(part_salience, factors);
      const double key = quantized(salience);
      if (key > best_key || (takes_last && key == best_key)) {
        best = {size, patch.area(), patch.area_of_rest(), factors, salience};
        best_key = key;
      }
      return true;
    });
  return best;
}

// Returns the most salient cut along an order, if there is one; ties go to the first. A cut of Q is
// also a cut of the rest. Therefore the second half of the faces is swept from the other end, so
// that each patch stays the smaller half.
template <class PartSalience>
std::optional<Cut> line_search(Execution execution, const Surface& part,
                               const std::vector<Index>& order, const PartSalience& part_salience,
                               double minimum_area)
{
  const Index n = static_cast<Index>(part.number_of_faces());
  Growth growth;
  std::vector<Index> sizes[2]; // sizes of Q, and of the rest
  std::optional<Patch> empty;
  call_all(execution, [&] { empty.emplace(part); }, [&] {
    growth = grow_along(part, order);
    for (Index size : sizes_of_cuts(part, growth))
      sizes[size <= n / 2 ? 0 : 1].push_back(size <= n / 2 ? size : n - size);
    std::reverse(sizes[1].begin(), sizes[1].end());
  });

  Swept_cut cut_of_q, cut_of_rest;
  const std::vector<Index> from_end(growth.faces.rbegin(), growth.faces.rend());
  for_each_index(execution, 2, [&](std::size_t half) {
    (half == 0 ? cut_of_q : cut_of_rest) =
      sweep(half == 0 ? growth.faces : from_end, sizes[half], minimum_area, *empty, part_salience,
            half == 1);
  });
  const bool is_rest_better = quantized(cut_of_rest.salience) > quantized(cut_of_q.salience);
  const Swept_cut& best = is_rest_better ? cut_of_rest : cut_of_q;
  if (best.size == 0)
    return std::nullopt;
  Cut cut{sides_of(growth, is_rest_better ? n - best.size : best.size),
          {best.area, best.area_of_rest}, best.factors, best.salience};
  if (is_rest_better)
    std::swap(cut.area[0], cut.area[1]);
  normalize_sides(cut.side, cut.area);
  return cut;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SEARCH_LINE_SEARCH_H
