#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the library with each compiler and its options, makes the same cuts with each, and compares the hashes.
# usage: tools/same_bits.sh CUTS
set -euo pipefail
cd "$(dirname "$0")/.."
cuts=${1:?usage: tools/same_bits.sh CUTS}

first=
configurations=0
while read -r name compiler flags; do
    folder=build/same/$name
    mkdir -p "$folder"
    { cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" \
        -DFIRMA_BUILD_CLI=OFF -DFIRMA_BUILD_TESTS=ON -DFIRMA_UNITE=ON && cmake --build "$folder" --target same_cuts; } >"$folder/build.log" 2>&1 ||
        { tail -n 40 "$folder/build.log" >&2; exit 1; }
    said=$("$folder/bin/same_cuts" levels/first.obj "$cuts")
    echo "$name: $said"
    first=${first:-$said}
    [ "$said" = "$first" ] || { echo "$name differs" >&2; exit 1; }
    configurations=$((configurations + 1))
done <<'LIST'
gcc-O0 g++ -O0
gcc-O3 g++ -O3
gcc-native g++ -O3 -march=native
clang-O0 clang++-19 -O0
clang-O3 clang++-19 -O3
clang-native clang++-19 -O3 -march=native
LIST
echo "claim=same_cuts family=total count=$configurations cuts=$cuts $first"
