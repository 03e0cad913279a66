#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A vibration pattern from a formula: a swell that runs round the arm and becomes quicker. Saved as WAV."""

import tempfile
from pathlib import Path

import numpy as np
import pictures

import teleta

folder = Path(tempfile.mkdtemp())
times_s = np.linspace(0.0, 4.0, 401)
turns = 0.5 * times_s + 0.125 * times_s**2
angle_rad = 2.0 * np.pi * (turns[:, None] - np.arange(6) / 6.0)
intensities = np.maximum(0.0, np.cos(angle_rad)) ** 2

pattern = teleta.Pattern.from_samples(times_s, intensities, id="chirp", name="Quicker and quicker")
pattern.save(folder / "chirp.json")
pattern.save(folder / "chirp.wav", rate_hz=8000.0)
broken = pattern.check()
predicted = pattern.predicted(times_s)

with pictures.figure("pattern") as figure:
    axes = figure.subplots()
    for tactor in range(6):
        axes.plot(times_s, intensities[:, tactor] + 1.1 * tactor, color="tab:blue")
        axes.plot(times_s, predicted[:, tactor] + 1.1 * tactor, color="tab:orange")
    axes.set_yticks(1.1 * np.arange(6), [f"tactor {i}" for i in range(1, 7)])
    axes.set_xlabel("time, s (blue: commanded, orange: what the motors do)")

print(f"{len(broken)} places break a law of what can be felt")
print(f"{(folder / 'chirp.wav').stat().st_size} bytes of WAV with six channels")
