#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the maps of the handbook's page on sweeps: runs three sweeps that come with the program and draws a measure of each. Needs
# librsvg2-bin and python3-pil. Takes a quarter of an hour of processor time.
#   robustness_maps.sh [FOLDER [RESULTS]]      default: resources/handbook/pictures, a temporary folder
# A folder of results that an earlier run has left is gone on with.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
folder=${1:-$root/resources/handbook/pictures}
if [[ -n ${2:-} ]]; then
    work=$2
else
    work=$(mktemp -d)
    trap 'rm -rf -- "$work"' EXIT
fi

configure ci
cmake --build "$root/build/ci" --target teleta
mkdir -p "$folder"
# map SWEEP MEASURE
map() {
    "$root/build/ci/app/cli/teleta" sweep "$1" --out "$work/$1" --allow-failed 0.05
    rsvg-convert --width 1000 --background-color white "$work/$1/figures/$2.svg" --output "$folder/map-$1.png"
}
map touch-stiffness stiffness_error_mean
map servo-friction completed
map camera-place contact_error_mean_m
# They lie in the programs: a palette takes a third of the room.
/usr/bin/python3 - "$folder"/map-*.png <<'END'
import sys

from PIL import Image

for path in sys.argv[1:]:
    Image.open(path).convert("RGB").quantize(256, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(path, optimize=True)
    print(path)
END
