#!/usr/bin/env bash
# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Usage: check_format.sh [CLANG_FORMAT]
# Checks that all C++ sources are laid out as .clang-format says. clang-format -i FILE... lays them out. Only version 14
# is asked: others differ in details.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
clang_format=${1:-clang-format}
if ! "$clang_format" --version | grep -q 'version 14\.'; then
  echo "$clang_format is not version 14"
  exit 2
fi

mapfile -t sources < <(find include examples test benchmark \( -name '*.h' -o -name '*.cpp' \) | sort)
if ! places=$("$clang_format" --style=file --dry-run -Werror "${sources[@]}" 2>&1); then
  echo "Not laid out as .clang-format says:"
  sed -nE 's/^([^:]*):[0-9]+:[0-9]+: error:.*/\1/p' <<< "$places" | sort -u
  exit 1
fi
