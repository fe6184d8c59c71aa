#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the library into an empty folder, moves it, and builds users' projects over it there: CMake, pkg-config, C++,
# C, Python; static and shared. Ends non-zero on any failure; else prints a line for each thing shown. Installs what is
# missing (apt).
#
#   tools/test_install.sh [brief]     CXX and CC: other compilers than g++ and gcc, for library and users
#
# brief: not optimised, and the static libraries alone, found by CMake from C++ and C.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
need_build
need pkgconf binutils python3 clang-19

root=$PWD
export CXX=${CXX:-g++} CC=${CC:-gcc}
build=build/install_$(basename "$CXX")
log=$root/build/test_install.log
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p build
unite=()

quietly() { "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; return 1; }; }
fail() { echo "FAILED: $*" >&2; exit 1; }

# must_print NAME COMMAND...: the line that all programs print; the first one must say what docs/hello.md says.
line=
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

level=$work/first.obj
cp levels/first.obj "$level"

user() { # user FOLDER OPTION...: configures and builds a project of tests/install, which sets no build type and no standard
    local folder=$1
    shift
    quietly cmake -S "$work/tests/installed" -B "$work/$folder" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" "$@"
    quietly cmake --build "$work/$folder"
}
static_or_shared() { # static_or_shared FORM: what users' programs over it print
    user "$1" -DFORM="$1"
    must_print "find_package, C++, $1" "$work/$1/crater_cpp" "$level" "$work/saved.firma"
    must_print "find_package, C, $1" "$work/$1/crater_c" "$level" "$work/saved.firma"
    [ "$("$work/$1/gltf")" = "glTF: 1 face, met after 0.5" ] || fail "glTF, $1: $("$work/$1/gltf")"
}

case "${1:-}" in
    "") ;;
    brief)
        prefix=$work/prefix
        cp -r tests/install "$work/tests"
        quietly cmake -S . -B "${build}_brief" -G Ninja -DFIRMA_UNITE=ON -DFIRMA_BUILD_GLTF=ON -DFIRMA_BUILD_CLI=OFF -DCMAKE_BUILD_TYPE=Debug
        quietly cmake --build "${build}_brief"
        quietly cmake --install "${build}_brief" --prefix "$prefix"
        static_or_shared static
        exit ;;
    *) fail "what is $1?" ;;
esac

# ---- from a build without a build type to an installed tree, elsewhere than it was configured for

[ -e "$build/CMakeCache.txt" ] || unite=(-DFIRMA_UNITE=ON)
quietly cmake -S . -B "$build" -G Ninja "${unite[@]}" -DFIRMA_SHARED=ON -DFIRMA_BUILD_GLTF=ON -DFIRMA_BUILD_CLI=OFF -DCMAKE_INSTALL_PREFIX=/usr/local
grep -q '^CMAKE_BUILD_TYPE:STRING=Release$' "$build/CMakeCache.txt" || fail "without a build type it is not Release"
quietly cmake --build "$build"
quietly cmake --install "$build" --prefix "$work/first"
mv "$work/first" "$work/prefix"
prefix=$work/prefix
cp -r tests/install "$work/tests"

diff <(cd include/firma && ls) <(cd "$prefix/include/firma" && find . -type f -printf '%P\n' | sort) || fail "other headers installed than include/firma"
[ -f "$prefix/share/doc/firma/LICENSE" ] || fail "no licence installed"
libraries=$(dirname "$(find "$prefix" -name libfirma.a)")
! grep -riE 'boost|fast_float|hwy|highway|tinygltf|nlohmann|/work/|'"$root" "$libraries/cmake" "$libraries/pkgconfig" || fail "the installed files name what only building needs"

# ---- shared libraries export public functions, nothing else

tools/public_symbols.py
tools/public_symbols.py --compare "$libraries/libfirma.so"
diff <(sed -nE 's/^FIRMA_API .*\b(firma_[a-z_]+)\(.*/\1/p' include/firma/firma_c.h | sort) \
     <(nm -D --defined-only "$libraries/libfirma_c.so" | awk '{ print $NF }' | sort) || fail "libfirma_c.so exports something else than firma_c.h declares"
version=$(sed -nE 's/^project\(firma VERSION ([0-9]+\.[0-9]+).*/\1/p' CMakeLists.txt)
[[ $(readelf -d "$libraries/libfirma_c.so") =~ SONAME.*\[libfirma_c\.so\.([0-9.]+)\] && ${BASH_REMATCH[1]} = "$version" ]] ||
    fail "libfirma_c.so has no versioned name"
! readelf -d "$libraries/libfirma_c.so" | grep -q 'NEEDED.*libfirma' || fail "libfirma_c.so needs another library of ours"

# ---- find_package

needs_library() { readelf -d "$1" | grep -q "NEEDED.*$2"; }
static_or_shared static
static_or_shared shared
needs_library "$work/shared/crater_cpp" libfirma.so || fail "COMPONENTS shared is not shared"
! needs_library "$work/static/crater_cpp" libfirma || fail "COMPONENTS static is not static"
user chosen -DBUILD_SHARED_LIBS=ON
needs_library "$work/chosen/crater_c" libfirma_c.so || fail "BUILD_SHARED_LIBS does not choose the shared libraries"
! cmake -S "$work/tests/installed" -B "$work/other" -DCMAKE_PREFIX_PATH="$prefix" -DFORM=nonsense >"$log" 2>&1 || fail "a component that is not there is found"

# ---- the game of docs/game_loop.md: the page shows the project, and says what it prints

[[ $(<docs/game_loop.md) == *"$(tail -n +3 tests/install/game_loop/CMakeLists.txt)"* ]] || fail "docs/game_loop.md shows another project"
cp docs/game_loop.cpp "$work/tests/game_loop/"
quietly cmake -S "$work/tests/game_loop" -B "$work/game" -G Ninja -DCMAKE_PREFIX_PATH="$prefix"
quietly cmake --build "$work/game"
quietly /usr/bin/python3 tests/docs/test_page.py "$root" game_loop game_loop.cpp "$work/game/game"
echo "find_package, docs/game_loop.cpp: prints what docs/game_loop.md says"

# ---- pkg-config

export PKG_CONFIG_PATH=$libraries/pkgconfig
(cd "$work/tests" && quietly $CC crater.c -o "$work/pc_c" $(pkg-config --cflags --libs firma_c) -Wl,-rpath,"$libraries")
must_print "pkg-config, C, shared" "$work/pc_c" "$level" "$work/saved.firma"
(cd "$work/tests" && quietly $CC -static crater.c -o "$work/pc_c_static" $(pkg-config --static --cflags --libs firma_c))
must_print "pkg-config, C, static" "$work/pc_c_static" "$level" "$work/saved.firma"
(cd "$work/tests" && quietly $CXX -std=c++20 gltf.cpp -o "$work/pc_gltf" $(pkg-config --cflags --libs firma_gltf) -Wl,-rpath,"$libraries")
[ "$("$work/pc_gltf")" = "glTF: 1 face, met after 0.5" ] || fail "glTF by pkg-config"

# ---- static libraries alone: pkg-config names what they need

quietly cmake "$build" -DFIRMA_SHARED=OFF
quietly cmake --build "$build"
quietly cmake --install "$build" --prefix "$work/static_prefix"
quietly cmake "$build" -DFIRMA_BUILD_GLTF=OFF
quietly cmake --build "$build"
quietly cmake --install "$build" --prefix "$work/plain"
quietly cmake "$build" -DFIRMA_SHARED=ON -DFIRMA_BUILD_GLTF=ON
[ -z "$(find "$work/static_prefix" -name '*.so*')" ] || fail "shared libraries without FIRMA_SHARED"
alone=$(dirname "$(find "$work/static_prefix" -name firma.pc)")
(cd "$work/tests" && quietly $CC crater.c -o "$work/alone_c" $(PKG_CONFIG_PATH=$alone pkg-config --cflags --libs firma_c))
must_print "pkg-config, C, where there are static libraries alone" "$work/alone_c" "$level" "$work/saved.firma"
(cd "$work/tests" && quietly $CXX -std=c++20 gltf.cpp -o "$work/alone_gltf" $(PKG_CONFIG_PATH=$alone pkg-config --cflags --libs firma_gltf))
[ "$("$work/alone_gltf")" = "glTF: 1 face, met after 0.5" ] || fail "glTF by pkg-config, static"
quietly cmake -S "$work/tests/installed" -B "$work/alone" -G Ninja -DCMAKE_PREFIX_PATH="$work/static_prefix" -DBUILD_SHARED_LIBS=ON
! cmake -S "$work/tests/installed" -B "$work/none" -DCMAKE_PREFIX_PATH="$work/static_prefix" -DFORM=shared >"$log" 2>&1 || fail "shared libraries are found that are not there"

# ---- without glTF: no header whose functions no library has

diff <(cd include/firma && ls | grep -v '^read_gltf\.h$') <(cd "$work/plain/include/firma" && find . -type f -printf '%P\n' | sort) || fail "other headers installed without glTF"
[ -z "$(find "$work/plain" -name '*gltf*')" ] || fail "something of glTF is installed without it"
plain=$(dirname "$(find "$work/plain" -name firma.pc)")
(cd "$work/tests" && quietly $CXX -std=c++20 crater.cpp -o "$work/plain_cpp" $(PKG_CONFIG_PATH=$plain pkg-config --cflags --libs firma))
must_print "pkg-config, C++, without glTF" "$work/plain_cpp" "$level" "$work/saved.firma"

# ---- Python

must_print "Python, ctypes" /usr/bin/python3 "$work/tests/crater.py" "$prefix/include/firma/firma_c.h" "$libraries/libfirma_c.so" "$level"

# ---- an older compiler is told so: one that says that it is g++ 10

printf '#!/bin/sh\nexec g++ -U__GNUC__ -D__GNUC__=10 "$@"\n' >"$work/g++-10"
chmod +x "$work/g++-10"
for source in "$root" "$work/tests/installed"; do
    ! cmake -S "$source" -B "$work/old_$(basename "$source")" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$work/g++-10" >"$log" 2>&1 ||
        fail "$source takes g++ 10"
    tr '\n' ' ' <"$log" | tr -s ' ' | grep -q 'Firma needs g++ 11 or clang 13, or newer; this is GNU 10\.' || { cat "$log" >&2; fail "$source does not say what it needs"; }
done
echo "g++ 10 is refused by name, by the sources and by the installed library"
