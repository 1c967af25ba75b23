#!/usr/bin/env bash
# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs mesh_to_t_spline over the meshes of fuzz_meshes, one after the other, and judges how each run ends.

set -uo pipefail

usage()
{
  cat <<'END'
usage: run_fuzz.sh PROGRAM DIRECTORY [--sample N] [--check CHECK_SURFACE] [--seconds N] [--results FILE] [-- OPTION...]

PROGRAM is mesh_to_t_spline; the OPTIONs go to it. DIRECTORY holds OFF files. Each run may take 60 CPU seconds
(--seconds) and 6 GB of memory. Writes a table of one line per mesh into FILE (DIRECTORY/results.tsv). A run ends as

  within    the report says "within the tolerance" and tells of no fault
  folded    the report says "within the tolerance", but that the surface turns over, or passes through itself
  beyond    written, but the report says that the surface is beyond the tolerance
  refused   exit code 2, with a message
  failed    exit code 1, with a message
  false     the report says "within the tolerance", but its figures, or the program CHECK_SURFACE, say otherwise
  slow      more than 60 seconds
  crash     any other exit code, a signal, or no message

The last four are faults: the script ends with 1 if there are any. --sample N takes N of the meshes, of all
kinds alike. With --check, the program check_surface measures each surface that is "within".
END
}

[ "${1:-}" = --help ] && { usage; exit 0; }
[ $# -ge 2 ] || { usage >&2; exit 2; }
program=$1
directory=$2
shift 2
sample=0 check="" seconds=60 results=$directory/results.tsv
while [ $# -gt 0 ]; do
  case $1 in
  --sample) sample=$2 ;;
  --check) check=$2 ;;
  --seconds) seconds=$2 ;;
  --results) results=$2 ;;
  --)
    shift
    break
    ;;
  *)
    usage >&2
    exit 2
    ;;
  esac
  shift 2
done

output=$(mktemp -d)
trap 'rm -rf "$output"' EXIT

# The value of a key of report.json below a key above it: number PARENT KEY prints all of them, one a line.
numbers()
{
  awk -v parent="\"$1\": {" -v key="\"$2\":" '
    index($0, parent) { inside = 1; depth = 0 }
    inside { if (index($0, key)) { sub(/^[^:]*: */, ""); sub(/,$/, ""); print }
             depth += gsub(/\{/, "{") - gsub(/\}/, "}"); if (depth <= 0) inside = 0 }' "$output/report.json"
}

# Whether one of the numbers on standard input is more than $1.
any_above()
{
  awk -v limit="$1" '$1 > limit { found = 1 } END { exit !found }'
}

# How a run with exit code 0 ended.
judge_claim()
{
  local tolerance
  tolerance=$(numbers t_spline tolerance | head -n 1)
  if [ "$(numbers t_spline is_within_tolerance)" != true ]; then
    echo beyond
  elif numbers deviation maximum | any_above "$tolerance"; then
    echo "the reported maximum is above the tolerance" >"$output/check"
    echo false
  elif { numbers deviation folded_patches; numbers deviation self_intersections_beyond_mesh; } | any_above 0; then
    echo folded
  elif [ -n "$check" ] && ! "$check" "$1" "$output/t_spline.vtu" --tolerance "$tolerance" >"$output/check" 2>&1; then
    echo false
  else
    echo within
  fi
}

judge()
{
  local exit_code=$2
  if [ "$exit_code" = $((128 + $(kill -l XCPU))) ]; then
    echo slow
  elif [ "$exit_code" = 0 ] && [ -s "$output/report.json" ]; then
    judge_claim "$1"
  elif [ "$exit_code" = 1 ] && grep -q '^mesh_to_t_spline: ' "$output/messages"; then
    echo failed
  elif [ "$exit_code" = 2 ] && grep -q '^mesh_to_t_spline: ' "$output/messages"; then
    echo refused
  else
    echo crash
  fi
}

run()
{
  (
    ulimit -c 0 -v 6000000
    ulimit -S -t "$seconds" # SIGXCPU
    export OPENBLAS_NUM_THREADS=1
    exec "$program" "$1" -o "$output" --quiet "${@:2}"
  ) >"$output/messages" 2>&1
}

meshes=("$directory"/*.off)
if [ "$sample" -gt 0 ]; then
  # Steps of a prime that is longer than the list meet every kind as often.
  all=("${meshes[@]}") meshes=()
  for ((i = 0; i < sample && i < ${#all[@]}; ++i)); do
    meshes+=("${all[$((i * 7919 % ${#all[@]}))]}")
  done
fi
printf 'mesh\tending\texit_code\tseconds\tcontrol_points\tmaximum\tmessage\n' >"$results"
TIMEFORMAT=%U
for mesh in "${meshes[@]}"; do
  rm -rf "${output:?}"/*
  { time run "$mesh" "$@"; echo $? >&3; } 2>"$output/time" 3>"$output/exit"
  exit_code=$(cat "$output/exit") cpu_seconds=$(tail -n 1 "$output/time")
  ending=$(judge "$mesh" "$exit_code")
  points="" maximum="" message=$(tr '\t\n' '  ' <"$output/messages" | tail -c 300)
  if [ -s "$output/report.json" ]; then
    points=$(numbers t_spline control_points | head -n 1)
    maximum=$(numbers deviation maximum | sort -g | tail -n 1)
    [ -s "$output/check" ] && message="$(tail -n 1 "$output/check")"
  fi
  printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$(basename "$mesh")" "$ending" "$exit_code" "$cpu_seconds" "$points" \
    "$maximum" "$message" | tee -a "$results"
done
tail -n +2 "$results" | cut -f 2 | sort | uniq -c
! tail -n +2 "$results" | cut -f 2 | grep -q -x -e failed -e false -e slow -e crash
