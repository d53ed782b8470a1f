// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(real_meshes)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using CGAL::Spectral_segmentation::Method;

namespace {

typedef CGAL::Aff_transformation_3<Kernel> Transformation;

const char* const some_meshes[] = {"elephant.off", "hand.off", "dino.off", "bones.off",
                                   "head.off", "pig.off", "camel.off", "mushroom.off"};

template <class ConcurrencyTag = CGAL::Parallel_if_available_tag>
Labels labels_of(const Mesh& mesh, Method method)
{
  Labels labels;
  CGAL::segment_spectral_recursive<ConcurrencyTag>(
    mesh, map_to(labels, mesh), parameters::method(method));
  return labels;
}

void check_labels(const Mesh& mesh, Method method)
{
  const Labels labels = labels_of(mesh, method);
  std::size_t next = 0;
  for (std::size_t label : labels) {
    BOOST_TEST_REQUIRE(label <= next);
    next += label == next;
  }
  BOOST_TEST(number_of_connected_pieces(mesh, labels) == next);
  BOOST_TEST((labels == labels_of<CGAL::Sequential_tag>(mesh, method)));
}

// Share of the pairs of faces that both segmentations join or both separate.
double rand_index(const Labels& a, const Labels& b)
{
  const auto number_of_pairs = [](double n) { return n * (n - 1) / 2; };
  const auto joined_pairs = [&](const auto& sizes) {
    double sum = 0;
    for (const auto& entry : sizes)
      sum += number_of_pairs(entry.second);
    return sum;
  };
  std::map<std::size_t, double> in_a, in_b;
  std::map<std::pair<std::size_t, std::size_t>, double> in_both;
  for (std::size_t f = 0; f < a.size(); ++f) {
    ++in_a[a[f]];
    ++in_b[b[f]];
    ++in_both[{a[f], b[f]}];
  }
  const double all = number_of_pairs(double(a.size()));
  return (all + 2 * joined_pairs(in_both) - joined_pairs(in_a) - joined_pairs(in_b)) / all;
}

// A rotation by `angle` around an axis that is not one of the coordinate axes.
Transformation skew_rotation(double angle)
{
  const double c = std::cos(angle), s = std::sin(angle), x = 2. / 7, y = 3. / 7, z = 6. / 7;
  const double t = 1 - c;
  return Transformation(t * x * x + c, t * x * y - s * z, t * x * z + s * y,
                        t * x * y + s * z, t * y * y + c, t * y * z - s * x,
                        t * x * z - s * y, t * y * z + s * x, t * z * z + c);
}

} // namespace

BOOST_AUTO_TEST_CASE(each_mesh_of_CGAL_is_segmented)
{
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(
         SPECTRAL_SEGMENTATION_TEST_DATA_DIR))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());

  std::size_t number_of_meshes = 0;
  for (const std::filesystem::path& path : paths) {
    Mesh mesh;
    if (!CGAL::IO::read_polygon_mesh(path.string(), mesh) || num_faces(mesh) == 0 ||
        !CGAL::is_triangle_mesh(mesh))
      continue;
    ++number_of_meshes;
    BOOST_TEST_CONTEXT(path.filename()) {
      check_labels(mesh, Method::ZHANG_LIU_2005);
      if (num_faces(mesh) < 10000) // the larger ones take long
        check_labels(mesh, Method::CALIBRATED);
    }
  }
  BOOST_TEST(number_of_meshes > 80);
}

BOOST_AUTO_TEST_CASE(the_axes_may_be_exchanged)
{
  const Transformation cyclic(0, 1, 0, 0, 0, 1, 1, 0, 0);
  for (const char* name : some_meshes) {
    Mesh mesh = mesh_of(read(name));
    const Labels expected = labels_of(mesh, Method::ZHANG_LIU_2005);
    PMP::transform(cyclic, mesh);
    BOOST_TEST((labels_of(mesh, Method::ZHANG_LIU_2005) == expected), name);
  }
}

BOOST_AUTO_TEST_CASE(a_rotation_changes_little)
{
  for (const char* name : some_meshes) {
    Mesh mesh = mesh_of(read(name));
    const Labels expected = labels_of(mesh, Method::ZHANG_LIU_2005);
    PMP::transform(skew_rotation(pi / 6), mesh);
    BOOST_TEST(rand_index(labels_of(mesh, Method::ZHANG_LIU_2005), expected) > 0.98, name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
