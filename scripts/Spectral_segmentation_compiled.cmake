# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The target Spectral_segmentation::compiled: the engine compiled once, with the project's own
# compiler, CGAL and flags. Programs that link it in place of
# Spectral_segmentation::Spectral_segmentation compile in a fraction of the time.
if(NOT TARGET Spectral_segmentation_compiled)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/Spectral_segmentation_engine.cpp)
  file(CONFIGURE OUTPUT ${source}
    CONTENT "#include <CGAL/Spectral_segmentation/compiled.h>\n")
  add_library(Spectral_segmentation_compiled STATIC EXCLUDE_FROM_ALL ${source})
  add_library(Spectral_segmentation::compiled ALIAS Spectral_segmentation_compiled)
  target_compile_definitions(Spectral_segmentation_compiled
    PUBLIC CGAL_SPECTRAL_SEGMENTATION_COMPILED)
  # Labels do not depend on whether the processor has fused multiplications.
  target_compile_options(Spectral_segmentation_compiled PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
  # CMake asks for no optimization without a build type. A Debug build is taken to be wanted.
  if(NOT CMAKE_CXX_FLAGS MATCHES "-O")
    target_compile_options(Spectral_segmentation_compiled PRIVATE
      $<$<AND:$<CONFIG:>,$<CXX_COMPILER_ID:GNU,Clang,AppleClang>>:-O2>)
  endif()
  target_link_libraries(Spectral_segmentation_compiled
    PUBLIC Spectral_segmentation::Spectral_segmentation)
  set_target_properties(Spectral_segmentation_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()
