// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/base/Boundary_network.h>

#include <cmath>

BOOST_AUTO_TEST_SUITE(boundary_network)

// A network with one unit has three inputs: the roundness, which is an outlier, the size, and the
// logarithm of the fraction of the area of the mesh that the smaller side has.
BOOST_AUTO_TEST_CASE(logit_of_a_network_by_hand)
{
  const auto tolerance = boost::test_tools::tolerance(1e-12);
  CGAL::Spectral_segmentation::Calibrated_part_salience salience;
  decltype(salience.boundary_network) network{};
  network.deviations.fill(1);
  network.means[0] = 0.1; // of size
  network.deviations[0] = 0.2;
  network.means.back() = 0.5;
  network.constant = 0.5;
  network.weights[0] = 3;
  network.weights.back() = 2;
  network.units[2].constant = -1;
  network.units[2].weights[0] = 0.5;
  network.units[2].weights[8] = 0.25; // of roundness
  network.units[2].output = 2;
  CGAL::Spectral_segmentation::Salience_factors factors;
  factors.size = 0.4;
  factors.log_relative_part_area = -1;
  factors.roundness = 7; // counts as 4
  BOOST_TEST(network.logit(factors) == 0.5 + 3 * 1.5 + 2 * (std::log(0.4) - 1 - 0.5) +
                                         2 * std::tanh(-1 + 0.5 * 1.5 + 0.25 * 4), tolerance);
  factors.is_boundary = true;
  salience.boundary_network = network;
  BOOST_TEST(salience(factors) == 1 / (1 + std::exp(-network.logit(factors))), tolerance);
}

BOOST_AUTO_TEST_SUITE_END()
