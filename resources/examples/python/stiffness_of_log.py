#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stiffness and material of an object from the log of a touch."""

import tempfile
from pathlib import Path

import numpy as np
import pictures

import teleta

folder = Path(tempfile.mkdtemp())
teleta.simulate("teleta-touch", duration_s=8.0, out=folder)
with teleta.open(folder / "recording.teleta") as recording:
    name = next(name for name, stream in recording.streams.items() if stream.kind == "joints")
    joints = recording.read(name)

# The elbow presses: its angle, and its torque behind the angles of all joints.
elbow = 3
angle_rad = joints.values[:, elbow]
torque_nm = joints.values[:, joints.values.shape[1] // 3 + elbow]
touch = teleta.stiffness(joints.time_s, angle_rad, torque_nm, contact_distance_m=0.1695)

with pictures.figure("stiffness") as figure:
    axes = figure.subplots()
    axes.plot(angle_rad, 1e3 * torque_nm, ".", markersize=2)
    axes.axhspan(20.0, 50.0, alpha=0.2, label="evaluated")
    axes.set_xlabel("angle of the elbow, rad")
    axes.set_ylabel("torque, mNm")
    axes.legend()

low, high = touch.object_stiffness_lower_95, touch.object_stiffness_upper_95
print(f"{touch.object_stiffness_n_per_m:.0f} N/m (95 %: {low:.0f} to {high:.0f}), {touch.samples} samples")
print(f"material: {touch.material}")
assert np.isfinite(torque_nm).all()
