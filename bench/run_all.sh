#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All benchmarks, one after the other, and their tables into docs/benchmarks.md. About three quarters of an hour.
#
#   bench/run_all.sh [name ...]        only these: the article's questions (formulas inside boxes edges tree subdivision
#                                      stop_distance), first_level pieces carve carve_allocations carve_cgal
#                                      carve_rebuild carved_casts versions region_meshes levels save repair store peers openarena node
#                                      sweeps digs chunks living matter hostile cgal_exact scale
set -eu

repository=$(cd "$(dirname "$0")/.." && pwd)
results=$repository/bench/results
cd "$repository"
. tools/needs.sh
need_build
need libbenchmark-dev libcgal-dev libgmp-dev libmpfr-dev
mkdir -p "$results"
cmake --preset bench >/dev/null
cmake --build --preset bench >/dev/null

pieces() {
    build/bench/bin/bench_pieces --benchmark_enable_random_interleaving=true --benchmark_repetitions=9 \
        --benchmark_report_aggregates_only=true --benchmark_min_time=0.1 --benchmark_format=csv 2>/dev/null |
        awk -F, 'BEGIN { print "piece,casts,ns" }
            /_median/ { gsub(/"/, ""); sub(/_median/, "", $1); ns = $4 * ($5 == "ms" ? 1e6 : 1); label = NF >= 9 ? $8 "," $9 : $8
                        gsub(/,error_.*|,$/, "", label); printf "%s,\"%s\",%.4g\n", $1, label, ns }' | { IFS= read -r head; echo "$head"; sort; } >"$results/pieces.csv"
    cat "$results/pieces.csv"
}

[ $# -gt 0 ] || set -- formulas inside boxes edges tree subdivision stop_distance first_level pieces \
    many edit_index carve carve_allocations carve_cgal carve_rebuild carved_casts versions region_meshes levels save repair store openarena peers node \
    sweeps digs chunks living matter hostile cgal_exact scale
for name in "$@"; do
    echo "--- $name"
    case $name in
        formulas | inside | boxes | edges | tree | subdivision | stop_distance)
            build/bench/bin/bench_article "$name" --csv "$results" ;;
        pieces) pieces ;;
        openarena) cmake --preset release >/dev/null && cmake --build --preset release >/dev/null && bench/openarena.sh ;;
        levels) tools/unpack_openarena.sh && build/bench/bin/bench_levels --csv "$results" ;;
        living | matter)
            tools/unpack_openarena.sh && FIRMA_OPENARENA=build/openarena "build/bench/bin/bench_$name" --csv "$results" ;;
        peers) bench/peers/run.sh ;;
        scale) bench/scale/run.sh ;;
        node) bench/node/run.sh --csv "$results" ;;
        carve) build/bench/bin/bench_carve huge --csv "$results" ;;  # 2.6 GB
        carve_cgal | cgal_exact)  # only where there is CGAL
            [ ! -x "build/bench/bin/bench_$name" ] || "build/bench/bin/bench_$name" --csv "$results" ;;
        *) "build/bench/bin/bench_$name" --csv "$results" ;;
    esac
done
/usr/bin/python3 bench/fill_tables.py docs/benchmarks.md "$results"
python3 bench/plot_carving.py "$results" docs/pictures
