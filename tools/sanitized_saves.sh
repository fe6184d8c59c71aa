#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests of firma_tests under the address and undefined behaviour sanitizers, in two processes.
#
#   sanitized_saves.sh COUNT FILTER    how many they are; their names, with colons between
set -euo pipefail
cd "$(dirname "$0")/.."
tools/unpack_openarena.sh build/openarena
export FIRMA_OPENARENA=$PWD/build/openarena GTEST_FILTER=$2 GTEST_TOTAL_SHARDS=2 GTEST_BRIEF=1
log=build/sanitize/saves
# As ctest runs them.
cd build/sanitize/tests
GTEST_SHARD_INDEX=0 ../bin/firma_tests >"../saves_0.log" 2>&1 &
first=$!
failed=0
GTEST_SHARD_INDEX=1 ../bin/firma_tests >"../saves_1.log" 2>&1 || failed=1
wait $first || failed=1
cd ../../..
if [ $failed = 1 ]; then
  tail -n 80 ${log}_0.log ${log}_1.log >&2
  exit 1
fi
tests=$(sed -n 's/.*\[  PASSED  \] \([0-9]*\) test.*/\1/p' ${log}_0.log ${log}_1.log | awk '{ sum += $1 } END { print sum + 0 }')
if [ "$tests" != "$1" ]; then
  echo "$tests tests ran, not $1: the list has names that there are no tests of" >&2
  exit 1
fi
echo "claim=sanitized_saves family=total count=1 tests=$tests"
