// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LINE_SEARCH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LINE_SEARCH_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Meta_patch.h>
#include <CGAL/Spectral_segmentation/internal/concurrency.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spectral_segmentation {
namespace internal {

// The line search of Section 5.3.

// How Q grows along the line: the faces in the order in which they join Q, and the sizes of Q after
// each visited face that joined, together with all that had waited for it.
struct Growth
{
  std::vector<Index> faces;
  std::vector<Index> sizes;
};

// A visited face that does not touch Q waits, with a special label, until a face that it touches
// joins Q.
inline Growth grow_along(const std::vector<Neighbors>& neighbors, const std::vector<Index>& line)
{
  enum Label : char { NOT_VISITED, WAITING, JOINED };
  std::vector<Label> label(neighbors.size(), NOT_VISITED);
  Growth q;
  q.faces.reserve(line.size());
  q.sizes.reserve(line.size());
  for (Index visited : line) {
    label[visited] = WAITING;
    bool touches = q.faces.empty();
    for (Index g : neighbors[visited])
      touches = touches || label[g] == JOINED;
    if (!touches)
      continue;
    std::size_t next = q.faces.size();
    label[visited] = JOINED;
    q.faces.push_back(visited);
    for (; next < q.faces.size(); ++next)
      for (Index g : neighbors[q.faces[next]])
        if (label[g] == WAITING) {
          label[g] = JOINED;
          q.faces.push_back(g);
        }
    q.sizes.push_back(static_cast<Index>(q.faces.size()));
  }
  return q;
}

// For each number i of faces, whether the part is still connected without the first i of `faces`,
// that is, whether Q has no holes. Takes the faces back from last to first, with union-find.
inline std::vector<bool> rest_is_connected(const std::vector<Neighbors>& neighbors,
                                           const std::vector<Index>& faces)
{
  const std::size_t n = faces.size();
  Face_components components(n);
  std::vector<char> is_in_rest(n, 0);
  std::vector<bool> result(n + 1, false);
  for (std::size_t i = n; i-- > 0;) {
    const Index f = faces[i];
    components.add(f);
    is_in_rest[f] = 1;
    for (Index g : neighbors[f])
      if (is_in_rest[g])
        components.join(f, g);
    result[i] = components.number() == 1;
  }
  return result;
}

// The sizes of Q after the steps that leave two connected sides.
inline std::vector<Index> sizes_of_cuts(const std::vector<Neighbors>& neighbors,
                                        const Growth& growth)
{
  const std::vector<bool> is_cut = rest_is_connected(neighbors, growth.faces);
  std::vector<Index> result;
  result.reserve(growth.sizes.size());
  std::copy_if(growth.sizes.begin(), growth.sizes.end(), std::back_inserter(result),
               [&](Index size) { return is_cut[size]; });
  return result;
}

// Adds faces to the empty patch Q, and calls `visit(q, size of q)` at each of the sizes, which
// ascend, where both sides have an area, and not below `minimum_area`. Ends once it returns false.
template <class FaceIterator, class Patch, class Visit>
void visit_cuts(FaceIterator first_face, FaceIterator end, const std::vector<Index>& sizes,
                double minimum_area, Patch q, const Visit& visit)
{
  // What the subtraction of areas leaves where the rest has none.
  const double rounding = 1e-12 * q.area_of_part();
  Index size = 0;
  for (Index size_of_cut : sizes) {
    for (; size < size_of_cut; ++size) {
      if (end - first_face > size + 8)
        q.prefetch_face(first_face[size + 8]);
      q.add(first_face[size]);
    }
    if (q.smaller_area() > rounding && q.smaller_area() >= minimum_area &&
        !visit(std::as_const(q), size))
      return;
  }
}

// 0 for the first faces that joined Q, 1 for the others.
inline Sides sides_of(const Growth& growth, std::size_t size)
{
  Sides side(growth.faces.size(), 1);
  for (std::size_t i = 0; i < size; ++i)
    side[growth.faces[i]] = 0;
  return side;
}

// The most salient cut along the line, if there is one. Of equally salient cuts the first is taken.
// A cut of Q is one of the rest, too: the second half of the faces is taken from the end of the
// line, in another thread. `observe(size of Q, factors, salience)` hears of each cut that is
// compared, in each half from the end to the middle and in its thread.
template <class ConcurrencyTag, class PartSalience, class Observer = No_observer>
std::optional<Cut> line_search(const Face_dual_graph& part, const std::vector<Index>& line,
                               const PartSalience& part_salience, double minimum_area,
                               const Observer& observe = Observer())
{
  const Index n = static_cast<Index>(part.number_of_faces());
  Growth growth;
  std::vector<Index> sizes[2]; // of Q, and of the rest
  std::optional<Meta_patch> empty;
  for_each_index<ConcurrencyTag>(2, [&](std::size_t task) {
    if (task == 0) {
      empty.emplace(part);
      return;
    }
    const std::vector<Neighbors> neighbors_of_faces = neighbors(part);
    growth = grow_along(neighbors_of_faces, line);
    for (Index size : sizes_of_cuts(neighbors_of_faces, growth))
      sizes[size <= n / 2 ? 0 : 1].push_back(size <= n / 2 ? size : n - size);
    std::reverse(sizes[1].begin(), sizes[1].end());
  });

  struct Best
  {
    Index size_of_q = 0;
    Cut cut;
    double on_grid = -std::numeric_limits<double>::infinity();
  } best[2];
  for_each_index<ConcurrencyTag>(2, [&](std::size_t half) {
    const auto visit = [&, half](const Meta_patch& patch, Index size) {
      const Index size_of_q = half == 0 ? size : n - size;
      const Salience_factors factors = patch.factors();
      const double salience = part_salience(factors);
      observe(size_of_q, factors, salience);
      // On the grid, so that rounding does not choose between cuts that mirror each other.
      Best& b = best[half];
      if (on_grid(salience) > b.on_grid || (half == 1 && on_grid(salience) == b.on_grid)) {
        b = {size_of_q, {{}, {patch.area(), patch.area_of_rest()}, factors, salience},
             on_grid(salience)};
        if (half == 1)
          std::swap(b.cut.area[0], b.cut.area[1]);
      }
      return true;
    };
    if (half == 0)
      visit_cuts(growth.faces.begin(), growth.faces.end(), sizes[0], minimum_area, *empty, visit);
    else
      visit_cuts(growth.faces.rbegin(), growth.faces.rend(), sizes[1], minimum_area, *empty, visit);
  });
  Best& b = best[best[1].on_grid > best[0].on_grid ? 1 : 0];
  if (b.size_of_q == 0)
    return std::nullopt;
  b.cut.side = sides_of(growth, b.size_of_q);
  put_smaller_side_first(b.cut.side, b.cut.area);
  return std::move(b.cut);
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LINE_SEARCH_H
