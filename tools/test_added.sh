#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Users' projects, in empty folders, that have Firma's sources within: by add_subdirectory and FetchContent, as a unity
# build, static and shared, by g++ and clang 19, with and without a build type. Ends non-zero on any failure. Installs what
# is missing (apt).
#
#   tools/test_added.sh [LINE]     LINE: what the programs must print, as tools/test_install.sh shows it
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need g++ cmake ninja-build clang-19 libfast-float-dev libboost-dev libhwy-dev binutils

root=$PWD
log=$root/build/test_added.log
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p build
quietly() { "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; return 1; }; }
fail() { echo "FAILED: $*" >&2; exit 1; }

line=${1:-}
must_print() {
    local name=$1 said
    shift
    said=$("$@") || fail "$name: $said"
    if [ -z "$line" ]; then
        [[ $said =~ ^met\ bridge\ after\ 0\.20[0-9]*,\ hash\ [0-9a-f]{16}$ ]] || fail "$name prints $said"
        line=$said
    fi
    [ "$said" = "$line" ] || fail "$name prints $said, not $line"
    echo "$name: $said"
}

cp -r tests/install "$work/tests"
cp levels/first.obj "$work/"
cd "$work"

configure() { # configure FOLDER OPTION...
    local folder=$1
    shift
    quietly cmake -S tests/added -B "$folder" -G Ninja -DFIRMA_FOLDER="$root" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@"
}

# ---- how it is compiled, where nobody said how: optimised, as C++20, position independent

configure plain
compiled=$(grep -m 1 'src/cast/cast_sphere_face\|src/world/cast_world.cpp' plain/compile_commands.json)
for option in -O3 -std=c++20 -fPIC -fvisibility=hidden -ffp-contract=off -fno-fast-math; do
    [[ $compiled = *" $option "* ]] || fail "compiled without $option in a project without a build type: $compiled"
done
[[ $compiled != *-Werror* ]] || fail "warnings are errors for users"
configure debug -DCMAKE_BUILD_TYPE=Debug
! grep 'src/world/cast_world.cpp' debug/compile_commands.json | grep -q -- '-O3' || fail "-O3 in a project that asks for Debug"
echo "without a build type: compiled with -O3, as C++20, position independent, hidden; with Debug as that says"

# ---- headers that are not there are told, with the package they are in

# configure_without NAME OPTION...: those of Boost, fast_float and Highway, but for this one.
configure_without() {
    local missing=$1 name there=()
    shift
    for name in BOOST FAST_FLOAT HWY; do
        [ "$name" = "$missing" ] || there+=("-DFIRMA_${name}_INCLUDE_DIR=/usr/include")
    done
    cmake -S tests/added -B "no_$missing" -G Ninja -DFIRMA_FOLDER="$root" -DCMAKE_IGNORE_PATH="/usr/include;/usr/local/include" \
        "${there[@]}" "$@" >"$log" 2>&1
}
said() { tr '\n' ' ' <"$log" | tr -s ' ' | grep -qF "$1" || { cat "$log" >&2; fail "not said: $1"; }; }

for missing in "fast_float/fast_float.h libfast-float-dev FAST_FLOAT" "boost/multiprecision/cpp_int.hpp libboost-dev BOOST" \
    "hwy/highway.h libhwy-dev HWY"; do
    read -r header package name <<<"$missing"
    ! configure_without "$name" -DFIRMA_SIMD=ON || fail "configured without $header"
    said "Firma needs $header to be compiled: Debian's package $package"
done
configure_without HWY -DFIRMA_SIMD=AUTO || { cat "$log" >&2; fail "not configured without Highway"; }
said "Firma: no hwy/highway.h (Debian's package libhwy-dev, or -DFIRMA_HWY_INCLUDE_DIR=the folder it is in), so casts test one triangle at a time"
echo "without the headers of Boost, fast_float, Highway: told which, and Debian's package; without the last it is built all the same"

# ---- results

configure unity -DCMAKE_UNITY_BUILD=ON -DFIRMA_SIMD=OFF -DCMAKE_BUILD_TYPE=Debug
quietly cmake --build unity
must_print "add_subdirectory, unity build, no SIMD, C++" unity/crater_cpp first.obj saved.firma
must_print "add_subdirectory, unity build, no SIMD, C" unity/crater_c first.obj saved.firma
[ -f unity/libplugin.so ] || fail "no library could be made over the static one"

configure fetched -DFETCH=ON -DBUILD_SHARED_LIBS=ON -DFIRMA_UNITE=ON -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_C_COMPILER=clang-19 -DCMAKE_CXX_COMPILER=clang++-19
quietly cmake --build fetched
must_print "FetchContent, shared, clang 19, C++" fetched/crater_cpp first.obj saved.firma
must_print "FetchContent, shared, clang 19, C" fetched/crater_c first.obj saved.firma
readelf -d fetched/crater_cpp | grep -q 'NEEDED.*libfirma\.so' || fail "BUILD_SHARED_LIBS gives no shared library"
