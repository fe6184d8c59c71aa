#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Iterated cuts, many tools out of one workpiece, of the cases in a folder: the Open Boolean Benchmark's study of sweeps, or any
# laid out like it (docs/benchmarks.md). By Firma natively, and in node by Firma's module beside manifold-3d.
#
#   bench/sweep_cases.sh [FOLDER] [--scale METRES] [--cuts N] [--csv FOLDER]
#     FOLDER     none: cases that it makes itself, of scenes/sweeps.h, in build/sweep_cases
#     --scale    metres a unit of the files is (128)
#     --cuts     of each case at most so many
#     --csv      tables as CSV into this folder
# Installs what is missing (apt, npm).
set -euo pipefail
folder= options=()
while [ $# -gt 0 ]; do
    case $1 in
        --scale | --cuts) options+=("$1" "$2"); shift ;;
        --csv) options+=("$1" "$(realpath -m "$2")"); mkdir -p "$2"; shift ;;
        -h | --help) sed -n '3,11p' "$0" | sed 's/^# \{0,1\}//'; exit 0 ;;
        -*) echo "sweep_cases.sh: what is $1? Try --help" >&2; exit 2 ;;
        *) folder=$(realpath "$1") ;;
    esac
    shift
done
cd "$(dirname "$0")/.."
. tools/needs.sh
need_build
need libbenchmark-dev
need_module
mkdir -p build
{ cmake --preset bench && cmake --build --preset bench --target bench_sweep_cases &&
    cmake --preset wasm && cmake --build --preset wasm --target firma_wasm firma_readers_wasm; } >build/sweep_cases.log 2>&1 ||
    { tail -n 60 build/sweep_cases.log >&2; exit 1; }
if [ ! "$folder" ]; then
    folder=$PWD/build/sweep_cases
    build/bench/bin/bench_sweep_cases --make "$folder"
fi
build/bench/bin/bench_sweep_cases "$folder" "${options[@]}"
(cd bench/node && npm ci --omit=optional --no-fund --no-audit --silent)
node bench/node/bench_sweep_cases.mjs "$folder" "${options[@]}"
