// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// Two tetrahedra are two segments.
int main()
{
  Mesh mesh;
  for (double x : {0., 5.})
    CGAL::make_tetrahedron(Point(x, 0, 0), Point(x + 1, 0, 0), Point(x, 1, 0), Point(x, 0, 1),
                           mesh);
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  std::cout << n << " segments" << std::endl;
  return n == 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
