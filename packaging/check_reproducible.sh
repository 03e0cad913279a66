#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the packages of the present commit twice, from clones in two folders and without a compiler cache, and compares their
# bytes. Takes the time of two builds from clean. What differs is left in FOLDER.
#   check_reproducible.sh [FOLDER]
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
folder=${1:-$root/build/reproducible}
export CCACHE_DISABLE=1

rm -rf --one-file-system -- "$folder"
for place in first another/second; do
    printf '== %s\n' "$folder/$place"
    git clone -q "$root" "$folder/$place"
    "$folder/$place/packaging/make_deb.sh"
done
differs=0
for file in "$folder"/first/build/package/*.deb "$folder"/first/build/package/*.cdx.json; do
    if cmp "$file" "$folder/another/second/build/package/${file##*/}"; then
        printf 'the same bytes: %s\n' "${file##*/}"
    else
        differs=1
    fi
done
((differs == 0)) && rm -rf --one-file-system -- "$folder"
exit "$differs"
