#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Unpacks the maps of OpenArena, as Debian packs them, into a folder for tests and benchmarks (FIRMA_OPENARENA).
#
#   tools/unpack_openarena.sh [folder]      default: build/openarena
#
# Installs nothing. Says nothing when all maps are there already.
set -euo pipefail

package=openarena-081-maps
root=$(cd "$(dirname "$0")/.." && pwd)
folder=${1:-$root/build/openarena}

fail() {
    echo "unpack_openarena: $*" >&2
    exit 1
}

# One archive a line; nothing when the package is missing.
find_archives() {
    command -v dpkg >/dev/null || fail "no dpkg here: this script knows Debian's package $package only"
    dpkg -L "$package" 2>/dev/null | grep '\.pk3$' || true
}

# unpack ARCHIVE FOLDER: its maps/*.bsp, without their paths. A map that another archive brought is replaced.
unpack() {
    if command -v unzip >/dev/null; then
        unzip -q -o -j "$1" 'maps/*.bsp' -d "$2"
    elif [ -x /usr/bin/python3 ]; then
        /usr/bin/python3 - "$1" "$2" <<'PYTHON'
import pathlib, sys, zipfile
archive, folder = zipfile.ZipFile(sys.argv[1]), pathlib.Path(sys.argv[2])
for name in archive.namelist():
    if name.startswith("maps/") and name.endswith(".bsp"):
        (folder / name.rsplit("/", 1)[1]).write_bytes(archive.read(name))
PYTHON
    else
        fail "needs unzip or /usr/bin/python3"
    fi
}

archives=$(find_archives)
[ -n "$archives" ] || fail "package $package is not installed (apt-get install $package)"

# The marker names what was unpacked: another version of the package is unpacked anew.
marker=$folder/.unpacked
version=$(dpkg-query -W -f '${Version}' "$package")
if [ -f "$marker" ] && [ "$(cat "$marker")" = "$version" ]; then
    exit 0
fi

mkdir -p "$folder"
while IFS= read -r archive; do
    unpack "$archive" "$folder" || fail "cannot unpack $archive"
done <<<"$archives"
count=$(find "$folder" -maxdepth 1 -name '*.bsp' | wc -l)
[ "$count" -gt 0 ] || fail "no maps/*.bsp in $archives"
echo "$version" >"$marker"
echo "$count maps in $folder"
