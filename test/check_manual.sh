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

failures=0
complain()
{
  if [ -n "$2" ]; then
    printf '%s\n%s\n' "$1" "$2"
    failures=$((failures + 1))
  fi
}

complain "Variables without a value:" "$(grep -n '\${' "$work/Package_defaults" "$work/Doxyfile" || true)"

doxygen "$work/Doxyfile" > /dev/null 2> "$work/warnings" || echo "doxygen failed" >> "$work/warnings"
complain "Warnings of doxygen:" "$(cat "$work/warnings")"

# What doxygen does not look at.
cd "$project"
mapfile -t headers < <(find include -name '*.h' -not -path '*/internal/*' -not -path '*/support/*' | sort)
complain "Groups that PackageDescription.txt does not define:" \
  "$(grep -rhoE '\\ingroup +[[:alnum:]_]+' "${headers[@]}" doc/T_splines | sort -u | while read -r _ group; do
       grep -qE "\\\\defgroup $group " doc/T_splines/PackageDescription.txt || echo "$group"
     done)"
complain "Public names in no group:" \
  "$(awk 'FNR == 1 { was_comment = 0; is_internal = 0 }
       /^namespace internal/ { is_internal = 1 }
       /^} \/\/ namespace internal/ { is_internal = 0 }
       /^\/\/\/ \\(cond|endcond|file)/ { was_comment = 1; next }
       /^\/\/\// { if (!was_comment && !is_internal && !/\\ingroup/) { file = FILENAME; line = FNR; pending = 1 }
                  was_comment = 1; next }
       { if (pending && !/^namespace/) print file ":" line; pending = 0; was_comment = 0 }' "${headers[@]}")"
complain "Named parameters that no function documents:" \
  "$(sed -n 's/^CGAL_T_SPLINES_NAMED_PARAMETER(\(.*\))$/\1/p' include/CGAL/T_splines/internal/named_parameters_list.h |
       while read -r name; do grep -qF "\\cgalParamNBegin{$name}" "${headers[@]}" || echo "$name"; done)"
complain "Examples that examples.txt does not list:" \
  "$(for example in examples/T_splines/*.cpp; do
       grep -qxF "\\example ${example#examples/}" doc/T_splines/examples.txt || echo "$example"
     done)"

complain "Names in the manual that the headers do not have:" \
  "$( (grep -hoE '\bT::(parameters::)?[A-Za-z_0-9]+' doc/T_splines/T_splines.txt | sed 's/.*:://'
       cat "$output"/*.html | grep -oE '<code>(CGAL::T_splines::)?[A-Za-z_0-9]+\(\)</code>' | sed -E 's/<[^>]*>//g; s/.*:://; s/\(\)//'
       cat "$output"/*.html | grep -oE '<code>CGAL::T_splines::[A-Za-z_0-9]+' | sed 's/.*:://') | sort -u |
     while read -r name; do grep -rqw "$name" include doc/T_splines/Concepts || echo "$name"; done)"

# Concepts are classes to doxygen.
for page in $(grep -l 'class="concept"' "$output"/class*.html); do
  sed -i -e 's/ Class Reference/ Concept Reference/' -e '/#include &lt;Concepts\//d' "$page"
done

exit $((failures > 0))
