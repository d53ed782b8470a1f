# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# No versions: the config files of CGAL and Eigen refuse a later major version than the one named.
include(CMakeFindDependencyMacro)
find_dependency(CGAL)
find_dependency(Eigen3 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/Spectral_segmentationTargets.cmake)
