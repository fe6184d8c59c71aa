#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packs the JavaScript package, installs it into an empty folder, and runs users' programs over it there: the node that
# is installed (20 or later), node 18, vite, esbuild, a page without a packer. Ends non-zero on any failure. Installs
# what is missing (apt, npm).
#
#   tools/test_npm.sh [LINE]     LINE: what the programs must print, as tools/test_install.sh shows it
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
command -v chromium >/dev/null || need chromium
tools/build_module.sh

log=$PWD/build/test_npm.log
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
quietly() { "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; return 1; }; }
fail() { echo "FAILED: $*" >&2; exit 1; }

line=${1:-}
must_print() {
    local name=$1 said
    shift
    said=$("$@") || fail "$name: $said"
    if [ -z "$line" ]; then
        [[ $said =~ ^met\ bridge\ after\ 0\.20[0-9]*,\ hash\ [0-9a-f]{16}$ ]] || fail "$name prints $said"
        line=$said
    fi
    [ "$said" = "$line" ] || fail "$name prints $said, not $line"
    echo "$name: $said"
}

# ---- what is packed

cmp LICENSE bindings/js/LICENSE || fail "the package's licence is not the project's"
cp -r bindings/js "$work/without"
rm -rf "$work/without/node_modules"
for name in firma.wasm firma_games.wasm firma_recordings.wasm firma_readers.wasm; do
    mv "$work/without/src/$name" "$work/"
    ! (cd "$work/without" && npm pack) >"$log" 2>&1 || fail "npm pack packs without $name"
    grep -q "not packed: src/$name is not there" "$log" || fail "npm pack does not say why it refuses"
    [ -z "$(find "$work/without" -name '*.tgz')" ] || fail "npm pack left a file"
    mv "$work/$name" "$work/without/src/"
done
echo "npm pack refuses without a module"
(cd bindings/js && quietly npm pack --pack-destination "$work")
package=$(find "$work" -maxdepth 1 -name 'firma-*.tgz')
for name in LICENSE README.md index.d.ts readers.d.ts games.d.ts recordings.d.ts package.json src/firma.wasm src/firma_games.wasm src/firma_recordings.wasm src/firma_readers.wasm src/index.js src/readers.js src/games.js src/recordings.js; do
    tar -tf "$package" "package/$name" >/dev/null || fail "$name is not in the package"
done
! tar -xOf "$package" package/package.json | grep -q '"private"' || fail "the package is private"

# ---- a user's folder

user=$work/user
cp -r tests/install/npm "$user"
cp levels/first.obj "$user/"
cd "$user"
quietly npm install --no-package-lock --no-audit --no-fund
quietly npm install --no-save --no-package-lock --no-audit --no-fund "$package"

[[ $(node --version) =~ ^v([0-9]+)\. ]] && [ "${BASH_REMATCH[1]}" -ge 20 ] || fail "node is $(node --version), not 20 or later"
must_print "node $(node --version)" node node.mjs first.obj
[[ $(node_modules/.bin/node --version) = v18.* ]] || fail "node 18 is $(node_modules/.bin/node --version)"
must_print "node 18" node_modules/.bin/node node.mjs first.obj

must_print "a page without a packer" node open_page.mjs . plain.html

mkdir public && mv first.obj public/
quietly node_modules/.bin/vite build --outDir vite
must_print "vite" node open_page.mjs vite index.html

mkdir esbuild && cp index.html public/first.obj node_modules/firma/src/*.wasm esbuild/
quietly node_modules/.bin/esbuild page.js --bundle --minify --format=esm --outfile=esbuild/page.js
! grep -q 'node:' esbuild/page.js || fail "what esbuild makes for browsers asks for node"
must_print "esbuild" node open_page.mjs esbuild index.html

mkdir packed && cp index.html public/first.obj packed/
quietly node_modules/.bin/esbuild page=packed.js --bundle --format=esm --loader:.wasm=file --outdir=packed
must_print "esbuild, the modules packed too" node open_page.mjs packed index.html
