#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One press with an even load gives the gains of all taxels; with them, the array reads evenly."""

import tempfile
from pathlib import Path

import numpy as np
import pictures

import teleta

folder = Path(tempfile.mkdtemp())
teleta.simulate("tactile-even-load", out=folder)
frames = teleta.read_frames(folder / "frames.csv")
gains = teleta.gains(frames.values)
gains.save(folder / "gains.csv")

# How unevenly the taxels read in the frame with most load, before and after.
most = frames.values[np.argmax(frames.values.sum(axis=(1, 2)))].astype(float)
before = most.std() / most.mean()
after = np.nanstd(most * gains.gain) / np.nanmean(most * gains.gain)

with pictures.figure("gains", 720, 300) as figure:
    left, right = figure.subplots(1, 2)
    left.imshow(most, cmap="viridis")
    left.set_title("as read")
    right.imshow(most * gains.gain, cmap="viridis", vmin=most.min(), vmax=most.max())
    right.set_title("with the gains")

print(f"{(gains.state == 'good').sum()} of {gains.gain.size} taxels are good")
print(f"unevenness {100.0 * before:.0f} % before, {100.0 * after:.0f} % after")
