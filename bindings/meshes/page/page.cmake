# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The page of `segment_mesh --html`: its sources and those of three.js become one of C++.

set(three_dirs /usr/share/javascript/three)
find_file(THREE_MIN_JS three.min.js PATHS ${three_dirs} NO_DEFAULT_PATH
  DOC "three.js, as of Debian's package libjs-three")
find_file(THREE_ORBIT_CONTROLS_JS OrbitControls.js PATHS ${three_dirs}
  PATH_SUFFIXES examples/js/controls NO_DEFAULT_PATH DOC "The controls of the same three.js")
if(NOT THREE_MIN_JS OR NOT THREE_ORBIT_CONTROLS_JS)
  message(STATUS "No three.js: segment_mesh writes no page (--html)")
  return()
endif()

set(page_files page.html viewer.css hierarchy.js colors.js first_view.js glb.js scene.js
  viewer.js decode.js)
list(TRANSFORM page_files PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
list(APPEND page_files ${THREE_MIN_JS} ${THREE_ORBIT_CONTROLS_JS})
set(page_sources ${CMAKE_CURRENT_BINARY_DIR}/segment_mesh_page_sources.cpp)
add_custom_command(OUTPUT ${page_sources}
  COMMAND ${CMAKE_COMMAND} "-DFILES=${page_files}" -DOUTPUT=${page_sources}
    -P ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake
  DEPENDS ${page_files} ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake
  COMMENT "Embedding the page of segment_mesh"
  VERBATIM)
target_sources(segment_mesh PRIVATE ${page_sources})
set_source_files_properties(${page_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_compile_definitions(segment_mesh PRIVATE SEGMENT_MESH_WITH_PAGE)
