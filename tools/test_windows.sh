#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the library and the C API for 64-bit Windows with mingw-w64, installs them, and runs their tests and users'
# programs under wine. Ends non-zero on any failure. Installs what is missing (apt).
#
#   tools/test_windows.sh [LINE]     LINE: what the programs must print, as tools/test_install.sh shows it
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need cmake ninja-build g++-mingw-w64-x86-64-posix wine wine64 libfast-float-dev libboost-dev libhwy-dev libgtest-dev python3

log=$PWD/build/test_windows.log
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p build
quietly() { "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; return 1; }; }
fail() { echo "FAILED: $*" >&2; exit 1; }

# A folder of settings of its own, and no window.
export WINEPREFIX=$work/wine WINEDEBUG=-all DISPLAY= WINEDLLOVERRIDES='mscoree,mshtml='
quietly wine wineboot --init
line=${1:-}
must_print() {
    local name=$1 said
    shift
    said=$("$@" | tr -d '\r') || fail "$name: $said"
    if [ -z "$line" ]; then
        [[ $said =~ ^met\ bridge\ after\ 0\.20[0-9]*,\ hash\ [0-9a-f]{16}$ ]] || fail "$name prints $said"
        line=$said
    fi
    [ "$said" = "$line" ] || fail "$name prints $said, not $line"
    echo "$name: $said"
}

toolchain=-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/mingw.cmake
quietly cmake -S . -B build/windows -G Ninja "$toolchain" -DFIRMA_UNITE=ON -DFIRMA_SHARED=ON -DFIRMA_BUILD_CLI=OFF -DFIRMA_BUILD_TESTS=ON
quietly cmake --build build/windows --target firma firma_c firma_c_shared
quietly cmake --install build/windows --prefix "$work/prefix"

# ---- users' projects over what was installed

cp levels/first.obj "$work/"
for form in static shared; do
    quietly cmake -S tests/install/windows -B "$work/$form" -G Ninja "$toolchain" -DFORM=$form -Dfirma_DIR="$work/prefix/lib/cmake/firma"
    quietly cmake --build "$work/$form"
done
cp "$work"/prefix/bin/*.dll "$work/shared/"
cd "$work"
must_print "Windows, C++, static" wine static/crater_cpp.exe first.obj saved.firma
must_print "Windows, C, static" wine static/crater_c.exe first.obj saved.firma
must_print "Windows, C, DLL" wine shared/crater_c.exe first.obj saved.firma
cd - >/dev/null

# ---- the library's tests and those of the C API

quietly cmake --build build/windows --target firma_tests firma_boost_tests firma_c_tests
quietly wine build/windows/bin/firma_c_tests.exe build/windows
echo "Windows: the tests of the C API passed"
# Two at a time, as each keeps one processor busy.
# Tests of seconds each (tests/slow.txt) run natively alone.
export GTEST_FILTER="-$(grep -v '^#' tests/slow.txt | paste -sd:)"
running=() logs=()
run_tests() {
    logs+=("$work/$1.$2.log")
    GTEST_SHARD_INDEX=$2 GTEST_TOTAL_SHARDS=$3 wine build/windows/bin/$1.exe --gtest_brief=1 >"${logs[-1]}" 2>&1 &
    running+=($!)
}
run_tests firma_tests 0 2
run_tests firma_tests 1 2
wait "${running[0]}" || { tail -n 60 "${logs[0]}" >&2; fail "firma_tests"; }
run_tests firma_boost_tests 0 1
for k in 1 2; do wait "${running[k]}" || { tail -n 60 "${logs[k]}" >&2; fail "${logs[k]}"; }; done
for log in "${logs[@]}"; do
    passed=$(tr -d '\r' <"$log" | sed -n 's/^\[  PASSED  \] \([0-9]* tests\?\)\.$/\1/p')
    [ -n "$passed" ] || fail "$log does not say how many tests passed"
    echo "Windows: $passed of $(basename "$log" .log) passed"
done
