#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the modules for browsers and node, and puts them where the JavaScript package has them. Installs what is missing
# (apt, npm); says nothing unless it fails, and then shows why.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh

need_module

mkdir -p build
log=build/module.log
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
{ cmake --preset wasm "${launcher[@]}" && cmake --build --preset wasm; } >"$log" 2>&1 || { tail -n 60 "$log" >&2; exit 1; }
cp build/wasm/bin/firma.wasm build/wasm/bin/firma_games.wasm build/wasm/bin/firma_recordings.wasm build/wasm/bin/firma_readers.wasm bindings/js/src/
