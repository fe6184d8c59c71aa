#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests that take seconds each under the address and undefined behaviour sanitizers; tells how many they are.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/unpack_openarena.sh build/openarena
log=build/sanitize/heavy.log
FIRMA_OPENARENA=$PWD/build/openarena ctest --preset sanitize --output-on-failure -V -L heavy >"$log" || { tail -n 80 "$log" >&2; exit 1; }
passed=$(sed -n 's/.*\[  PASSED  \] \([0-9]*\) tests\{0,1\}\..*/\1/p' "$log" | awk '{ sum += $1 } END { print sum }')
echo "claim=sanitized family=total count=$passed"
