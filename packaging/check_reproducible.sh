#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the packages of the present commit twice, from clones in two folders and without a compiler cache, and compares their
# bytes. Takes the time of two builds from clean. What differs is left in FOLDER.
#   check_reproducible.sh [FOLDER]
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
folder=${1:-$root/build/reproducible}
export CCACHE_DISABLE=1

places=("$folder/first" "$folder/another/second")
rm -rf --one-file-system -- "$folder"
for place in "${places[@]}"; do git clone -q "$root" "$place"; done
for place in "${places[@]}"; do
    printf '== %s\n' "$place"
    "$place/packaging/make_deb.sh"
done
differs=0
for file in "${places[0]}"/build/package/*.deb "${places[0]}"/build/package/*.cdx.json; do
    if cmp "$file" "${places[1]}/build/package/${file##*/}"; then
        printf 'the same bytes: %s\n' "${file##*/}"
    else
        differs=1
    fi
done
((differs == 0)) && rm -rf --one-file-system -- "$folder"
exit "$differs"
