#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Records a fight in the depot with the library built in one way, and replays it with the library built in others.
# The recording that each way makes itself must have the same bytes.
#
#   tools/same_games.sh [WAY...]
#
# Ways: gcc-O3 gcc-O0 gcc-native clang-O3; aarch64, run by qemu; test, what the preset of that name has built. All but the
# last unless given; the first one records.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
[ $# -gt 0 ] || set -- gcc-O3 gcc-O0 gcc-native clang-O3 aarch64
folder=build/same_games
mkdir -p "$folder"

# quiet COMMAND...: says something only when it fails.
quiet() { "$@" >"$folder/build.log" 2>&1 || { tail -n 40 "$folder/build.log" >&2; return 1; }; }

# link WAY C++_COMPILER BUILD: the program over what was built there.
link() {
    quiet "$2" -std=c++20 -O1 -ffp-contract=off -I. -Iinclude -Isrc -DFIRMA_ROOT="\"$PWD\"" tests/full/same_games.cpp "$3/libfirma.a" \
        -lpthread -o "$folder/$1"
}

# native WAY C++_COMPILER FLAGS: the same build folders as tools/same_bits.sh has.
native() {
    quiet cmake -S . -B "build/same/$1" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" \
        -DFIRMA_BUILD_CLI=OFF -DFIRMA_UNITE=ON
    quiet cmake --build "build/same/$1" --target firma
    link "$1" "$2" "build/same/$1"
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
        *) echo "what is $1?" >&2; return 2 ;;
    esac
}

# run WAY ARGUMENT...
run() {
    if [ "$1" = aarch64 ]; then
        qemu-aarch64 -L /usr/aarch64-linux-gnu "$folder/$1" "${@:2}"
    else
        "$folder/$1" "${@:2}"
    fi
}

need_build
rm -f "$folder"/*.firmarec
for way in "$@"; do
    build "$way"
    run "$way" record "$folder/$way.firmarec" >/dev/null
    said=$(run "$way" replay "$folder/$1.firmarec")
    cmp "$folder/$1.firmarec" "$folder/$way.firmarec"
    echo "$way: $said"
done
echo "claim=same_games family=total count=$# $said"
