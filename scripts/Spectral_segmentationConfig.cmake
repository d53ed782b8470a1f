# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# No versions: the config files of CGAL and Eigen refuse a later major version than the one named.
include(CMakeFindDependencyMacro)
find_dependency(CGAL)
if(CGAL_VERSION VERSION_LESS 5.5)
  set(Spectral_segmentation_FOUND FALSE)
  set(Spectral_segmentation_NOT_FOUND_MESSAGE "it needs CGAL 5.5 or later, found ${CGAL_VERSION}")
  return()
endif()
find_dependency(Eigen3 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/Spectral_segmentation_TBB.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Spectral_segmentationTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Spectral_segmentation_compiled.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Spectral_segmentation_build_type.cmake)
