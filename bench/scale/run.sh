#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Firma beside the libraries that Debian has (Embree, Bullet, CGAL, FCL) and, in node, beside jolt-physics, on scenes of ten
# thousand to ten million triangles: builds, memory, casts, cuts, and whether the answers agree. Tables go to
# bench/results/scale_*.csv and docs/benchmarks.md, pictures to docs/pictures/scale_*.svg.
#
#   bench/scale/run.sh [--quick | --full] [--rounds N] [--no-node]
#     (nothing)   up to a million triangles: 5 to 10 minutes
#     --full      ten million as well, and slow libraries on larger scenes: 10 to 30 minutes, 8 GB
#     --quick     ten thousand, few casts; tables and pictures to build/scale/quick alone
#     --no-node   without jolt-physics, for who has no node
# Installs what is missing (apt, npm).
set -euo pipefail
cd "$(dirname "$0")/../.."
. tools/needs.sh

results=bench/results pictures=docs/pictures page=docs/benchmarks.md
options=() node_options=() with_node=1
while [ $# -gt 0 ]; do
    case $1 in
        --quick) options+=(--quick) node_options+=(--quick) results=build/scale/quick pictures=build/scale/quick page= ;;
        --full) options+=(--full) ;;
        --rounds) options+=(--rounds "$2"); shift ;;
        --no-node) with_node= ;;
        -h | --help) sed -n '3,12p' "$0" | sed 's/^# \{0,1\}//'; exit 0 ;;
        *) echo "run.sh: what is $1? Try --help" >&2; exit 2 ;;
    esac
    shift
done

need_build
need libbenchmark-dev libembree-dev libbullet-dev libcgal-dev libgmp-dev libmpfr-dev libfcl-dev
mkdir -p "$results" "$pictures" build
unite=()
[ -e build/scale/CMakeCache.txt ] || unite=(-DFIRMA_UNITE=ON)
log=build/scale.log
# For any processor of this kind, as users get it: what is faster on this one, each library must find out by itself.
{ cmake -S . -B build/scale -G Ninja -DCMAKE_BUILD_TYPE=Release -DFIRMA_BUILD_BENCH=ON -DFIRMA_BENCH_SCALE=ON \
    -DFIRMA_BUILD_CLI=OFF "${unite[@]}" && cmake --build build/scale --target bench_scale; } >"$log" 2>&1 || { tail -n 60 "$log" >&2; exit 1; }

rm -rf build/scale/dump
mkdir -p build/scale/dump
build/scale/bin/bench_scale "${options[@]}" --csv "$results" --dump build/scale/dump

if [ "$with_node" ]; then
    need_module
    { cmake --preset wasm && cmake --build --preset wasm --target firma_wasm firma_readers_wasm; } >"$log" 2>&1 || { tail -n 60 "$log" >&2; exit 1; }
    (cd bench/node && npm ci --omit=optional --no-fund --no-audit --silent)
    node --max-old-space-size=4096 bench/node/bench_scale.mjs build/scale/dump "${node_options[@]}" --csv "$results"
fi

/usr/bin/python3 bench/scale/plot.py "$results" "$pictures"
[ ! "$page" ] || /usr/bin/python3 bench/fill_tables.py "$page" "$results"
