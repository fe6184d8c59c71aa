#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Firma's modules in node beside jolt-physics, rapier3d-simd-compat and manifold-3d; tables as CSV into a folder.
#
#   bench/node/run.sh [--quick] [--csv FOLDER]
set -euo pipefail
arguments=()
for word in "$@"; do
    [[ $word == -* ]] || word=$(realpath -m "$word")
    arguments+=("$word")
done
cd "$(dirname "$0")/../.."
. tools/needs.sh
need_build
need_module
cmake --preset wasm >/dev/null
cmake --build --preset wasm --target firma_wasm firma_games_wasm firma_readers_wasm >/dev/null
cmake -S . -B build/bodies -G Ninja -DCMAKE_BUILD_TYPE=Release -DFIRMA_BUILD_BENCH=ON -DFIRMA_UNITE=ON >/dev/null
cmake --build build/bodies --target bench_bodies >/dev/null
tools/unpack_openarena.sh build/openarena
build/bodies/bin/bench_bodies build/body_scenes
cd bench/node
npm ci --omit=optional --no-fund --no-audit --silent
node bench_casts.mjs "${arguments[@]}"
node bench_cuts.mjs "${arguments[@]}"
node bench_sweeps.mjs "${arguments[@]}"
node bench_bodies.mjs "${arguments[@]}"
node bench_players.mjs "${arguments[@]}"
