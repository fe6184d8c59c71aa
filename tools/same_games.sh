#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Records a fight in the depot with the library built in one way, and replays it with the library built in others.
# The recording that each way makes itself must have the same bytes.
#
#   tools/same_games.sh [WAY...]
#
# Ways: gcc-O3 gcc-O0 gcc-native clang-O3; aarch64, run by qemu; windows, run by wine; node and chromium, which replay by
# the module and record nothing; test, what the preset of that name has built. All but the last unless given; the first
# one records.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
[ $# -gt 0 ] || set -- gcc-O3 gcc-O0 gcc-native clang-O3 aarch64 windows node chromium
folder=build/same_games
mkdir -p "$folder"

# quiet COMMAND...: says something only when it fails.
quiet() { "$@" >"$folder/build.log" 2>&1 || { tail -n 40 "$folder/build.log" >&2; return 1; }; }

# link WAY C++_COMPILER BUILD [FLAG...]: the program over what was built there.
link() {
    quiet "$2" -std=c++20 -O1 -ffp-contract=off -I. -Iinclude -Isrc -DFIRMA_ROOT="\"$PWD\"" tests/full/same_games.cpp "$3/libfirma.a" \
        "${@:4}" -lpthread -o "$folder/$1"
}

# native WAY C++_COMPILER FLAGS: the same build folders as tools/same_bits.sh has.
native() {
    quiet cmake -S . -B "build/same/$1" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" \
        -DFIRMA_BUILD_CLI=OFF -DFIRMA_UNITE=ON
    quiet cmake --build "build/same/$1" --target firma
    # Without optimisation nothing is fused, and objdump takes a quarter of an hour for it.
    [ "$3" = -O0 ] || nothing_fuses "build/same/$1/libfirma.a"
    link "$1" "$2" "build/same/$1"
}

# nothing_fuses LIBRARY: has no instruction that multiplies and adds at once, whose bits differ.
nothing_fuses() {
    ! objdump -dC "$1" | awk '/^[0-9a-f]+ <.*>:$/ { name = $0 } /\tvf(n?m)(add|sub)/ { print name; any = 1 } END { exit !any }' | sort -u >&2 ||
        { echo "$1: these functions fuse" >&2; return 1; }
}

build() {
    case $1 in
        gcc-O3) native "$1" g++ -O3 ;;
        gcc-O0) native "$1" g++ -O0 ;;
        gcc-native) native "$1" g++ "-O3 -march=native" ;;
        clang-O3) native "$1" clang++-19 -O3 ;;
        test)
            quiet cmake --preset test
            quiet cmake --build --preset test --target firma
            link "$1" g++ build/test ;;
        aarch64)
            need g++-aarch64-linux-gnu qemu-user >&2
            quiet cmake --preset aarch64
            quiet cmake --build --preset aarch64 --target firma
            link "$1" aarch64-linux-gnu-g++ build/aarch64 ;;
        windows)
            need g++-mingw-w64-x86-64-posix wine wine64 libfast-float-dev libboost-dev libhwy-dev >&2
            quiet cmake -S . -B build/windows -G Ninja "-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/mingw.cmake" -DFIRMA_UNITE=ON \
                -DFIRMA_SHARED=ON -DFIRMA_BUILD_CLI=OFF -DFIRMA_BUILD_TESTS=ON
            quiet cmake --build build/windows --target firma
            link "$1" x86_64-w64-mingw32-g++-posix build/windows -static
            # What wine keeps of a user.
            [ -d "$WINEPREFIX" ] || quiet wine wineboot --init ;;
        node | chromium)
            need_module >&2
            quiet cmake --preset wasm
            quiet cmake --build --preset wasm --target firma_recordings_wasm
            [ "$1" = node ] || command -v chromium >/dev/null || need chromium >&2 ;;
        *) echo "what is $1?" >&2; return 2 ;;
    esac
}

# run WAY ARGUMENT...
run() {
    case $1 in
        aarch64) qemu-aarch64 -L /usr/aarch64-linux-gnu "$folder/$1" "${@:2}" ;;
        windows) wine "$folder/$1.exe" "${@:2}" | tr -d '\r' ;;
        *) "$folder/$1" "${@:2}" ;;
    esac
}

# replay WAY RECORDING: what it says.
replay() {
    case $1 in
        node) node tests/full/replay_recording.mjs build/wasm/bin/firma_recordings.wasm "$2" ;;
        chromium) node tests/full/replay_recording_browser.mjs build/wasm/bin/firma_recordings.wasm "$2" ;;
        *)
            run "$1" record "$folder/$1.firmarec" >/dev/null
            cmp "$2" "$folder/$1.firmarec" >&2
            run "$1" replay "$2" ;;
    esac
}

need_build
export WINEPREFIX=$PWD/$folder/wine WINEDEBUG=-all DISPLAY= WINEDLLOVERRIDES='mscoree,mshtml='
rm -f "$folder"/*.firmarec
first=
for way in "$@"; do
    build "$way"
    said=$(replay "$way" "$folder/$1.firmarec")
    echo "$way: $said"
    first=${first:-$said}
    [ "$said" = "$first" ] || { echo "$way does not end as $1 does" >&2; exit 1; }
done
echo "claim=same_games family=total count=$# $first"
