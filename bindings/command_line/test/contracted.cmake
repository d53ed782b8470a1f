# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# A test that compares the labels of the tool with those of the same tool with another engine, which
# has fused multiplications, if this processor has them.
include(CheckCXXSourceRuns)
check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
  HAS_FUSED_MULTIPLICATIONS)
if(HAS_FUSED_MULTIPLICATIONS)
  find_package(assimp QUIET) # the targets of packages are known in one folder only
  get_target_property(sources Spectral_segmentation_compiled SOURCES)
  add_library(contracted_engine OBJECT ${sources})
  target_link_libraries(contracted_engine PRIVATE Spectral_segmentation)
  target_compile_definitions(contracted_engine PRIVATE CGAL_SPECTRAL_SEGMENTATION_COMPILED)
  target_compile_options(contracted_engine PRIVATE -mfma -ffp-contract=fast)
  # The linker takes functions from the first object that has them.
  add_executable(segment_mesh_contracted
    $<TARGET_OBJECTS:contracted_engine> $<TARGET_OBJECTS:segment_mesh>)
  target_link_libraries(segment_mesh_contracted PRIVATE
    $<TARGET_PROPERTY:segment_mesh,LINK_LIBRARIES>)
  add_test(NAME contracted
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/contracted.py
      $<TARGET_FILE:segment_mesh> $<TARGET_FILE:segment_mesh_contracted> ${meshes_dir})
  set_tests_properties(contracted PROPERTIES LABELS meshes)
endif()
