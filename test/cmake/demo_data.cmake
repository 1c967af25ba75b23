# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Extracts the meshes of Debian's package libcgal-demo into the build tree: t_splines_demo_data/meshes/*.off

find_file(T_SPLINES_DEMO_ARCHIVE data.tar.gz
  PATHS /usr/share/doc/libcgal-dev /usr/share/doc/libcgal-demo
  NO_DEFAULT_PATH
  DOC "data.tar.gz of Debian's package libcgal-demo")
if(NOT T_SPLINES_DEMO_ARCHIVE)
  message(FATAL_ERROR "The tests need the meshes of CGAL's demos: install libcgal-demo, or set T_SPLINES_DEMO_ARCHIVE "
    "to its data.tar.gz")
endif()

set(t_splines_demo_data ${PROJECT_BINARY_DIR}/demo_data/data)
set(stamp ${PROJECT_BINARY_DIR}/demo_data/extracted)
if(${T_SPLINES_DEMO_ARCHIVE} IS_NEWER_THAN ${stamp})
  file(ARCHIVE_EXTRACT INPUT ${T_SPLINES_DEMO_ARCHIVE} DESTINATION ${PROJECT_BINARY_DIR}/demo_data
    PATTERNS "data/meshes/*")
  file(TOUCH ${stamp})
endif()
