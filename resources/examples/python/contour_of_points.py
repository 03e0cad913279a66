#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape of an object from the points at which it was touched."""

import numpy as np
import pictures

import teleta

# A triangle with sides of 8 cm, touched at 24 places with errors of half a millimetre.
random = np.random.default_rng(1)
corners_m = 0.08 * np.array([[0.0, 0.0], [1.0, 0.0], [0.5, np.sqrt(0.75)]])
points_m = np.concatenate(
    [
        start + (end - start) * np.linspace(0.0, 1.0, 8, endpoint=False)[:, None]
        for start, end in zip(corners_m, np.roll(corners_m, -1, axis=0))
    ]
) + random.normal(0.0, 0.0005, (24, 2))

found = teleta.contour(points_m, closed=True)

with pictures.figure("contour", 480, 420) as figure:
    axes = figure.subplots()
    axes.plot(1e3 * found.curve["x_m"], 1e3 * found.curve["y_m"], label="spline")
    axes.plot(1e3 * points_m[:, 0], 1e3 * points_m[:, 1], "o", markersize=4, label="touched")
    axes.plot(1e3 * found.vertices[:, 0], 1e3 * found.vertices[:, 1], "x", markersize=10, label="corners")
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    axes.set_aspect("equal")
    axes.legend()

print(f"length of the curve {1e3 * found.length_m:.0f} mm")
print(f"{found.shape}, confidence {found.confidence:.2f}")
