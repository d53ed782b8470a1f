// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_COMPONENTS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_COMPONENTS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

// Sets of elements that are joined, by BGL's union-find. At first each element is a set.
class Joined_sets
{
  typedef boost::typed_identity_property_map<Index> Element;
  typedef boost::iterator_property_map<std::vector<Index>::iterator, Element> Map;

  std::vector<Index> rank_, parent_;
  boost::disjoint_sets<Map, Map> sets_;

public:
  explicit Joined_sets(std::size_t number_of_elements)
    : rank_(number_of_elements), parent_(number_of_elements),
      sets_(Map(rank_.begin(), Element()), Map(parent_.begin(), Element()))
  {
    for (Index i = 0; i < number_of_elements; ++i)
      sets_.make_set(i);
  }

  // The sets look into the vectors, whose memory moves with them.
  Joined_sets(const Joined_sets&) = delete;
  Joined_sets(Joined_sets&&) = default;

  Index operator[](Index i) { return sets_.find_set(i); } // an element that stands for the set

  // Returns whether the two were apart.
  bool join(Index i, Index j)
  {
    const Index a = sets_.find_set(i), b = sets_.find_set(j);
    if (a != b)
      sets_.link(a, b);
    return a != b;
  }
};

// The sets of all elements, numbered by their first elements.
inline Components numbered_sets(Joined_sets& sets, std::size_t number_of_elements)
{
  Components result{0, std::vector<Index>(number_of_elements)};
  std::vector<Index> number(number_of_elements, null_index); // of the element that stands for a set
  for (Index i = 0; i < number_of_elements; ++i) {
    Index& of_set = number[sets[i]];
    if (of_set == null_index)
      of_set = static_cast<Index>(result.number++);
    result.of_face[i] = of_set;
  }
  if (result.number == 1)
    result.of_face.clear();
  return result;
}

// Faces are connected with their neighbors of equal `label(face)`. A fifth of the time of BGL's
// depth-first search.
template <class Label>
Components connected_components(const Surface& surface, const Label& label)
{
  Joined_sets sets(surface.number_of_faces());
  for (Index h = 0; h < surface.number_of_halfedges(); ++h)
    if (h < surface.opposite[h] && label(h / 3) == label(surface.neighbor(h)))
      sets.join(h / 3, surface.neighbor(h));
  return numbered_sets(sets, surface.number_of_faces());
}

inline Components connected_components(const Surface& surface)
{ return connected_components(surface, [](Index) { return 0; }); }

inline std::vector<double> component_areas(const Surface& surface, const Components& components)
{
  std::vector<double> areas(components.number, 0);
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    areas[components[f]] += surface.areas[f];
  return areas;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_SURFACE_CONNECTED_COMPONENTS_H
