#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages of the programs and of the Python module, with a list of what the programs are made of
# (CycloneDX), and prints their paths.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

"$root/packaging/install_dependencies.sh" --package
configure package
cmake --build "$root/build/package"
"$root/packaging/check_hardening.sh" "$root"/build/package/app/cli/teleta "$root"/build/package/app/console/teleta-console \
    "$root"/build/package/app/site/teleta-site
cd "$root/build/package"
rm -f ./*.deb
log=$(cpack -G DEB 2>&1) || {
    printf '%s\n' "$log" >&2
    exit 1
}
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' CMakeCache.txt)
"$root/packaging/make_sbom.py" --version "$version" --out "teleta-console_$version.cdx.json" \
    app/cli/teleta app/console/teleta-console app/site/teleta-site parts/*.so
printf 'What it is made of: %s\n' "$root/build/package/teleta-console_$version.cdx.json"
printf 'A package is %s\n' "$root"/build/package/*.deb
