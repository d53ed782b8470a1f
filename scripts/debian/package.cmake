# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The Debian package: `cpack` in the build folder makes it.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME libcgal-spectral-segmentation-dev)
# Debian wants an address, and the project has none: RFC 2606 keeps .invalid for such a case.
set(CPACK_PACKAGE_CONTACT "Spectral_segmentation authors <noreply@spectral-segmentation.invalid>"
  CACHE STRING "Name and address of the maintainer of the Debian package")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
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
  install(FILES
    ${CMAKE_CURRENT_LIST_DIR}/copyright
    ${debian_dir}/changelog.gz
    ${debian_dir}/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME}
    COMPONENT debian EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME}
    COMPONENT debian EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN *.cpp PATTERN segment_mesh* EXCLUDE)
endif()
set(CPACK_INSTALL_CMAKE_PROJECTS
  "${PROJECT_BINARY_DIR};${PROJECT_NAME};ALL;/;${PROJECT_BINARY_DIR};${PROJECT_NAME};debian;/")

include(CPack)
