// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <future>
#include <iomanip>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef std::chrono::duration<double> Seconds;
namespace params = CGAL::parameters;

// Prints how much of the run is done and how long the rest may take; stops it when another thread
// says so.
class Progress : public CGAL::Spectral_segmentation::Segmentation_visitor
{
  typedef std::chrono::steady_clock Clock;
  const Clock::time_point start_ = Clock::now();
  const std::atomic<bool>& stop_;
  int percent_ = 0;

public:
  explicit Progress(const std::atomic<bool>& stop) : stop_(stop) {}

  void progress(double fraction)
  {
    const int percent = static_cast<int>(100 * fraction);
    if (percent <= percent_)
      return;
    percent_ = percent;
    const double to_go = Seconds(Clock::now() - start_).count() * (1 - fraction) / fraction;
    std::cout << percent << " %, about " << to_go << " s to go" << std::endl;
  }

  bool go_further() const { return !stop_; }

  bool is_finished() const { return percent_ == 100; }
};

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const Seconds limit(argc > 2 ? std::stod(argv[2]) : 10);
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << std::fixed << std::setprecision(1);

  // This thread waits for the time limit, but not longer than the run takes. It could as well wait
  // for a key or a button.
  std::atomic<bool> stop(limit <= Seconds(0));
  std::promise<void> end_of_run;
  const auto timer = std::async(std::launch::async, [&stop, &end_of_run, limit] {
    stop = end_of_run.get_future().wait_for(limit) == std::future_status::timeout;
  });

  Progress progress(stop);
  auto segment_ids = mesh.add_property_map<Mesh::Face_index, int>("f:segment").first;
  const std::size_t n =
    CGAL::segment_spectral_recursive(mesh, segment_ids, params::visitor(std::ref(progress)));
  end_of_run.set_value();
  std::cout << n << " segments, " << (progress.is_finished() ? "finished" : "stopped")
            << std::endl;
  return CGAL::IO::write_polygon_mesh("segments.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
