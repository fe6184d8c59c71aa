#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Formats every source with clang-format 19; with --check only tells which are not formatted, and fails.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
command -v clang-format-19 >/dev/null || need clang-format-19

mapfile -t files < <(git ls-files -co --exclude-standard '*.h' '*.cpp' '*.c')
if [ "${1:-}" = --check ]; then
    clang-format-19 --dry-run --Werror "${files[@]}" || { echo "firma: run tools/format.sh" >&2; exit 1; }
    echo "${#files[@]} files, all formatted"
else
    clang-format-19 -i "${files[@]}"
fi
