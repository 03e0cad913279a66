#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages of both programs and of the Python module, and prints their paths.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

"$root/packaging/install_dependencies.sh" --package
configure package
cmake --build "$root/build/package"
"$root/packaging/check_hardening.sh" "$root"/build/package/app/cli/teleta "$root"/build/package/app/console/teleta-console
cd "$root/build/package"
rm -f ./*.deb
log=$(cpack -G DEB 2>&1) || {
    printf '%s\n' "$log" >&2
    exit 1
}
printf 'A package is %s\n' "$root"/build/package/*.deb
