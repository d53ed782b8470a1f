// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  if (!CGAL::IO::read_polygon_soup(filename, points, triangles)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<std::size_t> segment_ids(triangles.size());
  const std::size_t n = CGAL::segment_spectral_recursive(
    points, triangles,
    boost::make_iterator_property_map(segment_ids.begin(),
                                      boost::typed_identity_property_map<std::size_t>()));
  std::cout << points.size() << " points, " << triangles.size() << " triangles, " << n
            << " segments" << std::endl;

  std::ofstream out("segments.txt");
  for (std::size_t id : segment_ids)
    out << id << '\n';
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
