// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_REPORT_H
#define SEGMENT_MESH_REPORT_H

#include "Run_watch.h"

#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>

#include <nlohmann/json.hpp>

#include <cstddef>

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
          {"boundary_smoothing", watch.seconds(Run_watch::Stage::BOUNDARY_SMOOTHING)},
          {"segmentation", watch.seconds("segmentation")},
          {"writing", watch.seconds("writing")},
          {"total", watch.seconds()}};
}

inline const char* name_of(CGAL::Spectral_segmentation::Segmentation_hierarchy::Cut_state state)
{
  typedef CGAL::Spectral_segmentation::Segmentation_hierarchy::Cut_state Cut_state;
  switch (state) {
    case Cut_state::NO_CUT: return "no cut";
    case Cut_state::REJECTED: return "rejected";
    case Cut_state::ACCEPTED: return "accepted";
    default: return "not searched";
  }
}

// The method of the paper has three factors.
inline Json factors_report(const CGAL::Spectral_segmentation::Salience_factors& f,
                           bool is_of_paper)
{
  Json report = {{"size", f.size},
                 {"cut_strength", f.cut_strength},
                 {"protrusiveness", f.protrusiveness}};
  if (!is_of_paper)
    report.update({{"log_relative_part_area", f.log_relative_part_area},
                   {"concavity_near_cut", f.concavity_near_cut},
                   {"convexity_gain", f.convexity_gain},
                   {"relative_convexity_gain", f.relative_convexity_gain},
                   {"expansion_behind_cut", f.expansion_behind_cut}});
  return report;
}

// The nodes by their index; salience and factors are those of the best cut, null if there is none.
// The salience of the calibrated method goes by the name of what it is, a probability.
inline Json tree_report(const CGAL::Spectral_segmentation::Segmentation_hierarchy& tree,
                        bool is_of_paper)
{
  typedef CGAL::Spectral_segmentation::Segmentation_hierarchy Segmentation_hierarchy;
  const char* const salience = is_of_paper ? "salience" : "probability";
  Json nodes = Json::array();
  for (std::size_t i = 0; i < tree.number_of_nodes(); ++i) {
    const Segmentation_hierarchy::Node& n = tree.node(i);
    const bool has_cut = n.cut_state == Segmentation_hierarchy::Cut_state::REJECTED ||
                         n.cut_state == Segmentation_hierarchy::Cut_state::ACCEPTED;
    Json node;
    node["id"] = i;
    node["parent"] = n.parent == Segmentation_hierarchy::null_node ? Json() : Json(n.parent);
    node["children"] = n.is_leaf() ? Json::array() : Json(n.children);
    node["faces"] = tree.number_of_faces(i);
    node["area"] = n.area;
    node["cut"] = name_of(n.cut_state);
    node[salience] = has_cut ? Json(n.salience) : Json();
    node["factors"] = has_cut ? factors_report(n.factors, is_of_paper) : Json();
    nodes.push_back(node);
  }
  return nodes;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_REPORT_H
