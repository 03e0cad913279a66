#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the Debian packages of the programs and of the Python module, with a list of what the programs are made of
# (CycloneDX), and prints their paths and checksums. The same commit gives the same bytes (check_reproducible.sh).
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"

"$root/packaging/install_dependencies.sh" --package
# Resources, manual pages and packages hold times: the commit's.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
configure package
cmake --build "$root/build/package"
# The program teleta itself is too small to need all of it: its commands are in the two modules.
"$root/packaging/check_hardening.sh" "$root"/build/package/parts/teleta_{commands,everyday}.so \
    "$root"/build/package/app/console/teleta-console "$root"/build/package/app/site/teleta-site
cd "$root/build/package"
rm -f ./*.deb
log=$(cpack -G DEB 2>&1) || {
    printf '%s\n' "$log" >&2
    exit 1
}
# CPack writes the times of now.
for package in ./*.deb; do
    unpacked=$(mktemp -d)
    dpkg-deb --raw-extract "$package" "$unpacked"
    dpkg-deb --root-owner-group -Zxz --build "$unpacked" "$package" >/dev/null
    rm -rf -- "$unpacked"
done
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' CMakeCache.txt)
"$root/packaging/make_sbom.py" --version "$version" --out "teleta-console_$version.cdx.json" \
    app/cli/teleta app/console/teleta-console app/site/teleta-site parts/*.so
printf 'What it is made of: %s\n' "$root/build/package/teleta-console_$version.cdx.json"
printf 'A package is %s\n' "$root"/build/package/*.deb
sha256sum ./*.deb ./*.cdx.json
