# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Included by the CMakeLists.txt above. Puts the files of the folder page into the header report_page_files.h in the build
# tree, as raw string literals, in pieces that every compiler accepts.

set(page_directory ${CMAKE_CURRENT_LIST_DIR}/page)
file(GLOB page_files CONFIGURE_DEPENDS RELATIVE ${page_directory} ${page_directory}/*)
set(REPORT_PAGE_FILES "")
foreach(page_file IN LISTS page_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_directory}/${page_file})
  file(READ ${page_directory}/${page_file} content)
  string(LENGTH "${content}" length)
  string(APPEND REPORT_PAGE_FILES "  if (name == \"${page_file}\")\n    return \"\"")
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${content}" ${begin} 8000 piece)
    string(APPEND REPORT_PAGE_FILES "\n      R\"t_splines(${piece})t_splines\"")
    math(EXPR begin "${begin} + 8000")
  endwhile()
  string(APPEND REPORT_PAGE_FILES ";\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/report_page_files.h.in
  ${CMAKE_CURRENT_BINARY_DIR}/mesh_to_t_spline/report_page_files.h @ONLY)
