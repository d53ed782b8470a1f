# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The Debian packages, of the headers, of the command line tool, for Python, and of the manual:
# `cpack` in the build folder makes them.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME spectral-segmentation)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libcgal-spectral-segmentation-dev)
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME segment-mesh)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-spectral-segmentation)
set(CPACK_DEBIAN_DOC_PACKAGE_NAME libcgal-spectral-segmentation-doc)
# Debian wants an address, and the project has none: RFC 2606 keeps .invalid for such a case.
set(CPACK_PACKAGE_CONTACT "Spectral_segmentation authors <noreply@spectral-segmentation.invalid>"
  CACHE STRING "Name and address of the maintainer of the Debian package")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_DEV_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS libtbb-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS libcgal-spectral-segmentation-doc)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION graphics)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
if(DPKG_SHLIBDEPS)
  set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
endif()
if(debian_python_version MATCHES "^3\\.([0-9]+)$")
  math(EXPR next "${CMAKE_MATCH_1} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${debian_python_version}), python3 (<< 3.${next}), python3-numpy")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_TOOL_DESCRIPTION
"Command line tool that cuts a mesh into the parts that a person would name.

It reads and writes OFF, OBJ, PLY, STL and more, and takes many meshes at a
time.")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"Python package that cuts a mesh into the parts that a person would name.

It takes NumPy arrays of points and triangles, and meshes of trimesh, Open3D,
PyVista and meshio.")
set(CPACK_DEBIAN_DOC_DESCRIPTION
"Manual of the library, the command line tool and the Python package that cut a
mesh into the parts that a person would name.")
set(CPACK_DEBIAN_DEV_DESCRIPTION
"Header-only C++17 library for CGAL that cuts a triangle mesh into the parts
that a person would name, such as legs, trunk and ears.

It implements Zhang and Liu, Mesh Segmentation via Recursive and Visually
Salient Spectral Cuts (2005), and a method built on it that cuts where people
cut.")

# Documents that Debian wants, with a date that SOURCE_DATE_EPOCH fixes
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(debian_dir ${PROJECT_BINARY_DIR}/debian)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${debian_dir}/changelog.Debian @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${debian_dir}/changelog COPYONLY)
find_program(GZIP gzip)
if(GZIP)
  execute_process(COMMAND ${GZIP} -9nf changelog changelog.Debian WORKING_DIRECTORY ${debian_dir})
  foreach(component IN ITEMS DEV TOOL PYTHON DOC)
    string(TOLOWER debian_${component} name)
    install(FILES
      ${CMAKE_CURRENT_LIST_DIR}/copyright
      ${debian_dir}/changelog.gz
      ${debian_dir}/changelog.Debian.gz
      DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${component}_PACKAGE_NAME}
      COMPONENT ${name} EXCLUDE_FROM_ALL)
  endforeach()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_DEV_PACKAGE_NAME}
    COMPONENT debian_dev EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.cpp)
endif()
set(CPACK_COMPONENTS_ALL dev debian_dev)
if(SPECTRAL_SEGMENTATION_BUILD_EXAMPLES)
  list(APPEND CPACK_COMPONENTS_ALL tool debian_tool)
endif()
if(debian_python_version)
  list(APPEND CPACK_COMPONENTS_ALL python debian_python)
endif()
# There is a package of the manual if the target doc has built it before `cpack` runs.
get_directory_property(CPACK_SPECTRAL_SEGMENTATION_MANUAL DIRECTORY ${PROJECT_SOURCE_DIR}/doc
  DEFINITION manual_dir)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/add_manual.cmake)

include(CPack)
foreach(component IN ITEMS dev tool python doc)
  cpack_add_component_group(${component})
  cpack_add_component(${component} GROUP ${component})
  cpack_add_component(debian_${component} GROUP ${component})
endforeach()
