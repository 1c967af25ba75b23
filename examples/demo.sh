#!/usr/bin/env bash
# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs what the examples need (on Debian), builds the program mesh_to_t_spline in build/ and turns a real mesh,
# or the one that is given, into a T-spline surface: examples/demo.sh [MESH [OPTION...]]. Results are in demo_output/.

set -euo pipefail
directory=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. test/setup.sh

# shellcheck disable=SC2086 # a list of words
install_packages $example_packages
# The tests have further needs; where they have been configured before, they stay.
tests=()
[ -e build/CMakeCache.txt ] || tests=(-DT_SPLINES_BUILD_TESTS=OFF)
configure -DT_SPLINES_BUILD_EXAMPLES=ON "${tests[@]}" >/dev/null
build --target mesh_to_t_spline

if [ $# -gt 0 ]; then
  mesh=$(cd "$directory" && realpath "$1")
  shift
else
  archive=$(demo_archive) || { echo "The meshes of libcgal-demo were not found: set T_SPLINES_DEMO_ARCHIVE." >&2; exit 1; }
  mesh=build/demo_data/data/meshes/refined_elephant.off
  [ -e "$mesh" ] || { mkdir -p build/demo_data && tar -xzf "$archive" -C build/demo_data data/meshes; }
fi

# BLAS threads cost more than they save on matrices of meshes.
OPENBLAS_NUM_THREADS=1 build/examples/mesh_to_t_spline "$mesh" -o demo_output "$@"
echo "Open this page in a browser: $PWD/demo_output/report.html"
