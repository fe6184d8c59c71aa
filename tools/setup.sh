#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Sets up a checkout for working on it: packages, and a commit hook that checks format and layers.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need_build
need clang-19 clang-format-19 libclang-rt-19-dev libgtest-dev python3

hook=$(git rev-parse --git-path hooks)/pre-commit
if [ -e "$hook" ]; then
    echo "firma: $hook is there already; not touched"
else
    printf '#!/bin/sh\ntools/format.sh --check && exec tools/check_layers.py\n' >"$hook"
    chmod +x "$hook"
    echo "firma: commits are now checked for format and layers ($hook)"
fi
