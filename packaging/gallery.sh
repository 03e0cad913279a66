#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the handbook's page on Python: runs each example of the module. Needs python3-matplotlib.
#   gallery.sh [FOLDER]      default: resources/handbook/pictures
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
folder=${1:-$root/resources/handbook/pictures}

configure ci
cmake --build "$root/build/ci" --target python_package
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
for example in "$root"/resources/examples/python/*.py; do
    [[ $example == */pictures.py ]] || TMPDIR=$work PYTHONPATH=$root/build/ci/app/python /usr/bin/python3 -B "$example" --pictures "$work/pictures"
done

mkdir -p "$folder"
# They lie in the programs: a palette takes a third of the room.
/usr/bin/python3 - "$work/pictures" "$folder" <<'END'
import sys
from pathlib import Path

from PIL import Image

for path in sorted(Path(sys.argv[1]).glob("*.png")):
    reduced = Image.open(path).convert("RGB").quantize(256, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    reduced.save(Path(sys.argv[2]) / path.name, optimize=True)
    print(Path(sys.argv[2]) / path.name)
END
