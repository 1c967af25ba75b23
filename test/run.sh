#!/usr/bin/env bash
# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs what the tests need (on Debian), builds in build/ and runs all tests. Arguments go to ctest: -L Solver.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. test/setup.sh

# shellcheck disable=SC2086 # a list of words
install_packages $example_packages catch2 clang clang-format doxygen libopenmesh-dev
archive=$(demo_archive) || { echo "The meshes of libcgal-demo were not found: set T_SPLINES_DEMO_ARCHIVE." >&2; exit 1; }
configure -DT_SPLINES_BUILD_TESTS=ON -DT_SPLINES_BUILD_EXAMPLES=ON -DT_SPLINES_WARNINGS_AS_ERRORS=ON \
  -DT_SPLINES_DEMO_ARCHIVE="$archive" -DCMAKE_UNITY_BUILD=ON
build
cd build
ctest --output-on-failure --parallel "$(nproc)" "$@"
