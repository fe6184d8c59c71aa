#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the modules for browsers, then the playground around it, into build/playground. Installs what is missing (apt,
# npm); says nothing unless it fails, and then shows why.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh

need_module

mkdir -p build
log=$PWD/build/playground.log

# quietly COMMAND...: its output only when it fails.
quietly() { "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; return 1; }; }

tools/build_module.sh

cd playground
# Again only when the lock has changed: a copy of it marks what was installed.
cmp -s package-lock.json node_modules/.firma_lock || {
    quietly npm ci --ignore-scripts
    cp package-lock.json node_modules/.firma_lock
}
quietly node build.mjs
