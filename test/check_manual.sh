#!/usr/bin/env bash
# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: check_manual.sh [OUTPUT_DIRECTORY]
# Builds the manual with doxygen and fails on any warning: a public name without a comment, a parameter that does not
# exist, a broken link, a missing example. With an OUTPUT_DIRECTORY the HTML stays there; begin with its index.html.

set -euo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
output=$work/html
if [ $# -gt 0 ]; then
  mkdir -p "$1"
  output=$(cd "$1" && pwd)
fi

# CGAL's build of its manual sets the same variables.
configure()
{
  sed -e "s|\${CGAL_DOC_PACKAGE_DEFAULTS}|$work/Package_defaults|g" \
    -e "s|\${CGAL_DOC_OUTPUT_DIR}|$output|g" \
    -e "s|\${CGAL_PACKAGE_DOC_DIR}|$project/doc/T_splines|g" \
    -e "s|\${CGAL_PACKAGE_INCLUDE_DIR}|$project/include|g" \
    -e "s|\${CGAL_PACKAGE_DIR}|$project|g" \
    -e "s|\${T_SPLINES_DOXYGEN_DIR}|$project/doc/doxygen|g" \
    -e "s|CGAL \${CGAL_DOC_VERSION} - ||g" "$1"
}
mkdir -p "$output"
configure "$project/doc/doxygen/Package_defaults.in" > "$work/Package_defaults"
configure "$project/doc/T_splines/Doxyfile.in" > "$work/Doxyfile"
if grep -n '\${' "$work/Package_defaults" "$work/Doxyfile"; then
  echo "A variable has no value."
  exit 1
fi

if ! doxygen "$work/Doxyfile" > /dev/null 2> "$work/warnings" || [ -s "$work/warnings" ]; then
  cat "$work/warnings"
  exit 1
fi
