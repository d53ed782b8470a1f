// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Proves that the headers are found, at little cost.

#include <CGAL/Spectral_segmentation/parameters.h>
#include <CGAL/Spectral_segmentation/version.h>

#include <cstdlib>
#include <iostream>
#include <string>

int main()
{
  const auto np = CGAL::Spectral_segmentation::parameters::salience_threshold(0.3).random_seed(1);
  static_cast<void>(np);
  std::cout << CGAL_SPECTRAL_SEGMENTATION_VERSION << std::endl;
  return std::string(CGAL_SPECTRAL_SEGMENTATION_VERSION) == PACKAGE_VERSION ? EXIT_SUCCESS
                                                                             : EXIT_FAILURE;
}
