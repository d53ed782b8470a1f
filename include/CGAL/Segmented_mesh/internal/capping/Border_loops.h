// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_BORDER_LOOPS_H
#define CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_BORDER_LOOPS_H

#include <CGAL/Segmented_mesh/internal/base.h>
#include <CGAL/Spectral_segmentation/internal/base/Index.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Segmented_mesh::internal {

// Two vertices, the smaller first.
typedef std::pair<Index, Index> Vertex_pair;

inline Vertex_pair vertex_pair(Index v, Index w) { return {(std::min)(v, w), (std::max)(v, w)}; }

struct Border_edge
{
  int direction; // positive if its triangles pass it from its smaller to its larger vertex
  Index apex;    // the third corner of one of its triangles
};

// The edges that an odd number of triangles of a set have.
typedef std::map<Vertex_pair, Border_edge> Border;

// Splits a border into loops that pass no vertex twice, against the direction of most of the
// triangles at them. Loops contain all border edges, however the triangles meet and are oriented,
// because an even number of border edges meets at each vertex.
class Border_loops
{
  struct Step
  {
    Index vertex;
    int direction; // the direction of the border edge that leaves it
  };

  std::map<Index, std::vector<std::pair<Index, int> > > unused_; // other ends and directions
  std::vector<Step> path_;
  std::unordered_map<Index, std::size_t> place_; // the place of each vertex in the path
  std::vector<std::vector<Index> > loops_;

  // Removes the edge to w from the unused edges of v.
  void use(Index v, Index w)
  {
    auto& edges = unused_[v];
    edges.erase(std::find_if(edges.begin(), edges.end(), [w](const auto& e)
                             { return e.first == w; }));
  }

  // Makes a loop of the end of the path, from its `first` vertex on.
  void add_loop(std::size_t first)
  {
    std::vector<Index> loop;
    int direction = 0;
    for (std::size_t i = first; i < path_.size(); ++i) {
      loop.push_back(path_[i].vertex);
      direction += path_[i].direction > 0 ? 1 : -1;
      place_.erase(path_[i].vertex);
    }
    path_.resize(first);
    if (direction > 0)
      std::reverse(loop.begin(), loop.end());
    loops_.push_back(std::move(loop));
  }

  // Walks until no edge is left at v, which then is the vertex where the walk began.
  void walk(Index v)
  {
    while (!unused_[v].empty()) {
      const auto& edges = unused_[v];
      const auto along = std::find_if(edges.begin(), edges.end(), [](const auto& e)
                                      { return e.second < 0; });
      const auto [w, direction] = along == edges.end() ? edges.front() : *along;
      use(v, w);
      use(w, v);
      place_[v] = path_.size();
      path_.push_back({v, direction});
      v = w;
      const auto passed = place_.find(v);
      if (passed != place_.end())
        add_loop(passed->second);
    }
    CGAL_assertion(path_.empty());
  }

public:
  explicit Border_loops(const Border& border)
  {
    for (const auto& [vertices, edge] : border) {
      unused_[vertices.first].emplace_back(vertices.second, edge.direction);
      unused_[vertices.second].emplace_back(vertices.first, -edge.direction);
    }
    for (const auto& [vertices, edge] : border)
      walk(vertices.first);
  }

  const std::vector<std::vector<Index> >& operator()() const { return loops_; }
};

} // namespace CGAL::Segmented_mesh::internal

#endif // CGAL_SEGMENTED_MESH_INTERNAL_CAPPING_BORDER_LOOPS_H
