#!/bin/sh
# SPDX-License-Identifier: MIT
# Every map of OpenArena: `firma info` and ten thousand casts, none of them with an error; the table goes to bench/results.
#
#   bench/openarena.sh        wants Debian's openarena-081-maps, and the presets release and bench built
set -eu

repository=$(cd "$(dirname "$0")/.." && pwd)
folder=$repository/build/openarena
"$repository/tools/unpack_openarena.sh" "$folder"

faulty=0
for map in "$folder"/*.bsp; do
    "$repository/build/release/bin/firma" info "$map" >/dev/null || { echo "firma info $map: code $?"; faulty=$((faulty + 1)); }
done
echo "firma info: $faulty of $(ls "$folder"/*.bsp | wc -l) maps with an error"
"$repository/build/bench/bin/bench_openarena" "$folder" --csv "$repository/bench/results"
[ $faulty = 0 ]
