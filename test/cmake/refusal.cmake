# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: cmake -DEXAMPLE=program -P refusal.cmake
# Fails unless the program ends with EXIT_FAILURE and names the file that does not exist.
execute_process(COMMAND ${EXAMPLE} no_such_file.obj RESULT_VARIABLE result ERROR_VARIABLE message OUTPUT_QUIET)
if(NOT result EQUAL 1 OR NOT message MATCHES "no_such_file.obj: ")
  message(FATAL_ERROR "${EXAMPLE}: exit code ${result}, message '${message}'")
endif()
