#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams of a recording on one clock, as learning from demonstrations needs them.

LeRobot keeps frames at one fps, with observation.* and action columns. Here they become a dict of arrays of
equal length, which its dataset takes frame by frame. At each instant a stream gives its newest value at or
before it: nothing comes from the future.
"""

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pictures

import teleta

FPS = 30.0
Array = np.ndarray[Any, np.dtype[Any]]


def newest(data: teleta.Data, times_s: Array) -> Array:
    """Return the newest values at or before times; the first value before there is any."""
    at = np.searchsorted(data.time_s, times_s, side="right") - 1
    values: Array = data.values[np.maximum(at, 0)]
    return values


folder = Path(tempfile.mkdtemp())
teleta.simulate("teleta-touch", duration_s=8.0, out=folder)
with teleta.open(folder / "recording.teleta") as recording:
    streams = {
        stream.kind: recording.read(name)
        for name, stream in recording.streams.items()
        if stream.kind in ("array", "joints")
    }

start_s = max(data.time_s[0] for data in streams.values())
stop_s = min(data.time_s[-1] for data in streams.values())
times_s = np.arange(start_s, stop_s, 1.0 / FPS)
joints = newest(streams["joints"], times_s)
count = joints.shape[1] // 3
episode = {
    "timestamp": (times_s - start_s).astype(np.float32),
    "frame_index": np.arange(len(times_s)),
    "observation.state": joints[:, :count].astype(np.float32),
    "observation.effort": joints[:, count : 2 * count].astype(np.float32),
    "action": joints[:, 2 * count :].astype(np.float32),
    "observation.tactile": newest(streams["array"], times_s),
}
for name, column in episode.items():
    print(f"{name}: {column.shape} {column.dtype}")

with pictures.figure("lerobot") as figure:
    axes = figure.subplots()
    axes.plot(episode["timestamp"], episode["observation.state"])
    axes.plot(episode["timestamp"], episode["action"], "--")
    axes.set_xlabel("time, s")
    axes.set_ylabel("angle, rad (dashed: reference)")

print(f"{len(times_s)} frames at {FPS:.0f} fps")
