# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the other scripts: sets root, jobs and a compiler cache that several build folders share.
# shellcheck shell=bash
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)
export CMAKE_BUILD_PARALLEL_LEVEL=$jobs
export CCACHE_BASEDIR=$root
export CCACHE_NOHASHDIR=1
# ccache keeps precompiled headers only when it ignores these differences.
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime

# configure PRESET [CMAKE ARGUMENTS...]: prints its output only when it fails.
configure() {
    local log
    if ! log=$(cd "$root" && cmake --preset "$@" 2>&1); then
        printf '%s\n' "$log" >&2
        return 1
    fi
}

# Qt needs a private folder for its sockets, which a bare machine lacks.
ensure_runtime_folder() {
    if [[ ! -d ${XDG_RUNTIME_DIR:-} ]]; then
        export XDG_RUNTIME_DIR="$root/build/runtime"
        mkdir -p "$XDG_RUNTIME_DIR"
        chmod 700 "$XDG_RUNTIME_DIR"
    fi
}
