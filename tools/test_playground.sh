#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the playground and tests it: its parts in node, the whole in Debian's Chromium over `firma serve`. Ends non-zero
# on any failure, and then shows what failed; else prints a line or two. Installs what is missing (apt, npm).
# Pictures of what the tests saw: build/playground_shots.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh

need_build
need chromium
tools/build_playground.sh

log=$PWD/build/test_playground.log
quietly() { "$@" >"$log" 2>&1 || { grep -v '^ok ' "$log" | tail -n 100 >&2; return 1; }; }

# FIRMA: a command line that is built already.
if [ -z "${FIRMA:-}" ]; then
    launcher=()
    command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    quietly cmake --preset release "${launcher[@]}"
    quietly cmake --build --preset release --target firma_cli
fi

cd playground
quietly node --test --test-concurrency=1 --test-reporter=tap test/*.test.mjs
# A test that was skipped is one that did not pass.
grep -q '^# skipped 0$' "$log" && grep -q '^# todo 0$' "$log" || { tail -n 20 "$log" >&2; exit 1; }
sed -n 's/^# .*# \(a walking step.*\)$/\1/p' "$log"
echo "$(sed -n 's/^# pass //p' "$log") tests in node $(node --version) and $(chromium --version --no-sandbox 2>/dev/null | head -n 1) passed"
