#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A recording as numpy arrays, and as a table of pandas where that is installed.

python3 recording_to_arrays.py [RECORDING.teleta]
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

import teleta

if len(sys.argv) > 1 and not sys.argv[1].startswith("--"):
    path = Path(sys.argv[1])
else:
    folder = Path(tempfile.mkdtemp())
    teleta.simulate("teleta-touch", duration_s=8.0, out=folder)
    path = folder / "recording.teleta"

with teleta.open(path) as recording:
    print(f"started {np.datetime_as_string(recording.start_utc, unit='s')} UTC")
    for name, stream in recording.streams.items():
        data = recording.read(name)
        print(f"{name}: {stream.kind}, {data.values.shape}, {data.values.dtype}")
    joints = next(name for name, stream in recording.streams.items() if stream.kind == "joints")
    # A long stream, piece by piece: here the largest torque of the elbow.
    largest_nm = max(np.abs(block.values[:, 7]).max() for block in recording.blocks(joints))
    data = recording.read(joints, start_s=1.0, stop_s=2.0)

try:
    import pandas
except ImportError:
    print("table skipped: it needs python3-pandas")
else:
    table = pandas.DataFrame(data.values, columns=list(data.columns), index=data.time_s)
    print(table.describe().loc[["mean", "std"]])

print(f"{len(data.time_s)} joint samples between 1 s and 2 s, largest torque {1e3 * largest_nm:.0f} mNm")
