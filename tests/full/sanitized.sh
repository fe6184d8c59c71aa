#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What takes long under the address and undefined behaviour sanitizers: a share of the programs, in order of their numbers.
#
#   sanitized.sh ALL SHARE COUNT    how many there are, which share, counted from 1, and how many programs a share has
set -euo pipefail
cd "$(dirname "$0")/../.."
all=$1 share=$2 count=$3
tools/unpack_openarena.sh build/openarena
mapfile -t programs < <(ctest --preset sanitize -N -L heavy | sed -n 's/^ *Test *#[0-9]*: //p')
if [ ${#programs[@]} != "$all" ]; then
  echo "there are ${#programs[@]} programs, not $all: tools/full.py has the number" >&2
  exit 3  # nothing was checked
fi
mine=("${programs[@]:(share - 1) * count:count}")
log=build/sanitize/heavy_$share.log
FIRMA_OPENARENA=$PWD/build/openarena ctest --preset sanitize --output-on-failure -V -R "^($(IFS='|'; echo "${mine[*]}"))\$" >"$log" || {
  tail -n 80 "$log" >&2
  exit 1
}
tests=$(sed -n 's/.*\[  PASSED  \] \([0-9]*\) test.*/\1/p' "$log" | awk '{ sum += $1 } END { print sum + 0 }')
echo "claim=sanitized family=total count=${#mine[@]} tests=$tests"
