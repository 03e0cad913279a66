#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calibrate the camera in the soft tube from pairs of pixels and points, and locate pixels with it."""

import tempfile
from pathlib import Path

import numpy as np
import pictures

import teleta

folder = Path(tempfile.mkdtemp())
teleta.simulate("vtacarm-calibration", duration_s=60.0, out=folder)
names = (folder / "pairs.csv").read_text().splitlines()[0].split(",")
pairs = np.genfromtxt(folder / "pairs.csv", delimiter=",", skip_header=1)
pixels_px = pairs[:, [names.index("u_px"), names.index("v_px")]]
points_m = pairs[:, [names.index("x_m"), names.index("y_m"), names.index("z_m")]]

found = teleta.calibrate(pixels_px, points_m)
found.camera.save(folder / "camera.json")
located_m, sd_m = found.camera.locate(pixels_px)
off_m = np.linalg.norm(located_m - points_m, axis=1)

with pictures.figure("calibration") as figure:
    left, right = figure.subplots(1, 2)
    kept, residual_px = found.kept, found.residual_px
    left.quiver(pixels_px[kept, 0], pixels_px[kept, 1], residual_px[kept, 0], -residual_px[kept, 1], width=0.004)
    left.plot(pixels_px[~kept, 0], pixels_px[~kept, 1], "x", color="tab:red", label="left out")
    left.legend(loc="center")
    left.set_aspect("equal")
    left.invert_yaxis()
    left.set_title("residuals of the kept pairs")
    right.hist(1e3 * off_m[kept & np.isfinite(off_m)], bins=30)
    right.set_xlabel("located point off by, mm")

print(f"{found.kept.sum()} of {len(found.kept)} pairs kept, {found.rms_px:.2f} px rms")
print(f"located to within {1e3 * np.nanmedian(off_m[found.kept]):.1f} mm (median)")
