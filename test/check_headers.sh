#!/usr/bin/env bash
# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: check_headers.sh INCLUDE_DIRECTORY
# Checks what every header owes: its licence line, a guard that is named after its path, at most 800 lines, no output,
# no end of the program, no plain assert; that the header of the whole package has them all; and that rooms include
# only those headers of other rooms that the page "Rooms" of the manual names; and that the manual has the tolerances.

set -u
manual=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/doc/T_splines/T_splines.txt
cd "$1" || exit 2
failures=0

complain()
{
  if [ -n "$2" ]; then
    printf '%s\n%s\n' "$1" "$2"
    failures=$((failures + 1))
  fi
}

mapfile -t headers < <(find . -name '*.h' -printf '%P\n' | sort)
if [ ${#headers[@]} -eq 0 ]; then
  echo "no headers in $1"
  exit 2
fi

complain "Output, end of the program or plain assert:" \
  "$(grep -nE 'std::(cerr|cout|clog|exit|abort|terminate)\b|(^|[^_[:alnum:]])(f?printf|puts|exit|abort|assert) *\(|<(cassert|iostream)>' \
     "${headers[@]}")"
complain "No SPDX line in the first two lines:" \
  "$(for h in "${headers[@]}"; do
       [ "$(sed -n 2p "$h")" = "// SPDX-License-Identifier: GPL-3.0-or-later" ] || echo "$h"
     done)"
complain "More than 800 lines:" "$(for h in "${headers[@]}"; do [ "$(wc -l < "$h")" -le 800 ] || echo "$h"; done)"

# The list of named parameters is included several times: it has no guard.
complain "No include guard named after the path:" \
  "$(for h in "${headers[@]}"; do
       [ "$h" = CGAL/T_splines/internal/named_parameters_list.h ] && continue
       guard=$(printf '%s' "$h" | tr '[:lower:]/.-' '[:upper:]___')
       grep -qx "#define $guard" "$h" || echo "$h: $guard"
     done)"

complain "Public headers that CGAL/T_splines.h does not include:" \
  "$(for h in "${headers[@]}"; do
       case "$h" in
         */internal/* | */support/* | CGAL/T_splines.h) ;;
         *) grep -qx "#include <$h>" CGAL/T_splines.h || echo "$h" ;;
       esac
     done)"

# ROOM:OTHER, ROOM may include public headers of OTHER; ROOM:OTHER/support, also those of its folder support. The folder
# internal of a room is its own.
doors=" Cross_field:Solver Cross_field:Solver/support
  Similarity_map:Cross_field Similarity_map:Cross_field/support Similarity_map:Solver Similarity_map:Solver/support
  Tracing:Similarity_map Tracing:Similarity_map/support Tracing:T_mesh
  Spline:T_mesh Spline:T_mesh/support Spline:Solver Spline:Solver/support
  IO:Cross_field IO:Cross_field/support IO:T_mesh IO:Spline
  Approximation:Cross_field Approximation:Similarity_map Approximation:Tracing Approximation:T_mesh
  Approximation:Spline "
used=$(for h in "${headers[@]}"; do
    room=$(expr "$h" : 'CGAL/T_splines/\([A-Z][A-Za-z_]*\)/') || continue
    sed -nE "s@^#include <CGAL/T_splines/([A-Z][A-Za-z_]*)(/internal|/support)?/.*@$room:\1\2 $h@p" "$h"
  done | sort -u)
complain "Includes from room to room that the page \"Rooms\" of the manual does not name:" \
  "$(while read -r door header; do
       room=${door%%:*} other=${door#*:}
       [ "${other%%/*}" = "$room" ] || [[ $doors == *[[:space:]]"$door"[[:space:]]* ]] || echo "$header: $other"
     done <<< "$used")"
complain "Doors that no header uses:" \
  "$(for door in $doors; do grep -q "^$door " <<< "$used" || echo "$door"; done)"

complain "Tolerances that the manual does not have in its table:" \
  "$(sed -nE 's/^inline constexpr double ([a-z_]+) = ([^;]*);.*/| `\1` | \2 |/p' CGAL/T_splines/internal/tolerances.h |
       while read -r row; do grep -qF "$row" "$manual" || echo "$row"; done)"

exit $((failures > 0))
