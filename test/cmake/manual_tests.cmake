# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The manual is built without a warning.
find_program(T_SPLINES_DOXYGEN doxygen)
mark_as_advanced(T_SPLINES_DOXYGEN)
if(T_SPLINES_BASH AND T_SPLINES_DOXYGEN)
  add_test(NAME doc.manual COMMAND ${T_SPLINES_BASH} ${CMAKE_CURRENT_SOURCE_DIR}/check_manual.sh)
  set_tests_properties(doc.manual PROPERTIES LABELS doc TIMEOUT 300)
endif()

# The sources are laid out as .clang-format says, which other versions of clang-format read differently.
find_program(T_SPLINES_CLANG_FORMAT NAMES clang-format-14 clang-format)
mark_as_advanced(T_SPLINES_CLANG_FORMAT)
if(T_SPLINES_BASH AND T_SPLINES_CLANG_FORMAT)
  execute_process(COMMAND ${T_SPLINES_CLANG_FORMAT} --version OUTPUT_VARIABLE clang_format_version)
  if(clang_format_version MATCHES "version 14\\.")
    add_test(NAME format.sources
      COMMAND ${T_SPLINES_BASH} ${CMAKE_CURRENT_SOURCE_DIR}/check_format.sh ${T_SPLINES_CLANG_FORMAT})
    set_tests_properties(format.sources PROPERTIES LABELS format TIMEOUT 300)
  endif()
endif()
