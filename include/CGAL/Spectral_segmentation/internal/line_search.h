// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LINE_SEARCH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LINE_SEARCH_H

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/Cut.h>
#include <CGAL/Spectral_segmentation/internal/Face_dual_graph.h>
#include <CGAL/Spectral_segmentation/internal/Meta_patch.h>
#include <CGAL/Spectral_segmentation/internal/parts.h>

#include <cstddef>
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
inline Growth grow_along(const Face_dual_graph& part, const std::vector<Index>& line)
{
  enum Label : char { NOT_VISITED, WAITING, JOINED };
  std::vector<Label> label(part.number_of_faces(), NOT_VISITED);
  Growth q;
  q.faces.reserve(line.size());
  for (Index visited : line) {
    label[visited] = WAITING;
    bool touches = q.faces.empty();
    for (Index h = 3 * visited; h < 3 * visited + 3; ++h)
      touches = touches || label[part.halfedges[h].neighbor] == JOINED;
    if (!touches)
      continue;
    std::size_t next = q.faces.size();
    label[visited] = JOINED;
    q.faces.push_back(visited);
    for (; next < q.faces.size(); ++next)
      for (Index h = 3 * q.faces[next]; h < 3 * q.faces[next] + 3; ++h) {
        const Index g = part.halfedges[h].neighbor;
        if (label[g] == WAITING) {
          label[g] = JOINED;
          q.faces.push_back(g);
        }
      }
    q.sizes.push_back(static_cast<Index>(q.faces.size()));
  }
  return q;
}

// For each number i of faces, whether the part is still connected without the first i of `faces`,
// that is, whether Q has no holes. Takes the faces back from last to first, with union-find.
inline std::vector<bool> rest_is_connected(const Face_dual_graph& part,
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
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = part.halfedges[h].neighbor;
      if (is_in_rest[g])
        components.join(f, g);
    }
    result[i] = components.number() == 1;
  }
  return result;
}

// Adds the faces to the empty patch Q, and calls `visit(q, size of q)` after each step that leaves
// two connected sides, both with an area, and not below `minimum_area`. Ends once it returns false.
template <class Patch, class Visit>
void visit_cuts(const Face_dual_graph& part, const Growth& growth, double minimum_area, Patch q,
                const Visit& visit)
{
  const std::vector<bool> is_cut = rest_is_connected(part, growth.faces);
  // What the subtraction of areas leaves where the rest has none.
  const double rounding = 1e-12 * q.area_of_part();
  std::size_t size = 0;
  for (Index size_after_step : growth.sizes) {
    for (; size < size_after_step; ++size)
      q.add(growth.faces[size]);
    if (is_cut[size] && q.smaller_area() > rounding && q.smaller_area() >= minimum_area &&
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
// `observe(size of Q, factors, salience)` hears of each cut that is compared.
template <class PartSalience, class Observer = No_observer>
std::optional<Cut> line_search(const Face_dual_graph& part, const std::vector<Index>& line,
                               const PartSalience& part_salience, double minimum_area,
                               const Observer& observe = Observer())
{
  const Growth growth = grow_along(part, line);
  std::size_t best_size = 0;
  Cut best;
  double best_on_grid = -std::numeric_limits<double>::infinity();
  const auto visit = [&](const Meta_patch& q, std::size_t size) {
    const Salience_factors factors = q.factors();
    const double salience = part_salience(factors);
    observe(size, factors, salience);
    // On the grid, so that rounding does not choose between cuts that mirror each other.
    if (on_grid(salience) > best_on_grid) {
      best_on_grid = on_grid(salience);
      best = {{}, {q.area(), q.area_of_rest()}, factors, salience};
      best_size = size;
    }
    return true;
  };
  visit_cuts(part, growth, minimum_area, Meta_patch(part), visit);
  if (best_size == 0)
    return std::nullopt;
  best.side = sides_of(growth, best_size);
  put_smaller_side_first(best.side, best.area);
  return best;
}

} // namespace internal
} // namespace Spectral_segmentation
} // namespace CGAL

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LINE_SEARCH_H
