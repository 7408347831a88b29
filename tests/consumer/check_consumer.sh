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
refused() { # WHAT ASKS FOR: a project that asks for this is told so at configuration, and why
  mkdir -p "$work/refused"
  printf 'cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\nfind_package(%s)\n' "$2" >"$work/refused/CMakeLists.txt"
  if cmake -G Ninja -S "$work/refused" -B "$work/refused/build" -DCMAKE_PREFIX_PATH="$work/moved" >"$work/log" 2>&1 ||
     ! tr -s ' \n' ' ' <"$work/log" | grep -q "$3"; then
    cat "$work/log" >&2; echo "$1 was found" >&2; exit 1
  fi
  rm -r "$work/refused"
}
refused "a component that does not exist" "Skein 0.1 REQUIRED COMPONENTS levitation" levitation
refused "a later minor version" "Skein 0.2 REQUIRED COMPONENTS executive" 'compatible with requested version "0.2"'
refused "another major version" "Skein 1.0 REQUIRED COMPONENTS executive" 'compatible with requested version "1.0"'

libdir=$(dirname "$(find "$work/moved" -name pkgconfig)")
export PKG_CONFIG_PATH=$libdir/pkgconfig
# Every component as pkg-config sees it: complete, and of this version.
version=$(sed -n 's/^set(PACKAGE_VERSION "\(.*\)")$/\1/p' "$libdir/cmake/Skein/SkeinConfigVersion.cmake")
for file in "$PKG_CONFIG_PATH"/skein-*.pc; do
  pkg-config --print-errors --exists "$(basename "$file" .pc) = $version"
  component=$(basename "$file" .pc)
  grep -qF "\`${component#skein-}\`" "$here/../../docs/library.md" ||
    { echo "component ${component#skein-} is not in docs/library.md" >&2; exit 1; }
done
for header in $(grep -o 'skein/[a-z_/]*\.hpp' "$here/../../docs/library.md"); do
  [ -f "$work/moved/include/$header" ] || { echo "docs/library.md: $header is not installed" >&2; exit 1; }
done
read -ra flags < <(pkg-config --cflags --libs skein-executive skein-htn skein-refiners skein-temporal)
"$cxx" -std=c++20 "$work/errand.cpp" -o "$work/by-pkg-config" "${flags[@]}"
"$work/by-pkg-config"
