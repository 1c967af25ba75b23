# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# An example runs without arguments: CGAL::data_file_path() leads it to its mesh. The program mesh_to_t_spline wants a
# mesh; its tests stand in the room IO.
foreach(example IN LISTS t_splines_examples)
  if(NOT example STREQUAL mesh_to_t_spline)
    add_test(NAME example.${example} COMMAND ${example})
    set_tests_properties(example.${example} PROPERTIES
      LABELS examples TIMEOUT 300 ENVIRONMENT "CGAL_DATA_DIR=${t_splines_demo_data};OPENBLAS_NUM_THREADS=1")
  endif()
endforeach()
