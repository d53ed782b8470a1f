# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The tests of `segment_mesh --html`

if(NOT THREE_MIN_JS OR NOT THREE_ORBIT_CONTROLS_JS)
  message(STATUS "No three.js: the tests of the page are left out")
  return()
endif()
add_test(NAME page
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/page.py
    $<TARGET_FILE:segment_mesh> ${meshes_dir})
set_tests_properties(page PROPERTIES LABELS meshes)

# Debian has Selenium for its own Python.
find_program(CHROMIUM chromium)
find_program(CHROMEDRIVER chromedriver)
foreach(python IN ITEMS ${Python3_EXECUTABLE} /usr/bin/python3)
  execute_process(
    COMMAND ${python} -c "import importlib.util as u; exit(u.find_spec('selenium') is None)"
    RESULT_VARIABLE python_has_no_selenium OUTPUT_QUIET ERROR_QUIET)
  if(python_has_no_selenium EQUAL 0)
    set(python_with_selenium ${python})
    break()
  endif()
endforeach()
if(CHROMIUM AND CHROMEDRIVER AND python_with_selenium)
  add_test(NAME page_in_browser
    COMMAND ${python_with_selenium} ${CMAKE_CURRENT_LIST_DIR}/page_in_browser.py
      $<TARGET_FILE:segment_mesh> ${meshes_dir} ${CHROMIUM} ${CHROMEDRIVER})
  set_tests_properties(page_in_browser PROPERTIES LABELS meshes COST 1)
else()
  message(STATUS "No Chromium, its driver or Selenium: the test of the page in a browser is left "
                 "out")
endif()
