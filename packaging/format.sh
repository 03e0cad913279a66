#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Formats all C++ files in place; with --check it changes nothing and fails when a file is not formatted.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
cd "$root"
case "${1:-}" in
    "") mode=(-i) ;;
    --check) mode=(--dry-run --Werror) ;;
    *)
        printf "format: unknown argument '%s' (expected nothing, or --check)\n" "$1" >&2
        exit 2
        ;;
esac
find app widgets backend devices tests -name '*.cpp' -print0 -o -name '*.h' -print0 |
    xargs -0 -r -n 16 -P "$jobs" clang-format "${mode[@]}"
