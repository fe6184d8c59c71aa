#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the same cuts, casts and edit log, and moves the same bodies, players and projectiles, with the library built in every
# way that Firma is built in, and compares what came back.
#
#   tools/same_everywhere.sh CUTS CASTS [WAY...]
#
# Ways: gcc-O3 gcc-O0 gcc-native clang-O3; aarch64, run by qemu; node and chromium, which run the module; test, what
# the preset of that name has built. All but the last unless given. FIRMA_LEVEL: another level than levels/first.obj, for
# cuts and casts.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
cuts=${1:?usage: tools/same_everywhere.sh CUTS CASTS [WAY...]}
casts=${2:?usage: tools/same_everywhere.sh CUTS CASTS [WAY...]}
shift 2
[ $# -gt 0 ] || set -- gcc-O3 gcc-O0 gcc-native clang-O3 aarch64 node chromium
level=${FIRMA_LEVEL:-levels/first.obj}
games=(levels/first.obj 600)
module=build/wasm/bin/firma.wasm
games_module=build/wasm/bin/firma_games.wasm
folder=build/same_everywhere
mkdir -p "$folder"

# quiet COMMAND...: says something only when it fails.
quiet() { "$@" >"$folder/build.log" 2>&1 || { tail -n 40 "$folder/build.log" >&2; return 1; }; }

# Packages, with nothing said among the answers.
install() { need "$@" >&2; }

# link NAME C_COMPILER C++_COMPILER BUILD: the two programs over what was built there.
link() {
    local program
    for program in everywhere games; do
        local object=$folder/$1_$program.o
        quiet "$2" -std=c17 -O2 -ffp-contract=off -Wall -Wextra -Wshadow -Werror -Iinclude -c "tests/full/same_$program.c" -o "$object"
        quiet "$3" "$object" "$4/bindings/c/libfirma_c.a" "$4/libfirma.a" -lpthread -o "$folder/$1_$program"
    done
}

# both NAME [EMULATOR...]: runs them.
both() {
    local name=$1
    shift
    "$@" "$folder/${name}_games" "${games[@]}"
    "$@" "$folder/${name}_everywhere" "$level" "$cuts" "$casts"
}

# native NAME C_COMPILER C++_COMPILER FLAGS: the same build folders as tools/same_bits.sh has.
native() {
    local build=build/same/$1
    quiet cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$3" -DCMAKE_CXX_FLAGS="$4" -DFIRMA_BUILD_CLI=OFF -DFIRMA_UNITE=ON
    quiet cmake --build "$build" --target firma_c
    link "$1" "$2" "$3" "$build"
    both "$1"
}

# preset NAME TARGET...
preset() { quiet cmake --preset "$1" && quiet cmake --build --preset "$1" --target "${@:2}"; }

build_module() {
    need_module >&2
    preset wasm firma_wasm firma_games_wasm firma_readers_wasm
}

run() {
    case $1 in
        gcc-O3) native "$1" gcc g++ -O3 ;;
        gcc-O0) native "$1" gcc g++ -O0 ;;
        gcc-native) native "$1" gcc g++ "-O3 -march=native" ;;
        clang-O3) install clang-19 && native "$1" clang-19 clang++-19 -O3 ;;
        test)
            preset test firma_c
            link "$1" gcc g++ build/test
            both "$1" ;;
        aarch64)
            install g++-aarch64-linux-gnu qemu-user
            preset aarch64 firma_c
            link "$1" aarch64-linux-gnu-gcc aarch64-linux-gnu-g++ build/aarch64
            both "$1" qemu-aarch64 -L /usr/aarch64-linux-gnu ;;
        node)
            build_module
            node tests/full/same_games.mjs "$games_module" "${games[@]}"
            node tests/full/same_everywhere.mjs "$module" "$level" "$cuts" "$casts" ;;
        chromium)
            build_module
            command -v chromium >/dev/null || install chromium
            node tests/full/same_everywhere_browser.mjs "$games_module" "${games[@]}" "$module" "$level" "$cuts" "$casts" ;;
        *) echo "what is $1?" >&2; return 2 ;;
    esac
}

need_build
rm -f "$folder"/*.txt
differ=0
for way in "$@"; do
    # In a shell of its own and not in a condition, so that any failure ends it.
    (run "$way" >"$folder/$way.txt") &
    wait $! || { echo "$way: failed" >&2; exit 1; }
    echo "$way: $(tail -n 2 "$folder/$way.txt" | tr '\n' ' ')"
    cmp "$folder/$1.txt" "$folder/$way.txt" || differ=1
done
[ $differ = 0 ] || { echo "not the same everywhere: see $folder/*.txt" >&2; exit 1; }
everything=$(tail -n 1 "$folder/$1.txt" | grep -o 'everything=.*')
echo "claim=same_everywhere family=total count=$# cuts=$cuts casts=$casts $everything"
