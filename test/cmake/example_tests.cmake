# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# An example runs without arguments: CGAL::data_file_path() leads it to its mesh, or it reads the file that the example
# of the step before has written. With a file that does not exist it fails, and says so. The program mesh_to_t_spline
# has tests of its own, in the folder program.
foreach(example IN LISTS t_splines_examples)
  if(NOT example STREQUAL mesh_to_t_spline)
    add_test(NAME example.${example} COMMAND ${example})
    add_test(NAME example.${example}.refusal
      COMMAND ${CMAKE_COMMAND} -DEXAMPLE=$<TARGET_FILE:${example}> -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/refusal.cmake)
    set_tests_properties(example.${example} example.${example}.refusal PROPERTIES
      LABELS examples TIMEOUT 300 ENVIRONMENT "CGAL_DATA_DIR=${t_splines_demo_data};OPENBLAS_NUM_THREADS=1")
  endif()
endforeach()

if(t_splines_examples)
  set_tests_properties(example.seamless_similarity_map PROPERTIES FIXTURES_SETUP example_map)
  set_tests_properties(example.motorcycle_graph example.regularize_t_mesh example.fit_t_spline PROPERTIES
    FIXTURES_REQUIRED example_map)
  set_tests_properties(example.fit_t_spline PROPERTIES FIXTURES_SETUP example_t_spline)
  set_tests_properties(example.t_spline_deviation PROPERTIES FIXTURES_REQUIRED example_t_spline)
endif()
