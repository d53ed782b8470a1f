// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_REPORT_H
#define SEGMENT_MESH_REPORT_H

#include "Run_watch.h"
#include "read_input.h"

#include <CGAL/Spectral_segmentation/IO/hierarchy_json.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <vector>

namespace segment_mesh {

typedef nlohmann::ordered_json Json;

// Seconds of the program by phase, and of the segmentation by stage, as in Table 1 of Zhang and Liu
// 2005. The stages are sums over all parts; with several threads parts are searched at the same
// time, and the sums may exceed the segmentation.
inline Json seconds_report(const Run_watch& watch)
{
  return {{"reading", watch.seconds("reading")},
          {"joining", watch.seconds("joining")},
          {"initialization", watch.seconds(Run_watch::Stage::INITIALIZATION)},
          {"sampling", watch.seconds(Run_watch::Stage::SAMPLING)},
          {"embedding", watch.seconds(Run_watch::Stage::EMBEDDING)},
          {"line_search", watch.seconds(Run_watch::Stage::LINE_SEARCH)},
          {"merging", watch.seconds(Run_watch::Stage::MERGING)},
          {"projection", watch.seconds(Run_watch::Stage::PROJECTION)},
          {"smooth_boundaries", watch.seconds(Run_watch::Stage::BOUNDARY_SMOOTHING)},
          {"segmentation", watch.seconds("segmentation")},
          {"writing", watch.seconds("writing")},
          {"total", watch.seconds()}};
}

// The hierarchy with the segments of the run. Faces are the triangles of the input.
inline Json hierarchy_report(const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                             const Input& input, const std::vector<Index>& label_of_triangle)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  const std::vector<std::size_t> nodes = hierarchy.nodes();
  const std::vector<std::size_t> labels(label_of_triangle.begin(), label_of_triangle.end());
  return internal::json_of_hierarchy(
    hierarchy, nodes, labels,
    internal::segment_extents(input.soup.points, input.triangles, labels, nodes.size()));
}

// The same with the leaf of each face; if there are larger polygons, also with their numbers.
inline void write_hierarchy(std::ostream& out,
                            const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                            const Input& input, const std::vector<Index>& label_of_triangle)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  Json json = hierarchy_report(hierarchy, input, label_of_triangle);
  internal::add_faces(hierarchy, json);
  if (input.triangles.size() != input.soup.number_of_polygons())
    json["input_face_of_face"] = input.polygon_of_triangle;
  internal::write_json(out, json);
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_REPORT_H
