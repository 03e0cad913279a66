#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Force and centre of pressure of recorded frames, over time.

python3 features_of_csv.py [FRAMES.csv]      without a file: a simulated ball that presses on an array
"""

import sys
import tempfile
from pathlib import Path

import numpy as np
import pictures

import teleta

folder = Path(tempfile.mkdtemp())
if len(sys.argv) > 1 and not sys.argv[1].startswith("--"):
    path = Path(sys.argv[1])
else:
    teleta.simulate("tactile-indenter", duration_s=8.0, out=folder)
    path = folder / "frames.csv"

frames = teleta.read_frames(path)
table = teleta.features(frames.values, time_s=frames.time_s, threshold_n=0.3)

loaded = table["active"] > 0
print(f"{len(loaded)} frames of {frames.values.shape[1]} x {frames.values.shape[2]} taxels, "
      f"{loaded.sum()} with contact")

with pictures.figure("features") as figure:
    upper, lower = figure.subplots(2, 1, sharex=True)
    upper.plot(table["time_s"], table["force_n"])
    upper.set_ylabel("force, N")
    lower.plot(table["time_s"], 1e3 * table["cop_x_m"], label="x")
    lower.plot(table["time_s"], 1e3 * table["cop_y_m"], label="y")
    lower.set_ylabel("centre of pressure, mm")
    lower.set_xlabel("time, s")
    lower.legend()

print(f"largest force {np.max(table['force_n']):.2f} N")
