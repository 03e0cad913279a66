#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the peers of package-lock.json into build/mcap-peers, unless they are there.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
peers=$(cd -- "$here/../../.." && pwd)/build/mcap-peers

if cmp -s "$here/package-lock.json" "$peers/package-lock.json" && [[ -e $peers/node_modules/.package-lock.json ]]; then
    exit 0
fi
mkdir -p "$peers"
cp "$here/package.json" "$here/package-lock.json" "$peers"
cd "$peers"
if ! npm ci --ignore-scripts --no-audit --no-fund; then
    rm -f package-lock.json
    printf 'install: npm could not install the peers of MCAP (see above)\n' >&2
    exit 1
fi
