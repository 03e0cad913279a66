#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of the Python module beside what one would write with numpy, scipy and scikit-image.

PYTHONPATH=build/release/app/python python_benchmark.py PROGRAM      PROGRAM: build/release/app/cli/teleta

Both sides are timed by turns in this process, in processor time, and the best of several turns counts. Before
a ratio is printed the answers are compared. Needs python3-scipy and python3-skimage.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Callable

import numpy as np
from scipy import ndimage
from skimage.feature import peak_local_max
from skimage.morphology import h_maxima
from skimage.segmentation import watershed

import teleta

TURNS = 7
PITCH_M = 0.0034
THRESHOLD_N = 0.2


def balls(frames: int, rows: int, columns: int) -> np.ndarray:
    """Loads of two round contacts that move over an array, with some noise."""
    random = np.random.default_rng(1)
    y, x = np.mgrid[0:rows, 0:columns]
    radius = 0.25 * min(rows, columns)
    loads = np.empty((frames, rows, columns), dtype=np.float32)
    for i in range(frames):
        phase = 2.0 * np.pi * i / frames
        load = np.zeros((rows, columns))
        for share in (0.25, 0.75):
            place = columns * (share + 0.08 * np.sin(phase)), rows * (0.5 + 0.15 * np.cos(phase))
            load += 2.0 * np.maximum(0.0, 1.0 - ((x - place[0]) ** 2 + (y - place[1]) ** 2) / radius**2)
        loads[i] = load + 0.02 * random.random((rows, columns))
    return loads


def by_turns(*works: Callable[[], object]) -> list[float]:
    """Return the best processor time of each, s."""
    best = [float("inf")] * len(works)
    for _ in range(TURNS):
        for i, work in enumerate(works):
            start = time.process_time()
            work()
            best[i] = min(best[i], time.process_time() - start)
    return best


def row(what: str, ours_s: float, theirs: str, theirs_s: float, per: int) -> None:
    print(
        f"{what}: {1e6 * ours_s / per:.2f} us a frame; {theirs}: {1e6 * theirs_s / per:.2f} us; "
        f"ratio {theirs_s / ours_s:.1f}"
    )


def plain_features(frame: np.ndarray) -> tuple[float, ...]:
    """Features of one frame, as one would write them first."""
    rows, columns = frame.shape
    x = (np.arange(columns) - 0.5 * (columns - 1)) * PITCH_M
    y = (np.arange(rows) - 0.5 * (rows - 1)) * PITCH_M
    force = frame.sum()
    cop = (frame.sum(axis=0) * x).sum() / force, (frame.sum(axis=1) * y).sum() / force
    active = frame >= THRESHOLD_N
    yy, xx = np.nonzero(active)
    coc = x[xx].mean(), y[yy].mean()
    values, vectors = np.linalg.eigh(np.cov(x[xx], y[yy]))
    angle = np.arctan2(vectors[1, 1], vectors[0, 1])
    return force, *cop, *coc, angle, values[1], values[0], active.sum()


def batch_features(frames: np.ndarray) -> dict[str, np.ndarray]:
    """Features of all frames at once, in double precision, with dead taxels and empty frames handled."""
    count, rows, columns = frames.shape
    x = np.tile((np.arange(columns) - 0.5 * (columns - 1)) * PITCH_M, rows)
    y = np.repeat((np.arange(rows) - 0.5 * (rows - 1)) * PITCH_M, columns)
    loads = frames.reshape(count, -1).astype(np.float64)
    loads = np.where(np.isfinite(loads), np.maximum(loads, 0.0), 0.0)
    basis = np.column_stack([np.ones_like(x), x, y])
    moments = loads @ basis
    active = (loads >= THRESHOLD_N).astype(np.float64)
    binary = active @ np.column_stack([basis, x * x, x * y, y * y])
    with np.errstate(invalid="ignore", divide="ignore"):
        force = moments[:, 0]
        n = binary[:, 0]
        cop_x, cop_y = moments[:, 1] / force, moments[:, 2] / force
        coc_x, coc_y = binary[:, 1] / n, binary[:, 2] / n
        xx = (binary[:, 3] - n * coc_x**2) / (n - 1.0)
        xy = (binary[:, 4] - n * coc_x * coc_y) / (n - 1.0)
        yy = (binary[:, 5] - n * coc_y**2) / (n - 1.0)
        root = np.hypot(xx - yy, 2.0 * xy)
        largest = 0.5 * (xx + yy + root)
        smallest = (xx * yy - xy**2) / largest
        angle = 0.5 * np.arctan2(2.0 * xy, xx - yy)
    return {
        "force_n": force,
        "cop_x_m": cop_x,
        "cop_y_m": cop_y,
        "coc_x_m": coc_x,
        "coc_y_m": coc_y,
        "alpha_z_rad": angle,
        "lambda1_m2": largest,
        "lambda2_m2": smallest,
        "active": n,
    }


def skimage_contacts(frame: np.ndarray, exact: bool) -> np.ndarray:
    """Forces of the contacts of one frame by watershed; exact: markers are the h-maxima."""
    mask = frame >= THRESHOLD_N
    if exact:
        markers, _ = ndimage.label(h_maxima(frame, 0.3 * frame.max()))
    else:
        markers = np.zeros(frame.shape, dtype=np.int32)
        peaks = peak_local_max(frame, min_distance=2, threshold_abs=THRESHOLD_N)
        markers[tuple(peaks.T)] = np.arange(1, len(peaks) + 1)
    labels = watershed(-frame, markers, mask=mask)
    regions = np.arange(1, labels.max() + 1)
    forces = ndimage.sum_labels(frame, labels, regions)
    ndimage.center_of_mass(frame, labels, regions)
    ndimage.maximum(frame, labels, regions)
    return np.sort(forces)[::-1]


def features_rows() -> None:
    loads = balls(10_000, 6, 14)
    table = teleta.features(loads)
    other = batch_features(loads)
    for name, column in other.items():
        np.testing.assert_allclose(table[name], column, rtol=1e-6, atol=1e-9, err_msg=name)
    ours_s, theirs_s = by_turns(lambda: teleta.features(loads), lambda: batch_features(loads))
    row("features of 10 000 frames, 6 x 14", ours_s, "numpy over all frames at once", theirs_s, 10_000)
    y, x = np.mgrid[0:6, 0:14].astype(np.float32).reshape(2, -1)
    weights = np.column_stack([np.ones_like(x), x, y, x * x, x * y, y * y])
    flat = loads.reshape(10_000, -1)
    np.testing.assert_allclose((flat @ weights)[:, 0], table["force_n"], rtol=1e-4)
    ours_s, theirs_s = by_turns(lambda: teleta.features(loads), lambda: flat @ weights)
    row("the same", ours_s, "the six moments alone, a bare float32 product", theirs_s, 10_000)
    some = loads[:500]
    ours_s, theirs_s = by_turns(
        lambda: teleta.features(loads), lambda: [plain_features(frame) for frame in some]
    )
    row("the same", ours_s, "numpy frame by frame", 20.0 * theirs_s, 10_000)


def contacts_rows() -> None:
    for rows, columns, count in ((6, 14, 2000), (64, 64, 300)):
        loads = balls(count, rows, columns)
        some = loads[:: max(1, count // 100)]
        agree = 0
        for frame in some:
            ours = teleta.contacts(frame, rate_hz=1.0)["force_n"]
            theirs = skimage_contacts(frame, exact=True)
            agree += len(ours) == len(theirs) and np.allclose(ours, theirs, rtol=0.05)
        print(f"contacts of {rows} x {columns}: {agree} of {len(some)} frames have the same contacts by both")
        for exact, name in ((True, "h_maxima and watershed"), (False, "peak_local_max and watershed")):
            ours_s, theirs_s = by_turns(
                lambda: teleta.contacts(loads, rate_hz=200.0),
                lambda: [skimage_contacts(frame, exact) for frame in some],
            )
            theirs_s *= count / len(some)
            row(f"contacts with identities, {rows} x {columns}", ours_s, f"scikit-image {name}", theirs_s, count)


def processor_row() -> None:
    for rows, columns in ((6, 14), (64, 64)):
        loads = balls(2000, rows, columns)
        times_s = np.arange(2000) / 200.0
        processor = teleta.Processor(rows, columns)

        def each() -> None:
            process = processor.process
            processor.reset()
            for frame, time_s in zip(loads, times_s):
                process(frame, time_s)

        def batch() -> None:
            teleta.features(loads)
            teleta.contacts(loads, rate_hz=200.0)

        ours_s, batch_s = by_turns(each, batch)
        row(f"Processor.process, {rows} x {columns}", ours_s, "features and contacts of the batch", batch_s, 2000)


def of_children(command: list[str]) -> float:
    """Return the processor time of a command, s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def program_rows(program: str, folder: Path) -> None:
    loads = balls(10_000, 6, 14)
    times_s = np.arange(10_000) / 200.0
    path = folder / "frames.csv"
    out = folder / "out.csv"
    header = ",".join(["time_s", *(f"t{i}" for i in range(84))])

    def through_files(command: str) -> float:
        start = time.process_time()
        np.savetxt(path, np.column_stack([times_s, loads.reshape(10_000, -1)]), fmt="%.9g", delimiter=",",
                   header=header, comments="")
        own_s = time.process_time() - start
        children_s = of_children([program, command, str(path), "--out", str(out)])
        start = time.process_time()
        np.genfromtxt(out, delimiter=",", names=True, dtype=None, encoding="utf-8")
        return own_s + children_s + time.process_time() - start

    for command, ours in (
        ("features", lambda: teleta.features(loads, time_s=times_s)),
        ("contacts", lambda: teleta.contacts(loads, time_s=times_s)),
    ):
        best = [float("inf")] * 2
        for _ in range(3):
            start = time.process_time()
            ours()
            best[0] = min(best[0], time.process_time() - start)
            best[1] = min(best[1], through_files(command))
        row(f"{command}, 10 000 frames", best[0], "write CSV, program, read CSV", best[1], 10_000)
        alone_s = min(of_children([program, command, str(path), "--out", str(out)]) for _ in range(3))
        row(f"{command}, 10 000 frames", best[0], "the program alone, from CSV to CSV", alone_s, 10_000)


def recording_row(folder: Path) -> None:
    """A recording of a million frames, as arrays and by sqlite3."""
    import sqlite3

    path = folder / "million.teleta"
    teleta.simulate("tactile-indenter", duration_s=20.0, out=folder)
    source = folder / "recording.teleta"
    os.rename(source, path)
    database = sqlite3.connect(path)
    database.execute("PRAGMA journal_mode=DELETE")
    columns = [each[1] for each in database.execute("PRAGMA table_info(block)") if each[1] != "key"]
    stream = database.execute("SELECT stream FROM block GROUP BY stream ORDER BY sum(length(data)) DESC").fetchone()[0]
    blocks = database.execute(
        f"SELECT {', '.join(columns)} FROM block WHERE stream = ? ORDER BY first_ns", (stream,)
    ).fetchall()
    place = {name: i for i, name in enumerate(columns)}
    frames = sum(block[place["frames"]] for block in blocks)
    last_ns = max(np.frombuffer(block[place["time_ns"]], dtype=np.int64)[-1] for block in blocks)
    period_ns = int(last_ns - blocks[0][place["first_ns"]] + 5_000_000)
    repeats = -(-1_000_000 // frames)
    for repeat in range(1, repeats):
        shifted = []
        for block in blocks:
            values = list(block)
            values[place["first_ns"]] += repeat * period_ns
            for name in ("last_ns",):
                if name in place:
                    values[place[name]] += repeat * period_ns
            times = np.frombuffer(block[place["time_ns"]], dtype=np.int64) + repeat * period_ns
            values[place["time_ns"]] = times.tobytes()
            shifted.append(values)
        database.executemany(
            f"INSERT INTO block ({', '.join(columns)}) VALUES ({', '.join('?' * len(columns))})", shifted
        )
    database.commit()
    database.close()

    def ours() -> teleta.Data:
        with teleta.open(path) as recording:
            return recording.read(next(iter(recording.streams)))

    def theirs() -> np.ndarray:
        connection = sqlite3.connect(path)
        query = connection.execute("SELECT data FROM block WHERE stream = ? ORDER BY first_ns", (stream,))
        joined = b"".join(each[0] for each in query)
        connection.close()
        return np.frombuffer(joined, dtype=np.float32).reshape(-1, 6, 14)

    data = ours()
    np.testing.assert_array_equal(data.values, theirs())
    walls = []
    for _ in range(5):
        start = time.monotonic()
        ours()
        walls.append(time.monotonic() - start)
    ours_s, theirs_s = by_turns(ours, theirs)
    count = len(data.time_s)
    size = os.path.getsize(path) / 1e6
    print(
        f"recording of {count} frames, {size:.0f} MB, as arrays: {ours_s:.2f} s of processor time "
        f"({min(walls):.2f} s by the clock, best of 5); values alone by sqlite3: {theirs_s:.2f} s"
    )


def main() -> None:
    program = sys.argv[1]
    json.loads(subprocess.run([program, "simulate", "--list", "--json"], capture_output=True, check=True).stdout)
    features_rows()
    contacts_rows()
    processor_row()
    with tempfile.TemporaryDirectory() as folder:
        program_rows(program, Path(folder))
        recording_row(Path(folder))


if __name__ == "__main__":
    main()
