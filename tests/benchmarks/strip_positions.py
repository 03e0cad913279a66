#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Places of known touches on recorded strip sensors: `teleta features` and `contacts` against centroids and a parabola.

Usage: strip_positions.py TELETA FOLDER

FOLDER: `02_Simplified_Files` of https://github.com/fkeel/interdigitation at c9f6aca: 51 strip sensors of seven strips
each, touched at 71 places along eleven lines with two forces. The repository has no licence, so its files are not kept
here. Columns: X (steps), Y, Z, then the readings of the strips, which fall under load.

The places of a recording are fitted to X by one straight line, as the sensors' origin and pitch are not known. Printed
are the lowest, the middle and the highest root mean square of what is left, in steps, of all recordings. The rest
values are the highest reading of each strip (`highest`), 95 % of it, or those that `--tare untouched` finds. The last
line tells how often 1.96 standard errors of the summit hold the place, with the noise of an untouched strip.
"""

import csv
import io
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

THRESHOLD = "100"
NOISE = "9"
STRIPS = 7


def readings_of(path):
    """Places and readings of a recording."""
    table = np.genfromtxt(path, delimiter=",", skip_header=1)
    return table[:, 0], table[:, 3:]


def centroid(loads):
    """Centre of all strips."""
    return loads @ np.arange(STRIPS) / loads.sum(axis=1)


def around_peak(loads):
    """Strip of the peak, and the loads before it, at it and behind it."""
    peak = loads.argmax(axis=1)
    padded = np.pad(loads, ((0, 0), (1, 1)))
    rows = np.arange(len(loads))
    return peak, padded[rows, peak], padded[rows, peak + 1], padded[rows, peak + 2]


def parabola(loads):
    """Summit of the parabola through the peak and its neighbours; at the ends the peak itself."""
    peak, before, top, after = around_peak(loads)
    bend = before - 2 * top + after
    offset = np.divide(0.5 * (before - after), bend, out=np.zeros_like(bend), where=bend != 0)
    return peak + np.where((peak == 0) | (peak == STRIPS - 1), 0, offset)


def three_strips(loads):
    """Centre of the peak and its neighbours."""
    peak, before, top, after = around_peak(loads)
    return peak + (after - before) / (before + top + after)


def left_over(places, x):
    """Root mean square in steps after the best straight line, and the steps of a strip; without places: none."""
    known = np.isfinite(places)
    if known.mean() < 0.9:
        return np.nan, np.nan
    slope, start = np.polyfit(places[known], x[known], 1)
    return np.sqrt(np.mean((slope * places[known] + start - x[known]) ** 2)), slope


def write_frames(path, frames):
    """A table of frames as teleta reads it."""
    with open(path, "w") as out:
        out.write("time_s," + ",".join(f"t{i}" for i in range(STRIPS)) + "\n")
        for i, frame in enumerate(frames):
            out.write(f"{i / 100}," + ",".join(str(value) for value in frame) + "\n")


def teleta(program, command, frames, tare, column, *options):
    """One place a frame, in strips; of several contacts the strongest one; None when the program refuses."""
    done = subprocess.run(
        [program, command, frames, "--rows", "1", "--columns", str(STRIPS), "--pitch-mm", "1000", "--invert",
         "--tare", tare, "--threshold", THRESHOLD, *options],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode != 0:
        print(f"{pathlib.Path(frames).stem}: {done.stderr.strip()}", file=sys.stderr)
        return None
    places = {}
    for row in csv.DictReader(io.StringIO(done.stdout)):
        value = np.nan if row[column] == "NA" else float(row[column])
        if "_se_" not in column:
            value += (STRIPS - 1) / 2
        places.setdefault(round(float(row["time_s"]) * 100), value)
    return places


def share_held(places, errors, x):
    """How often 1.96 standard errors hold the place that the straight line gives."""
    at = np.array([places.get(i, np.nan) for i in range(len(x))])
    se = np.array([errors.get(i, np.nan) for i in range(len(x))])
    known = np.isfinite(at)
    slope, start = np.polyfit(at[known], x[known], 1)
    off = np.abs(slope * at[known] + start - x[known]) / slope
    return np.mean(off <= 1.96 * se[known])


def main(program, folder):
    """Print one line a method."""
    recordings = sorted(pathlib.Path(folder).glob("*.csv"))
    if not recordings:
        sys.exit(f"strip_positions.py: no recordings in {folder}")
    found = {}
    held = []

    def add(name, places, x):
        if places is None:
            found.setdefault(name, []).append((np.nan, np.nan))
            return
        if isinstance(places, dict):
            places = np.array([places.get(i, np.nan) for i in range(len(x))])
        found.setdefault(name, []).append(left_over(places, x))

    with tempfile.TemporaryDirectory() as work:
        for recording in recordings:
            x, readings = readings_of(recording)
            frames = f"{work}/{recording.name}"
            write_frames(frames, readings)
            highest = readings.max(axis=0)
            for name, rest in (("highest", highest), ("95 % of the highest", 0.95 * highest)):
                loads = np.clip(rest - readings, 0, None)
                add(f"centroid, {name}", centroid(loads), x)
                add(f"three-point parabola, {name}", parabola(loads), x)
                add(f"centroid of three strips, {name}", three_strips(loads), x)
                write_frames(f"{work}/tare", [rest])
                tare = f"{work}/tare"
                add(f"features --active-only, {name}",
                    teleta(program, "features", frames, tare, "cop_x_m", "--active-only"), x)  # fmt: skip
                add(f"contacts, {name}", teleta(program, "contacts", frames, tare, "x_m"), x)
                summits = teleta(program, "features", frames, tare, "summit_x_m", "--summit")
                add(f"features --summit, {name}", summits, x)
                if name == "highest":
                    errors = teleta(program, "features", frames, tare, "summit_x_se_m", "--summit", "--noise-sd", NOISE)
                    held.append(share_held(summits, errors, x))
                add(f"contacts --summit, {name}",
                    teleta(program, "contacts", frames, tare, "summit_x_m", "--summit"), x)  # fmt: skip
            add("features --summit --tare untouched",
                teleta(program, "features", frames, "untouched", "summit_x_m", "--summit"), x)  # fmt: skip
            add("contacts --summit --tare untouched",
                teleta(program, "contacts", frames, "untouched", "summit_x_m", "--summit"), x)  # fmt: skip
    print(f"{'method, rest value':52} {'best':>6} {'median':>6} {'worst':>6} {'steps':>6} {'none':>5}")
    for name, each in found.items():
        rms, slope = np.array(each).T
        print(
            f"{name:52} {np.nanmin(rms):6.2f} {np.nanmedian(rms):6.2f} {np.nanmax(rms):6.2f}"
            f" {np.nanmedian(slope):6.1f} {np.isnan(rms).sum():5d}"
        )
    print(f"1.96 standard errors hold {np.median(held):.0%} in the median, {np.min(held):.0%} to {np.max(held):.0%}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
