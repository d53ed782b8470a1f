// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Spectral_segmentation::Salience_factors Salience_factors;
namespace params = CGAL::parameters;

// The probability that a person would cut, but only for limbs: parts of at most a quarter of the
// mesh.
struct Limb_salience
{
  CGAL::Spectral_segmentation::Calibrated_part_salience probability;

  double operator()(const Salience_factors& factors) const
  {
    const double share_of_mesh = factors.size * std::exp(factors.log_relative_part_area);
    return share_of_mesh <= 0.25 ? probability(factors) : 0;
  }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  std::cout << CGAL::segment_spectral_recursive(
                 mesh, segment_ids,
                 params::part_salience(Limb_salience()).salience_threshold(0.5))
            << " segments, the body and its limbs" << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
