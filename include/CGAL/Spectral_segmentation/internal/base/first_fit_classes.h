// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_FIRST_FIT_CLASSES_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_FIRST_FIT_CLASSES_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Groups elements into classes whose members are all alike, although being alike is not transitive.
// One after the other, each element joins the first class all of whose members it is like.
template <class AreAlike>
std::vector<std::vector<std::size_t> >
first_fit_classes(const std::vector<std::size_t>& elements, const AreAlike& are_alike)
{
  std::vector<std::vector<std::size_t> > classes;
  for (std::size_t e : elements) {
    const auto fits = [&](const std::vector<std::size_t>& members) {
      return std::all_of(members.begin(), members.end(),
                         [&](std::size_t member) { return are_alike(e, member); });
    };
    const auto found = std::find_if(classes.begin(), classes.end(), fits);
    if (found != classes.end())
      found->push_back(e);
    else
      classes.push_back({e});
  }
  return classes;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_FIRST_FIT_CLASSES_H
