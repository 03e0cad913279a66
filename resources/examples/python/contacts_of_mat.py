#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts on a pressure mat: where each one goes, by its identity."""

import tempfile
from pathlib import Path

import numpy as np
import pictures

import teleta

folder = Path(tempfile.mkdtemp())
teleta.simulate("tactile-mat", duration_s=18.0, out=folder)
frames = teleta.read_frames(folder / "frames.csv", rows=64, columns=27)
table = teleta.contacts(
    frames.values, pitch_m=0.0254, threshold_n=0.5, minimum_taxels=4, time_s=frames.time_s
)

identities, counts = np.unique(table["contact_id"], return_counts=True)
long_ones = identities[counts > 100]

with pictures.figure("contacts", 480, 520) as figure:
    axes = figure.subplots()
    axes.imshow(
        frames.values.max(axis=0), origin="lower", extent=(-0.343, 0.343, -0.813, 0.813), cmap="Greys"
    )
    for identity in long_ones:
        own = table["contact_id"] == identity
        axes.plot(table["x_m"][own], table["y_m"][own], ".", markersize=3, label=f"contact {identity}")
    axes.set_xlabel("x, m")
    axes.set_ylabel("y, m")
    axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0))

heaviest = table["contact_id"][np.argmax(table["force_n"])]
print(f"{len(long_ones)} contacts were seen for more than a second")
print(f"the heaviest one is number {heaviest}")
