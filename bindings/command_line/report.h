// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_REPORT_H
#define SEGMENT_MESH_REPORT_H

#include "Run_watch.h"
#include "../meshes/hierarchy_json.h"
#include "../meshes/read_input.h"

#include <ostream>
#include <utility>

namespace segment_mesh {

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
          {"segmentation", watch.seconds("segmentation")},
          {"writing", watch.seconds("writing")},
          {"total", watch.seconds()}};
}

// Returns the JSON of a hierarchy without the data of faces. Faces are the triangles of the input.
inline Json hierarchy_report(const Segmentation_hierarchy& hierarchy, const Input& input)
{ return json_of_hierarchy(hierarchy, input.soup.points, input.triangles); }

// Writes this JSON with the data of faces; if there are larger polygons, also with their indices.
inline void write_hierarchy(std::ostream& out, const Segmentation_hierarchy& hierarchy,
                            const Input& input)
{
  Json json = hierarchy_report(hierarchy, input);
  if (input.triangles.size() != input.soup.number_of_polygons())
    json["input_face_of_face"] = input.polygon_of_triangle;
  write_json(out, hierarchy, std::move(json));
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_REPORT_H
