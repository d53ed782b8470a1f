# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# `cpack` reads this file: it adds the manual to the packages if the target doc has built it.
if(EXISTS "${CPACK_SPECTRAL_SEGMENTATION_MANUAL}/html/index.html")
  list(APPEND CPACK_COMPONENTS_ALL doc debian_doc)
endif()
