# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Read by test/run.sh and examples/demo.sh, which run in the project's folder:
#   install_packages PACKAGE...   installs with apt what is missing; elsewhere says what is needed
#   configure [OPTION...]         configures a Release build in build/
#   build [TARGET...]             builds

# What the examples need; the tests need more.
example_packages="g++ cmake ninja-build libcgal-dev libcgal-demo libeigen3-dev libboost-dev libgmp-dev libmpfr-dev
  libsuitesparse-dev libopenblas-dev"

is_installed()
{
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo DEBIAN_FRONTEND=noninteractive "$@"
  else
    echo "Not root, and no sudo: as root, run: $*" >&2
    return 1
  fi
}

install_packages()
{
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "This is not a Debian: nothing is installed. Needed are a C++17 compiler, CMake >= 3.18, ninja, CGAL >= 5.5" >&2
    echo "with Boost, GMP and MPFR, Eigen >= 3.3.7 and, for the tests, Catch2 2.13; CHOLMOD with BLAS is used if found." >&2
    echo "The meshes are those of Debian's package libcgal-demo: set T_SPLINES_DEMO_ARCHIVE to its data.tar.gz." >&2
    echo "On Debian 12 these are the packages:" "$@" >&2
    return 0
  fi
  local package missing=()
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} -gt 0 ]; then
    echo "Installing: ${missing[*]}"
    local install=(apt-get install -y -qq --no-install-recommends "${missing[@]}")
    "${install[@]}" --simulate >/dev/null 2>&1 || as_root apt-get update -qq || return 1
    # Old lists name versions that are gone.
    as_root "${install[@]}" || { as_root apt-get update -qq && as_root "${install[@]}"; } || return 1
  fi
}

# Prints where the meshes of libcgal-demo are, as an archive. Slim container images leave out /usr/share/doc, where the
# package keeps it: then the package is unpacked below build/.
demo_archive()
{
  local folder archive
  if [ -n "${T_SPLINES_DEMO_ARCHIVE:-}" ]; then
    echo "$T_SPLINES_DEMO_ARCHIVE"
    return 0
  fi
  for folder in / build/libcgal-demo/; do
    for archive in "$folder"usr/share/doc/libcgal-dev/data.tar.gz "$folder"usr/share/doc/libcgal-demo/data.tar.gz; do
      if [ -e "$archive" ]; then
        realpath "$archive"
        return 0
      fi
    done
  done
  [ "${1:-}" = again ] && return 1
  mkdir -p build/libcgal-demo &&
    (cd build/libcgal-demo && apt-get download libcgal-demo && dpkg-deb -x libcgal-demo_*.deb .) >&2 &&
    demo_archive again
}

configure()
{
  cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release "$@"
}

build()
{
  cmake --build build --parallel "$(nproc 2>/dev/null || echo 2)" "$@"
}
