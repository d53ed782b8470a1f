// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A target of libFuzzer for the reader of one format, by -DFUZZED_FORMAT=OFF, OBJ, PLY or STL.

#include "../Polygon_soup.h"
#include "../Polygon_triangulation.h"
#include "../read_mesh_file.h"
#include "../stitch_borders.h"

#include <sanitizer/allocator_interface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace mesh_file;

void require(bool condition, const char* what)
{
  if (!condition) {
    std::fprintf(stderr, "not so: %s\n", what);
    std::abort();
  }
}

std::size_t live_bytes = 0, most_live_bytes = 0;

void count_allocation(const volatile void*, std::size_t size)
{
  live_bytes += size;
  most_live_bytes = (std::max)(most_live_bytes, live_bytes);
}

void count_release(const volatile void* p)
{
  if (p)
    live_bytes -= __sanitizer_get_allocated_size(p);
}

void check_message(const std::string& message)
{
  require(!message.empty() && message.size() < 200, "a message has a line");
  for (char c : message)
    require(c >= ' ' && c <= '~', "a message can be printed");
}

void check_properties(const std::vector<Property>& properties, std::size_t size)
{
  for (const Property& p : properties) {
    require(!p.name.empty(), "a property has a name");
    require(p.values.size() == size, "a property has a value for each element");
    for (double value : p.values)
      require(has_type(value, p.type), "a value fits into the type of its property");
  }
}

template <class Element>
void check_elements_of_corners(const std::vector<Index>& of_corner,
                               const std::vector<Element>& elements, const Polygon_soup& soup)
{
  require(of_corner.empty() || of_corner.size() == soup.corners.size(), "each corner has one");
  for (Index i : of_corner)
    require(i == null_index || i < elements.size(), "the element of a corner exists");
}

void check(const Polygon_soup& soup)
{
  require(!soup.first_corner.empty() && soup.first_corner.front() == 0 &&
            soup.first_corner.back() == soup.corners.size(), "all corners belong to polygons");
  require(std::is_sorted(soup.first_corner.begin(), soup.first_corner.end()),
          "the first corners ascend");
  for (Index v : soup.corners)
    require(v < soup.points.size() && is_finite(soup.points[v]), "a corner is a finite point");
  for (const Point& p : soup.points)
    for (double c : p)
      require(has_type(c, soup.coordinate_type), "a coordinate has its type");
  check_properties(soup.point_properties, soup.points.size());
  check_properties(soup.polygon_properties, soup.number_of_polygons());
  check_elements_of_corners(soup.texture_of_corner, soup.texture_coordinates, soup);
  check_elements_of_corners(soup.normal_of_corner, soup.normals, soup);
  for (const std::string& warning : soup.warnings)
    check_message(warning);
}

// Triangles of all polygons, and what becomes of them where points are repeated.
void check_triangles(const Polygon_soup& soup)
{
  Polygon_triangulation triangulate(soup.points);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i) {
    const Polygon polygon = soup.polygon(i);
    const std::size_t first = triangles.size();
    triangulate(polygon, triangles);
    require(triangles.size() - first <= (std::max)(polygon.size(), std::size_t(2)) - 2,
            "a polygon has at most two triangles fewer than corners");
    for (std::size_t t = first; t < triangles.size(); ++t)
      for (Index v : triangles[t])
        require(std::find(polygon.begin(), polygon.end(), v) != polygon.end(),
                "a triangle has the corners of its polygon");
  }
  const std::vector<Triangle> before = triangles;
  Border_stitching(soup.points, triangles)();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      require(soup.points[triangles[t][i]] == soup.points[before[t][i]], "no corner moves");
}

// Nothing if the file contradicts the format.
std::optional<Polygon_soup> read(std::string_view file, bool keeps_properties)
{
  std::optional<Polygon_soup> result;
  most_live_bytes = live_bytes;
  const std::size_t before = live_bytes;
  try {
    result = read_mesh_file(file, Format::FUZZED_FORMAT, keeps_properties);
  }
  catch (const std::runtime_error& e) {
    check_message(e.what());
  }
  require(most_live_bytes - before < 64 * file.size() + (1 << 14),
          "a reader takes a small multiple of the size of the file");
  return result;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  __sanitizer_install_malloc_and_free_hooks(count_allocation, count_release);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  format_of_contents(file);
  const std::optional<Polygon_soup> soup = read(file, false), with_properties = read(file, true);
  require(soup.has_value() == with_properties.has_value(), "properties contradict nothing");
  if (!soup)
    return 0;
  check(*soup);
  check(*with_properties);
  const bool has_same_points =
    std::equal(soup->points.begin(), soup->points.end(), with_properties->points.begin(),
               with_properties->points.end(), [](const Point& p, const Point& q)
               { return p == q || (!is_finite(p) && !is_finite(q)); });
  require(has_same_points && soup->corners == with_properties->corners &&
            soup->first_corner == with_properties->first_corner, "properties change nothing");
  check_triangles(*soup);
  return 0;
}
