// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <cstddef>
#include <cstdint>
#include <limits>

BOOST_AUTO_TEST_SUITE(paper_labels)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;

// What is built beside the method of the paper must not change its labels: these were recorded
// before there was anything beside it.
namespace {

struct Recorded
{
  const char* mesh;
  std::size_t number_of_segments;
  std::uint64_t fingerprint;
};

// FNV-1a
std::uint64_t fingerprint(const Labels& labels)
{
  std::uint64_t result = 14695981039346656037u;
  for (std::size_t label : labels)
    result = (result ^ label) * 1099511628211u;
  return result;
}

template <class NamedParameters>
void check(const Recorded& expected, const NamedParameters& np)
{
  BOOST_TEST_CONTEXT(expected.mesh) {
    const Mesh mesh = mesh_of(read(expected.mesh));
    Labels labels;
    BOOST_TEST(CGAL::segment_spectral_recursive(mesh, map_to(labels, mesh), np) ==
               expected.number_of_segments);
    BOOST_TEST(fingerprint(labels) == expected.fingerprint);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(labels_by_default)
{
  for (const Recorded& expected : {Recorded{"elephant.off", 25, 0x29a366546f2c3554},
                                   Recorded{"hand.off", 7, 0xcbb73f3164c82d76},
                                   Recorded{"pig.off", 9, 0xc013b1a47d35b408},
                                   Recorded{"bones.off", 58, 0xc76b5a9ee4962fb3},
                                   Recorded{"cactus.off", 9, 0x88949e87e8a3617d},
                                   Recorded{"dino.off", 21, 0x1c8054a229fe2d08}})
    check(expected, parameters::zhang_liu_2005());
}

BOOST_AUTO_TEST_CASE(labels_of_twelve_segments)
{
  const auto np = parameters::zhang_liu_2005().maximum_number_of_segments(12)
                    .salience_threshold(-std::numeric_limits<double>::infinity());
  for (const Recorded& expected : {Recorded{"elephant.off", 12, 0x29e583590e03e60f},
                                   Recorded{"tripod.off", 12, 0x27aa16bc418d3b5c},
                                   Recorded{"blobby_3cc.off", 12, 0x93c8853e23a34699}})
    check(expected, np);
}

BOOST_AUTO_TEST_CASE(labels_with_other_values)
{
  check({"cactus.off", 63, 0x80f81aa1aaf1b6af},
        parameters::zhang_liu_2005().minimum_segment_size(0).salience_threshold(0.4));
  const auto np =
    parameters::zhang_liu_2005().salience_weights(0.2, 0.3, 0.5).boundary_smoothing(true);
  check({"dino.off", 51, 0x522f71664787361c}, np);
  check({"dino.off", 31, 0xdf664d4768fbf3d8}, np.random_seed(3));
}

BOOST_AUTO_TEST_SUITE_END()
