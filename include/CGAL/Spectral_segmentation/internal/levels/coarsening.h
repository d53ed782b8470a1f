// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H

#include <CGAL/Spectral_segmentation/internal/levels/Edge_collapse.h>
#include <CGAL/Spectral_segmentation/internal/levels/Level.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// A surface of the same shape and topology with fewer faces, all of about the same size. A face of
// the finer one has shares in the leaves around the images of its corners.
class Coarse_level : public Level
{
  std::vector<Index> vertex_; // of the surface, which each vertex of the finer one became

public:
  // At most `number_of_faces` are left, as far as the topology allows; or, if some more will do,
  // those at the seams of domains as well.
  Coarse_level(Execution execution, const Surface& finer, std::size_t number_of_faces,
               bool more_will_do, Run_monitor& monitor, double progress_per_face)
    : Level(finer)
  {
    Edge_collapse collapse(execution, finer, monitor, progress_per_face);
    collapse(number_of_faces, more_will_do);
    surface_ = collapse.surface(vertex_);
  }

  std::function<Shares(Index)> shares(const std::vector<Index>& leaf) const override
  {
    std::vector<Shares> around(surface_.points.size());
    for (Index f = 0; f < leaf.size(); ++f)
      for (Index v : surface_.corners[f])
        around[v].add(leaf[f], 1);
    return [this, around = std::move(around)](Index face) {
      Shares result;
      for (Index v : finer_.corners[face])
        for (const auto& [leaf, number] : around[vertex_[v]])
          result.add(leaf, number);
      return result;
    };
  }
};

// Adds coarser and coarser levels, in steps that leave about a sixteenth of the faces: so the bands
// between the sides of cuts, which are as wide as the larger faces, stay small parts of each.
inline void add_coarse_levels(Execution execution, const Surface& finest,
                              std::size_t number_of_faces, Run_monitor& monitor,
                              std::vector<std::unique_ptr<Level> >& levels)
{
  constexpr std::size_t step = 16;
  const std::size_t all = finest.number_of_faces();
  std::vector<std::size_t> numbers(1, number_of_faces);
  while (numbers.back() < all / (2 * step))
    numbers.push_back(step * numbers.back());
  const double progress_per_face = 1 / static_cast<double>(all - number_of_faces);
  const Surface* finer = &finest;
  for (; !numbers.empty(); numbers.pop_back()) {
    levels.push_back(std::make_unique<Coarse_level>(execution, *finer, numbers.back(),
                                                    numbers.size() > 1, monitor,
                                                    progress_per_face));
    finer = &levels.back()->surface();
  }
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_LEVELS_COARSENING_H
