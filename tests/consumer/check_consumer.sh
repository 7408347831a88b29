#!/usr/bin/env bash
# check_consumer.sh BUILD CXX: installs Skein from its build tree into a folder that goes away, builds
# the project beside this file against it as a stranger would, by CMake and by pkg-config, and runs both.
set -euo pipefail
build=$1 cxx=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
fail() { cat "$work/log" >&2; exit 1; }
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/as-installed" --component development >"$work/log" 2>&1 || fail
mv "$work/as-installed" "$work/moved" # what is installed may be moved
cp "$here/CMakeLists.txt" "$here/errand.cpp" "$work"

cmake -G Ninja -S "$work" -B "$work/build" -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_PREFIX_PATH="$work/moved" >"$work/log" 2>&1 || fail
cmake --build "$work/build" >"$work/log" 2>&1 || fail
"$work/build/consumer"
if grep -rqsE 'fastrtps|gdal' "$work/build/build.ninja"; then
  echo "a project without DDS and maps is linked with them" >&2; exit 1
fi
if cmake -S "$work" -B "$work/other" -DCMAKE_PREFIX_PATH="$work/moved" -DSkein_FIND_VERSION=9 \
     -DCMAKE_PROJECT_INCLUDE="$here/asks_for_too_much.cmake" >"$work/log" 2>&1; then
  echo "a component that does not exist was found" >&2; exit 1
fi

libdir=$(dirname "$(find "$work/moved" -name pkgconfig)")
export PKG_CONFIG_PATH=$libdir/pkgconfig
read -ra flags < <(pkg-config --cflags --libs skein-executive skein-htn skein-refiners skein-temporal)
"$cxx" -std=c++20 "$work/errand.cpp" -o "$work/by-pkg-config" "${flags[@]}"
"$work/by-pkg-config"
