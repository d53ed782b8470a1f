# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Defines CGAL::TBB_support where TBB is found; Spectral_segmentation::Spectral_segmentation links
# it then. Where another directory of the project has found CGAL first, its modules are not in the
# path yet.
list(APPEND CMAKE_MODULE_PATH ${CGAL_MODULES_DIR})
find_package(TBB QUIET)
include(CGAL_TBB_support)
list(POP_BACK CMAKE_MODULE_PATH)
