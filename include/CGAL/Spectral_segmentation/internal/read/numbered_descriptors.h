// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_NUMBERED_DESCRIPTORS_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_NUMBERED_DESCRIPTORS_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

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

// Numbers the elements of a vector of descriptors by their position. Looks a descriptor up by the
// mesh's own index map if that is usable, otherwise by its hash: ids may be unset, or have gaps
// after a removal. Stores nothing in the mesh, so that several threads may segment the same mesh.
// Only a `Face_filtered_graph` fills its own index maps when they are first requested.
template <class TriangleMesh, class IndexTag, class Descriptor>
class Descriptor_numbers
{
  static constexpr bool has_index_map =
    CGAL::graph_has_property<TriangleMesh, IndexTag>::value;

  typename CGAL::property_map_selector<TriangleMesh, IndexTag>::const_type index_map_;
  std::size_t number_of_equal_ = 0; // if not 0, each number is the index
  std::vector<Index> by_index_;
  std::unordered_map<Descriptor, Index> by_hash_;

  bool fill_by_index(const std::vector<Descriptor>& descriptors)
  {
    if constexpr (has_index_map) {
      const std::size_t limit = 16 * descriptors.size() + 65536;
      std::size_t size = 0, number_of_equal = 0;
      for (const Descriptor& d : descriptors) {
        const auto i = static_cast<std::size_t>(get(index_map_, d));
        if (i >= limit)
          return false;
        number_of_equal += number_of_equal == i;
        size = (std::max)(size, i + 1);
      }
      if (number_of_equal == descriptors.size()) {
        number_of_equal_ = number_of_equal;
        return true;
      }
      by_index_.assign(size, null_index);
      for (std::size_t number = 0; number < descriptors.size(); ++number) {
        Index& entry = by_index_[static_cast<std::size_t>(get(index_map_, descriptors[number]))];
        if (entry != null_index)
          return false;
        entry = static_cast<Index>(number);
      }
      return true;
    }
    else {
      return descriptors.empty();
    }
  }

public:
  Descriptor_numbers(const TriangleMesh& mesh, const std::vector<Descriptor>& descriptors)
    : index_map_(CGAL::get_const_property_map(IndexTag(), mesh))
  {
    if (fill_by_index(descriptors))
      return;
    by_index_.clear();
    by_hash_.reserve(descriptors.size());
    for (std::size_t number = 0; number < descriptors.size(); ++number)
      by_hash_.emplace(descriptors[number], static_cast<Index>(number));
  }

  // Returns the position of a descriptor; `null_index` if it was not numbered.
  Index operator()(const Descriptor& d) const
  {
    if constexpr (has_index_map) {
      if (number_of_equal_ > 0 || !by_index_.empty()) {
        const auto i = static_cast<std::size_t>(get(index_map_, d));
        if (number_of_equal_ > 0)
          return i < number_of_equal_ ? static_cast<Index>(i) : null_index;
        return i < by_index_.size() ? by_index_[i] : null_index;
      }
    }
    const auto found = by_hash_.find(d);
    return found == by_hash_.end() ? null_index : found->second;
  }
};

// Returns the faces in the order of their indices, which is the order of `faces(mesh)` or of the
// caller's index map. Throws `std::invalid_argument` if the map is not one to one onto 0 .. n-1.
// The message begins with `function`, the name of the function that the caller called.
template <class TriangleMesh, class CGALNamedParameters>
std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor>
numbered_faces(const TriangleMesh& mesh, const CGALNamedParameters& np,
               const std::string& function = "segment_spectral_recursive")
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  std::vector<face_descriptor> result;
  result.reserve(num_faces(mesh));
  for (face_descriptor f : faces(mesh))
    result.push_back(f);
  if (result.size() >= null_index / 3)
    throw std::invalid_argument(function + ": the mesh has too many faces");

  if constexpr (!CGAL::parameters::is_default_parameter<
                  CGALNamedParameters, CGAL::internal_np::face_index_t>::value) {
    const auto map = CGAL::parameters::get_parameter(np, CGAL::internal_np::face_index);
    std::vector<face_descriptor> by_index(result.size());
    std::vector<char> is_set(result.size(), 0);
    for (face_descriptor f : result) {
      const auto i = static_cast<std::size_t>(get(map, f));
      if (i >= result.size() || is_set[i])
        throw std::invalid_argument(function + ": face_index_map must give each face its own "
                                    "index from 0 to the number of faces - 1");
      by_index[i] = f;
      is_set[i] = 1;
    }
    result = std::move(by_index);
  }
  return result;
}

inline void check_number_of_faces(std::size_t mesh_size, std::size_t hierarchy_size)
{
  if (mesh_size != hierarchy_size)
    throw std::invalid_argument("Segmentation_hierarchy: this mesh has another number of faces");
}

// Writes the labels of the faces to the map of the caller and returns the number of labels. Throws
// `std::overflow_error`, before it writes, if the value type of the map cannot hold the labels.
template <class FaceDescriptor, class SegmentIdMap>
std::size_t write_labels(const std::vector<FaceDescriptor>& faces,
                         const std::vector<std::size_t>& labels, SegmentIdMap segment_ids)
{
  check_number_of_faces(faces.size(), labels.size());
  const std::size_t n =
    labels.empty() ? 0 : 1 + *std::max_element(labels.begin(), labels.end());
  if constexpr (is_segment_id_map<FaceDescriptor, SegmentIdMap>()) {
    using boost::put; // finds the overload for pointers
    typedef typename boost::property_traits<SegmentIdMap>::value_type Id;
    if (n > 0 && n - 1 > static_cast<std::size_t>((std::numeric_limits<Id>::max)()))
      throw std::overflow_error("segment_spectral_recursive: the type of the segment ids is too "
                                "small for the number of segments");
    for (std::size_t i = 0; i < faces.size(); ++i)
      put(segment_ids, faces[i], static_cast<Id>(labels[i]));
  }
  return n;
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_READ_NUMBERED_DESCRIPTORS_H
