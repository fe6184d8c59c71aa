#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What takes long under the address and undefined behaviour sanitizers: listed tests, of which it tells how many they are;
# programs of their own, and the command line's.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/unpack_openarena.sh build/openarena
log=build/sanitize/heavy.log
FIRMA_OPENARENA=$PWD/build/openarena ctest --preset sanitize --output-on-failure -V -L heavy >"$log" || { tail -n 80 "$log" >&2; exit 1; }
passed=$(awk '/Start +[0-9]+: firma_tests_heavy/ { sub(/:/, "", $2); listed[$2 ":"] }
              /\[  PASSED  \]/ && $1 in listed { sum += $5 } END { print sum }' "$log")
echo "claim=sanitized family=total count=$passed"
