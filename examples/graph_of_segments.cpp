// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Segmented_mesh/segment_adjacency_graph.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <boost/graph/graphviz.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  CGAL::Spectral_segmentation::Segmentation_hierarchy tree;
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  CGAL::segment_spectral_recursive(mesh, segment_ids, params::hierarchy(tree));
  const auto graph = CGAL::segment_adjacency_graph(mesh, segment_ids, tree);
  std::cout << num_vertices(graph) << " segments, " << num_edges(graph) << " boundaries"
            << std::endl;

  std::ofstream out("segments.dot"); // for Graphviz: neato -Tsvg segments.dot
  boost::write_graphviz(
    out, graph,
    [&](std::ostream& o, auto v) {
      o << "[label=\"" << graph[v].id << "\\narea " << graph[v].area << "\"]";
    },
    [&](std::ostream& o, auto e) {
      o << "[label=\"" << graph[e].salience << "\", len=" << 2 - graph[e].salience << "]";
    });
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
