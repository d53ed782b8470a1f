// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_SEGMENT_IDS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_SEGMENT_IDS_H

#include <CGAL/Spectral_segmentation/internal/base/arrays.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace CGAL::Spectral_segmentation::internal {

template <class Map, class = void>
struct is_any_property_map : std::false_type {};

template <class Map>
struct is_any_property_map<Map, std::void_t<typename boost::property_traits<Map>::key_type> >
  : std::true_type {};

// A map that is asked for no key in particular has the key type `void`.
template <class Key, class MapKey>
using is_key_of = std::bool_constant<std::is_void<MapKey>::value ||
                                     std::is_convertible<Key, MapKey>::value>;

template <class Id>
using is_segment_id =
  std::bool_constant<std::is_integral<Id>::value && !std::is_same<Id, bool>::value>;

// Whether a caller's map gives ids to faces. If not, a sentence says why, and functions that ask
// leave out what uses the map: it would add the errors of its body.
template <class Face, class SegmentIdMap>
constexpr bool is_segment_id_map()
{
  constexpr bool is_map = is_any_property_map<SegmentIdMap>::value;
  static_assert(is_map, "the segment ids are given by a property map: for a std::map m that is "
                        "boost::make_assoc_property_map(m)");
  if constexpr (is_map) {
    typedef boost::property_traits<SegmentIdMap> Traits;
    constexpr bool has_faces = is_key_of<Face, typename Traits::key_type>::value;
    constexpr bool has_ids = is_segment_id<typename Traits::value_type>::value;
    static_assert(has_faces, "the keys of the segment id map must be the faces of the mesh, or the "
                             "positions of triangles");
    static_assert(has_ids, "the values of the segment id map must be of an integer type");
    return has_faces && has_ids;
  }
  else {
    return false;
  }
}

// Any numbers as labels from 0 on, in the order of the numbers, which are returned.
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

// The same of the faces of a mesh.
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

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_DOOR_SEGMENT_IDS_H
