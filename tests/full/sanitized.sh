#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests that take seconds each under the address and undefined behaviour sanitizers; tells how many they are.
set -euo pipefail
cd "$(dirname "$0")/../.."
tools/unpack_openarena.sh build/openarena
FIRMA_OPENARENA=$PWD/build/openarena ctest --preset sanitize --output-on-failure -L heavy >&2
echo "claim=sanitized family=total count=$(grep -vc '^#' tests/heavy_sanitized.txt)"
