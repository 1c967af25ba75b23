# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the package into the build tree and builds and runs another project that finds it there.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/installed)
add_test(NAME installation.install
  COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix} --config $<CONFIG>)
add_test(NAME installation.consumer
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${CMAKE_CURRENT_BINARY_DIR}/consumer
    --build-generator ${CMAKE_GENERATOR}
    --build-options
      -DCMAKE_BUILD_TYPE=$<CONFIG>
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_PREFIX_PATH=${prefix}
      -DWITH_CHOLMOD=${T_SPLINES_WITH_CHOLMOD}
    --test-command consumer)
set_tests_properties(installation.install PROPERTIES LABELS installation FIXTURES_SETUP installation)
set_tests_properties(installation.consumer PROPERTIES
  LABELS installation FIXTURES_REQUIRED installation TIMEOUT 600)
