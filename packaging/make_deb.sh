#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian package of both programs and prints its path.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

"$root/packaging/install_dependencies.sh" --package
configure package
cmake --build "$root/build/package"
cd "$root/build/package"
rm -f ./*.deb
log=$(cpack -G DEB 2>&1) || {
    printf '%s\n' "$log" >&2
    exit 1
}
printf 'The package is %s\n' "$root"/build/package/*.deb
