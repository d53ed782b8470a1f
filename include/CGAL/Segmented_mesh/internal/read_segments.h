// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_READ_SEGMENTS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_READ_SEGMENTS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/read/numbered_descriptors.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Maps arbitrary ids to the labels 0, 1, ... in ascending order; returns the sorted ids.
template <class Id>
std::vector<Id> labels_of_ids(const std::vector<Id>& id_of_face, std::vector<Index>& labels)
{
  static_assert(is_segment_id<Id>::value, "the ids of segments must be of an integer type");
  std::vector<Id> ids = id_of_face;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  labels.reserve(id_of_face.size());
  for (Id id : id_of_face)
    labels.push_back(
      static_cast<Index>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()));
  return ids;
}

// Maps the ids of the faces of a mesh to labels, and returns the sorted ids.
template <class FaceDescriptor, class SegmentIdMap>
std::vector<typename boost::property_traits<SegmentIdMap>::value_type>
read_segments(const std::vector<FaceDescriptor>& faces, SegmentIdMap segment_ids,
              std::vector<Index>& labels)
{
  std::vector<typename boost::property_traits<SegmentIdMap>::value_type> id_of_face;
  id_of_face.reserve(faces.size());
  if constexpr (is_segment_id_map<FaceDescriptor, SegmentIdMap>()) {
    for (const FaceDescriptor& f : faces)
      id_of_face.push_back(get(segment_ids, f));
  }
  return labels_of_ids(id_of_face, labels);
}

// Maps the ids of a number of triangles to labels, and returns the sorted ids. Throws
// `std::invalid_argument` if there are more or fewer ids. The message begins with `function`, the
// name of the function that the caller called.
template <class SegmentIdRange>
std::vector<typename SegmentIdRange::value_type>
read_segments(std::size_t number_of_triangles, const SegmentIdRange& segment_ids,
              std::vector<Index>& labels, const std::string& function)
{
  if (segment_ids.size() != number_of_triangles)
    throw std::invalid_argument(function + ": there must be an id for each triangle");
  return labels_of_ids(
    std::vector<typename SegmentIdRange::value_type>(segment_ids.begin(), segment_ids.end()),
    labels);
}

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_READ_SEGMENTS_H
