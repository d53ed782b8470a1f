// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_REPORT_H
#define SEGMENT_MESH_REPORT_H

#include "Run_watch.h"
#include "../meshes/read_input.h"

#include <CGAL/Spectral_segmentation/IO/hierarchy_json.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <nlohmann/json.hpp>

#include <ostream>
#include <sstream>
#include <string>

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

// Returns the JSON of the hierarchy with the segments of the run. Faces are the triangles of the
// input.
inline std::string
hierarchy_text(const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
               const Input& input)
{
  std::ostringstream out;
  write_hierarchy(out, hierarchy, hierarchy.nodes(), input.soup.points, input.triangles);
  return out.str();
}

// Returns this JSON without the data of faces.
inline Json hierarchy_report(const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                             const Input& input)
{
  Json json = Json::parse(hierarchy_text(hierarchy, input));
  json.erase("leaf_of_face");
  json.erase("neighbors_of_faces");
  return json;
}

// Writes this JSON with the data of faces; if there are larger polygons, also with their indices.
inline void write_hierarchy(std::ostream& out,
                            const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy,
                            const Input& input)
{
  std::string text = hierarchy_text(hierarchy, input);
  if (input.triangles.size() != input.soup.number_of_polygons())
    text.replace(text.rfind("\n}"), std::string::npos,
                 ",\n\"input_face_of_face\": " + Json(input.polygon_of_triangle).dump() + "\n}\n");
  out << text;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_REPORT_H
