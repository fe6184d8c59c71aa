#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# full_casts for 64-bit ARM, run by qemu: the kernel compiled in is that of NEON there. The tests themselves are not built
# for ARM, as that needs a gtest for it.
#
#   casts_neon.sh [OPTION...]    options of full_casts
set -euo pipefail
cd "$(dirname "$0")/../.."
. tools/needs.sh
need g++-aarch64-linux-gnu qemu-user libboost-dev >&2
build=build/aarch64_full
mkdir -p "$build/include"
ln -sfn /usr/include/boost "$build/include/boost"

# quiet COMMAND...: says something only when it fails.
quiet() { "$@" >"$build/build.log" 2>&1 || { tail -n 40 "$build/build.log" >&2; return 1; }; }

# FIRMA_BUILD_COUNTS: scenes are built where something needs them.
quiet cmake --preset aarch64 -B "$build" -DFIRMA_BUILD_COUNTS=ON -DFIRMA_UNITE=ON
quiet cmake --build "$build" --target firma firma_scenes
program=$build/full_casts
aarch64-linux-gnu-nm -C "$build/libfirma.a" 2>/dev/null | grep -c 'N_NEON::sweep_lanes' >/dev/null || { echo "casts_neon.sh: no lanes of NEON in $build/libfirma.a" >&2; exit 1; }
sources=(tests/full/full_casts.cpp tests/reference/{exact_number,exact_polygon,exact_oracle,judge,judge_scene,surely_apart}.cpp)
quiet aarch64-linux-gnu-g++ -std=c++20 -O2 -ffp-contract=off -Iinclude -Isrc -I. -isystem "$build/include" "${sources[@]}" \
    "$build/scenes/libfirma_scenes.a" "$build/libfirma.a" -lpthread -o "$program"
exec qemu-aarch64 -L /usr/aarch64-linux-gnu "$program" --kernel compiled "$@"
