// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// arrays_call POINTS TRIANGLES
///
/// The C++ call beside which python.py and web.mjs measure those of Python and JavaScript: with one
/// thread, on the points, of 64-bit floats, and triangles, of 32-bit integers, of two files of
/// plain numbers. Prints seconds, seconds of the processor, bytes at the peak beyond the mesh, and
/// the number of segments.

#include "Peak_memory.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <vector>

template <class Number>
std::vector<std::array<Number, 3> > read(const char* path)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<std::array<Number, 3> > result(
    static_cast<std::size_t>(file.tellg()) / sizeof(std::array<Number, 3>));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(result.data()),
            static_cast<std::streamsize>(result.size() * sizeof(result[0])));
  return result;
}

int main(int argc, char* argv[])
{
  if (argc != 3) {
    std::cerr << "arrays_call POINTS TRIANGLES\n";
    return EXIT_FAILURE;
  }
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  std::vector<Point> points;
  for (const std::array<double, 3>& p : read<double>(argv[1]))
    points.emplace_back(p[0], p[1], p[2]);
  const auto triangles = read<std::int32_t>(argv[2]);

  const segmentation_benchmark::Peak_memory memory;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t clock_at_start = std::clock();
  std::vector<std::size_t> labels(triangles.size());
  const std::size_t number = CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
    points, triangles,
    boost::make_iterator_property_map(labels.begin(),
                                      boost::typed_identity_property_map<std::size_t>()));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::cout << seconds.count() << ' '
            << static_cast<double>(std::clock() - clock_at_start) / CLOCKS_PER_SEC << ' '
            << memory.bytes() << ' ' << number << '\n';
}
