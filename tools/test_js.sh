#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the modules for browsers and node, and runs the JavaScript package's tests in node and Chromium. Ends non-zero
# on any failure, and then shows what failed; else prints a line or two. Installs what is missing (apt, npm).
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh

need_module
command -v chromium >/dev/null || need chromium

mkdir -p build
log=build/test_js.log

# quietly COMMAND...: its output only when it fails.
quietly() { "$@" >"$log" 2>&1 || { tail -n 100 "$log" >&2; return 1; }; }

tools/build_module.sh

cd bindings/js
log=../../$log
# Again only when the lock has changed: npm marks what it installed.
cmp -s package-lock.json node_modules/.firma_lock || {
    quietly npm ci --no-audit --no-fund
    cp package-lock.json node_modules/.firma_lock
}
# A test that was skipped is one that did not pass.
passed() { node --test --test-reporter=tap test/*.test.js >"$log" 2>&1 && grep -q '^# skipped 0$' "$log"; }
passed || {
    awk '/^not ok/ { show = 1 } show || /^# (pass|fail|skipped|todo) / { print } /^  \.\.\.$/ { show = 0 }' "$log" >&2
    exit 1
}
grep -E '^# (firma(_readers)?\.wasm: |100 cuts, )' "$log" | sed 's/^# //'
browser=$(chromium --version --no-sandbox 2>/dev/null | head -n 1)
echo "$(sed -n 's/^# pass //p' "$log") tests in node $(node --version) and $browser passed"
