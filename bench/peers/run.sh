#!/bin/sh
# SPDX-License-Identifier: MIT
# Firma beside Debian's Bullet and Embree on the scenes of ../shared/peers: one run, taking turns, answers judged.
#
#   bench/peers/run.sh [--quick] [--scenes "A B C D"] [--rounds N] [--results DIR] [--work DIR]
#
# Wants libbullet-dev and libembree-dev. Scenes are made once and kept in the work folder (build/peers); all peers see
# the same mesh, snapped to Firma's grid.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
repository=$(cd "$here/../.." && pwd)
shared=${FIRMA_SHARED:-$repository/../shared}/peers
scenes="A B C D"
rounds=5
judged=20000
work=$repository/build/peers
results=$repository/bench/results
quick=0
while [ $# -gt 0 ]; do
    case $1 in
        --quick) quick=1 ;;
        --scenes) scenes=$2; shift ;;
        --rounds) rounds=$2; shift ;;
        --results) results=$2; shift ;;
        --work) work=$2; shift ;;
        --help) sed -n '3,8p' "$0" | sed 's/^# \{0,1\}//'; exit 0 ;;
        *) echo "run.sh: what is $1? Try --help" >&2; exit 2 ;;
    esac
    shift
done
export PEER_MAXN="${PEER_MAXN:-20000}"  # sphere casts of a set: Bullet takes its time
if [ $quick = 1 ]; then scenes=A; rounds=1; judged=500; results=$work/quick; PEER_MAXN=2000; fi
if [ ! -f "$shared/peer.h" ]; then echo "run.sh: $shared is not there; nothing to run beside"; exit 0; fi

mkdir -p "$work/scenes" "$work/dumps" "$results"
native="-O3 -march=native -w -I$shared"
echo "building ..."
cmake --preset bench -S "$repository" >"$work/cmake.log" && cmake --build "$repository/build/bench" --target firma >>"$work/cmake.log"

# The generator, with the snap before each scene's queries are made.
sed 's|bounds(s); save_mesh|snap_scene(s.m); bounds(s); save_mesh|; 1i #include "snap_scene.h"' "$shared/gen.cpp" >"$work/gen_snapped.cpp"
grep -q 'snap_scene(s.m)' "$work/gen_snapped.cpp" || { echo "run.sh: gen.cpp has changed; mend the line above" >&2; exit 1; }
for program in gen_snapped judge; do
    source=$shared/$program.cpp
    [ -f "$source" ] || source=$work/$program.cpp
    [ "$work/$program" -nt "$source" ] || g++ -std=c++17 $native -ffp-contract=off -I"$here" -o "$work/$program" "$source"
done

adapter() {  # program, standard, sources and libraries
    program=$1; standard=$2; shift 2
    g++ -std=$standard $native -o "$work/$program" "$shared/driver.cpp" "$@" -lpthread
}
peers="firma"
adapter driver_firma c++20 -ffp-contract=off -I"$repository/include" "$here/peer_firma.cpp" "$repository/build/bench/libfirma.a"
if [ -d /usr/include/bullet ]; then
    adapter driver_bullet c++17 -I/usr/include/bullet "$shared/peer_bullet.cpp" -lBulletCollision -lLinearMath && peers="$peers bullet"
fi
if [ -d /usr/include/embree3 ]; then
    adapter driver_embree c++17 "$shared/peer_embree.cpp" -lembree3 && peers="$peers e3 e3_robust"
fi
peers="$peers firma_area"

name_of() {
    case $1 in A) echo A_rooms50k ;; B) echo B_rooms500k ;; C) echo C_terrain2M ;; D) echo D_soup100k ;; *) echo "$1" ;; esac
}
driver_of() {
    case $1 in firma*) echo driver_firma ;; bullet*) echo driver_bullet ;; *) echo driver_embree ;; esac
}

raw=$work/raw.csv
echo "round,peer,scene,metric,value" >"$raw"
for scene in $scenes; do
    name=$(name_of "$scene")
    if [ ! -f "$work/scenes/$name.sph_tiny" ]; then "$work/gen_snapped" "$work/scenes" "$name"; fi
    round=1
    while [ $round -le "$rounds" ]; do
        for peer in $peers; do
            echo "round $round of $rounds, $name, $peer"
            "$work/$(driver_of "$peer")" "$peer" "$work/scenes" "$name" 1 1 "$work/dumps" 2>>"$work/drivers.log" | sed "s/^/$round,/" >>"$raw"
        done
        round=$((round + 1))
    done
    "$work/judge" "$work/scenes" "$work/dumps" "$name" $judged $peers 2>>"$work/judge.log" >"$work/judged_$name.txt"
done
python3 "$here/tables.py" "$raw" "$work" "$results" $peers
