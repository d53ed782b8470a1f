// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace params = CGAL::Spectral_segmentation::parameters;

// Prints how much of the run is done, and stops it when its time is over.
class Time_limit : public CGAL::Spectral_segmentation::Segmentation_visitor
{
  typedef std::chrono::steady_clock Clock;
  Clock::time_point end_;
  int percent_ = -1;
  bool is_over_ = false;

public:
  explicit Time_limit(double seconds)
    : end_(Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}

  void progress(double share)
  {
    const int percent = static_cast<int>(100 * share);
    if (percent > percent_)
      std::cout << percent << " %" << std::endl;
    percent_ = percent;
  }

  bool go_further()
  {
    is_over_ = Clock::now() >= end_;
    return !is_over_;
  }

  bool is_over() const { return is_over_; }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const double seconds = argc > 2 ? std::stod(argv[2]) : 10;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Time_limit limit(seconds);
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  const std::size_t n =
    CGAL::segment_spectral_recursive(mesh, segment_ids, params::visitor(std::ref(limit)));
  std::cout << n << " segments, " << (limit.is_over() ? "stopped" : "finished") << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
