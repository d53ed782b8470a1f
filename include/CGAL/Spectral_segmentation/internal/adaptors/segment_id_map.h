// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENT_ID_MAP_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENT_ID_MAP_H

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL::Spectral_segmentation::internal {

template <class Map, class = void>
struct is_any_property_map : std::false_type {};

template <class Map>
struct is_any_property_map<Map, std::void_t<typename boost::property_traits<Map>::key_type> >
  : std::true_type {};

// Whether a map takes keys of this type. A map that takes keys of any type has the key type `void`.
template <class Key, class MapKey>
using is_key_of = std::bool_constant<std::is_void<MapKey>::value ||
                                     std::is_convertible<Key, MapKey>::value>;

template <class Id>
using is_segment_id =
  std::bool_constant<std::is_integral<Id>::value && !std::is_same<Id, bool>::value>;

// Returns whether a caller's map assigns ids to faces. If not, a static_assert reports why. The
// calling functions then leave out the code that uses the map, because it would add further errors.
template <class Face, class SegmentIdMap>
constexpr bool is_segment_id_map()
{
  constexpr bool is_map = is_any_property_map<SegmentIdMap>::value;
  static_assert(is_map, "the segment ids are given by a property map: for a std::map m that is "
                        "boost::make_assoc_property_map(m), for a std::vector v of the ids of "
                        "faces with the numbers 0, 1, ... CGAL::make_property_map(v)");
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

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_ADAPTORS_SEGMENT_ID_MAP_H
