#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compares the instructions of casts and craters with bench/counts/bounds.json; --renew writes them there. Installs what is
# missing (apt).
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need g++ cmake ninja-build libfast-float-dev libboost-dev valgrind python3
exec /usr/bin/python3 bench/counts/run.py "$@"
