// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Face_index Face;
typedef CGAL::Spectral_segmentation::Segmentation_hierarchy Segmentation_hierarchy;
namespace params = CGAL::parameters;

// Cuts a leaf of the hierarchy by a run on its faces.
void cut_leaf(Segmentation_hierarchy& hierarchy, std::size_t leaf, Mesh& mesh)
{
  const CGAL::Face_filtered_graph<Mesh> part(mesh, hierarchy.faces(leaf, mesh));
  auto ids_of_part = mesh.add_property_map<Face, int>("f:segment_of_part").first;
  Segmentation_hierarchy cuts_of_part;
  CGAL::segment_spectral_recursive(part, ids_of_part, params::hierarchy(cuts_of_part));
  mesh.remove_property_map(ids_of_part);
  hierarchy.split_leaf(leaf, cuts_of_part);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto segment_ids = mesh.add_property_map<Face, int>("f:segment").first;
  Segmentation_hierarchy hierarchy;
  const std::size_t n =
    CGAL::segment_spectral_recursive(mesh, segment_ids, params::hierarchy(hierarchy));

  // A choice of segments is a vector of nodes. Segment 0 and a neighbor of it become one.
  std::vector<std::size_t> nodes = hierarchy.nodes();
  std::size_t neighbor = 0;
  for (Mesh::Halfedge_index h : mesh.halfedges())
    if (!mesh.is_border(h) && !mesh.is_border(mesh.opposite(h)) && segment_ids[mesh.face(h)] == 0)
      neighbor = std::max<std::size_t>(neighbor, segment_ids[mesh.face(mesh.opposite(h))]);
  if (neighbor > 0) {
    nodes[0] = hierarchy.merge(nodes[0], nodes[neighbor]);
    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(neighbor));
  }
  const std::size_t merged = hierarchy.write(mesh, segment_ids, nodes);

  // The last segment is cut in two: a new cut if it is a leaf.
  const std::size_t node = nodes.back();
  if (hierarchy.node(node).is_leaf())
    cut_leaf(hierarchy, node, mesh);
  if (!hierarchy.node(node).is_leaf()) {
    nodes.back() = hierarchy.node(node).children[0];
    nodes.push_back(hierarchy.node(node).children[1]);
  }
  const std::size_t last = hierarchy.write(mesh, segment_ids, nodes);
  std::cout << n << " segments, " << merged << " after a merge, " << last << " after a cut"
            << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
