# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The public headers without deprecated code of CGAL 6, and the tests of one room, compiled against headers of CGAL 6
# that lie beside those that everything else is built on.
set(T_SPLINES_CGAL6_DIR "" CACHE PATH "A directory with include/CGAL/version.h of CGAL 6; empty: no tests with CGAL 6")
if(NOT T_SPLINES_CGAL6_DIR)
  return()
endif()
set(cgal6_version ${T_SPLINES_CGAL6_DIR}/include/CGAL/version.h)
if(NOT EXISTS ${cgal6_version})
  message(FATAL_ERROR "T_SPLINES_CGAL6_DIR: there is no file ${cgal6_version}")
endif()
file(STRINGS ${cgal6_version} cgal6_version_line REGEX "^#define CGAL_VERSION 6\\.")
if(NOT cgal6_version_line)
  message(FATAL_ERROR "T_SPLINES_CGAL6_DIR: ${cgal6_version} is not of CGAL 6")
endif()

# Targets of their own, without the precompiled headers; they are built by the tests.
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/cgal6/public_headers.cpp CONTENT "${public_includes}")
add_library(t_splines_cgal6_headers OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/cgal6/public_headers.cpp)
target_compile_options(t_splines_cgal6_headers PRIVATE -fsyntax-only)
target_compile_definitions(t_splines_cgal6_headers PRIVATE CGAL_NO_DEPRECATED_CODE)

file(GLOB cgal6_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/T_splines/Similarity_map/*.cpp)
add_executable(t_splines_cgal6_tests EXCLUDE_FROM_ALL ${cgal6_sources} T_splines/main.cpp)
target_link_libraries(t_splines_cgal6_tests PRIVATE Catch2::Catch2)
target_include_directories(t_splines_cgal6_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/T_splines)
target_compile_options(t_splines_cgal6_tests PRIVATE $<$<CONFIG:Release>:-O1>)
target_compile_definitions(t_splines_cgal6_tests PRIVATE
  T_SPLINES_DEMO_DATA="${t_splines_demo_data}"
  T_SPLINES_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}/T_splines/data")

foreach(target t_splines_cgal6_headers t_splines_cgal6_tests)
  target_link_libraries(${target} PRIVATE t_splines_program_settings)
  target_include_directories(${target} BEFORE PRIVATE ${T_SPLINES_CGAL6_DIR}/include)
endforeach()

set(cgal6_build ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --config $<CONFIG> --parallel 2 --target)
add_test(NAME cgal6.headers COMMAND ${cgal6_build} t_splines_cgal6_headers)
add_test(NAME cgal6.build COMMAND ${cgal6_build} t_splines_cgal6_tests)
add_test(NAME cgal6.Similarity_map COMMAND t_splines_cgal6_tests)
set_tests_properties(cgal6.headers cgal6.build PROPERTIES LABELS cgal6 TIMEOUT 1800 RUN_SERIAL ON)
set_tests_properties(cgal6.build PROPERTIES FIXTURES_SETUP cgal6)
set_tests_properties(cgal6.Similarity_map PROPERTIES
  LABELS cgal6 FIXTURES_REQUIRED cgal6 TIMEOUT 900 ENVIRONMENT OPENBLAS_NUM_THREADS=1)
