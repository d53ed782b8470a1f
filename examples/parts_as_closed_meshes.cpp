// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Spectral_segmentation/refine_segment_boundaries.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
namespace PMP = CGAL::Polygon_mesh_processing;

// By way of a polygon soup, as a segment may touch itself at a vertex, which then is duplicated.
Mesh copy_of(const CGAL::Face_filtered_graph<Mesh>& segment)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > triangles;
  PMP::polygon_mesh_to_polygon_soup(segment, points, triangles);
  PMP::orient_polygon_soup(points, triangles);
  Mesh part;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, part);
  return part;
}

void fill_holes(Mesh& part)
{
  std::vector<Mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(part, std::back_inserter(borders));
  for (Mesh::Halfedge_index h : borders)
#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(5, 6, 0)
    PMP::triangulate_hole(part, h, CGAL::Emptyset_iterator());
#else
    PMP::triangulate_hole(part, h);
#endif
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  CGAL::refine_segment_boundaries(mesh, segment_ids); // smooth seams, not along the edges
  for (std::size_t i = 0; i < n; ++i) {
    Mesh part = copy_of(CGAL::Face_filtered_graph<Mesh>(mesh, i, segment_ids));
    fill_holes(part);
    if (!CGAL::is_closed(part)) {
      std::cerr << "A hole of part " << i << " cannot be filled" << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "part " << i << ": volume " << PMP::volume(part) << std::endl;
    if (!CGAL::IO::write_polygon_mesh("part_" + std::to_string(i) + ".off", part,
                                      CGAL::parameters::stream_precision(17)))
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
