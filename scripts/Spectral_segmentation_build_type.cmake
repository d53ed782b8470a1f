# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# CGAL warns of an empty CMAKE_BUILD_TYPE, but CGAL 6 only where the top-level directory finds CGAL.
# This is the warning for the other directories. A Debug build is taken to be wanted.
function(Spectral_segmentation_warn_about_build_type)
  get_property(cgal_warns DIRECTORY PROPERTY CGAL_hooks_installed)
  if(NOT (cgal_warns OR CMAKE_BUILD_TYPE OR CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE))
    message(WARNING "CMAKE_BUILD_TYPE is empty, so that programs are not optimized and run many "
      "times slower: set it to Release. CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON ends this "
      "warning.")
  endif()
endfunction()

get_property(is_done GLOBAL PROPERTY Spectral_segmentation_warns)
if(NOT is_done AND COMMAND CGAL_install_hooks AND NOT CMAKE_CONFIGURATION_TYPES AND
   NOT CMAKE_VERSION VERSION_LESS 3.19)
  set_property(GLOBAL PROPERTY Spectral_segmentation_warns TRUE)
  cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR}
    CALL Spectral_segmentation_warn_about_build_type)
endif()
