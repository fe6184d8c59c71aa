# SPDX-License-Identifier: MIT
# Installs Debian packages that are missing. To be sourced: need PACKAGE...

# Runs a command as root: directly, or through sudo.
as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null 2>&1; then
        sudo "$@"
    else
        echo "firma: this needs root or sudo: $*" >&2
        return 1
    fi
}

# Installs those of the packages that are not there yet; quiet when none is missing.
need() {
    local missing=() package
    for package in "$@"; do
        dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    echo "firma: installing ${missing[*]}"
    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -qq)
    as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null 2>&1 && return 0
    as_root "${apt[@]}" update && as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null && return 0
    echo "firma: could not install ${missing[*]}; try: apt-get update && apt-get install ${missing[*]}" >&2
    return 1
}

# What it takes to build the library and the command line.
need_build() {
    need g++ cmake ninja-build libcli11-dev libfmt-dev libtbb-dev libfast-float-dev libboost-dev libhwy-dev libtinygltf-dev nlohmann-json3-dev \
        libcpp-httplib-dev libpng-dev
}

# What it takes to build the module for browsers and node, and to run what is around it. binaryen: clang has its wasm-opt
# shrink what it links, where it is there. Node and npm go by command: they may come from elsewhere than Debian, whose
# npm then cannot be installed beside them.
need_module() {
    need cmake ninja-build clang-19 lld-19 llvm-19 wasi-libc libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32 binaryen \
        libfast-float-dev libboost-dev libhwy-dev
    command -v node >/dev/null || need nodejs
    command -v npm >/dev/null || need npm
}
