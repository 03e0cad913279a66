# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames that NumPy wrote, read by the module and the program; and what the program wrote, read by NumPy."""

from __future__ import annotations

import subprocess

import numpy as np
import pytest
from conftest import PROGRAM, balls, read_csv

import teleta

SHAPE = (5, 6, 14)
TYPES = ["?", "i1", "u1"] + [
    order + kind for order in "<>" for kind in ("i2", "i4", "i8", "u2", "u4", "u8", "f2", "f4", "f8")
]


def numbers(dtype: str) -> np.ndarray:
    """Numbers over the range of a type."""
    random = np.random.default_rng(3)
    if np.dtype(dtype).kind == "f":
        return random.normal(0.0, 100.0, SHAPE).astype(dtype)
    if np.dtype(dtype).kind == "b":
        return random.integers(0, 2, SHAPE).astype(dtype)
    info = np.iinfo(dtype)
    return random.integers(info.min, info.max, SHAPE, dtype=np.dtype(dtype).newbyteorder("=")).astype(dtype)


@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("dtype", TYPES)
def test_every_type_and_order_of_npy(tmp_path, dtype, order):
    values = numbers(dtype)
    np.save(tmp_path / "a.npy", np.asarray(values, order=order))
    read = teleta.read_frames(tmp_path / "a.npy", rate_hz=100.0)
    np.testing.assert_array_equal(read.values, values.astype(np.float64).astype(np.float32))
    np.testing.assert_allclose(read.time_s, np.arange(5) / 100.0, rtol=1e-15)


@pytest.mark.parametrize("version", [(1, 0), (2, 0), (3, 0)])
def test_every_version_of_npy(tmp_path, version):
    values = numbers("f4")
    with open(tmp_path / "a.npy", "wb") as file:
        np.lib.format.write_array(file, values, version=version)
    np.testing.assert_array_equal(teleta.read_frames(tmp_path / "a.npy", rate_hz=1.0).values, values)


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_npz(tmp_path, save):
    values = numbers("f4")
    time_s = np.cumsum(np.full(5, 0.25))
    save(tmp_path / "frames.csv.npz", other=np.arange(3), data=values, time_s=time_s)
    (tmp_path / "frames.csv.npz").rename(tmp_path / "frames.csv")
    read = teleta.read_frames(tmp_path / "frames.csv")
    np.testing.assert_array_equal(read.values, values)
    np.testing.assert_array_equal(read.time_s, time_s)


def test_frames_last_follow_from_the_times(tmp_path):
    values = numbers("f8")
    np.savez(tmp_path / "a.npz", frames=np.moveaxis(values, 0, 2), time_s=np.arange(5.0))
    np.testing.assert_array_equal(teleta.read_frames(tmp_path / "a.npz").values, values.astype(np.float32))


@pytest.mark.parametrize(
    "array, reason",
    [
        (np.array([[[{}]]], dtype=object), "pickled"),
        (np.zeros((1, 1, 1), dtype=[("x", "f4"), ("y", "f4")]), "structured"),
        (np.zeros((1, 1, 1), dtype=complex), "complex"),
        (np.array([[["a"]]]), "texts"),
        (np.zeros(3), "shape 3"),
        (np.zeros((2, 2, 2, 2)), "2 x 2 x 2 x 2"),
    ],
)
def test_what_is_no_frame_is_refused(tmp_path, array, reason):
    np.save(tmp_path / "a.npy", array, allow_pickle=True)
    with pytest.raises(teleta.BadInputError, match=reason):
        teleta.read_frames(tmp_path / "a.npy", rate_hz=1.0)


def test_the_program_computes_the_same_from_npz_as_from_csv(program, indenter, tmp_path):
    program("export", indenter / "recording.teleta", "--npz", tmp_path / "a.npz")
    program("export", indenter / "recording.teleta", "--csv", tmp_path / "csv")
    written = np.load(tmp_path / "a.npz")
    table = teleta.read_frames(indenter / "recording.teleta")
    assert written["frames"].dtype == np.float32 and written["time_s"].dtype == np.float64
    np.testing.assert_array_equal(written["frames"], table.values)
    np.testing.assert_array_equal(written["time_s"], table.time_s)
    name = next(path for path in (tmp_path / "csv").glob("*.csv") if path.read_text().startswith("time_s,t0,"))
    assert program("features", tmp_path / "a.npz") == program("features", name)
    assert program("contacts", tmp_path / "a.npz") == program("contacts", name)


def test_vectors_and_places_are_exported_and_read_back(program, tmp_path):
    layout, recording, npz = tmp_path / "skin.toml", tmp_path / "skin.teleta", tmp_path / "skin.npz"
    layout.write_text(
        '[layout]\ncomponents = 3\nunit = "N"\naxes = ["+x", "-y", "-z"]\npositions_mm = [[-7, -4], [5, -3], [0, 6]]\n'
    )
    values = np.random.default_rng(5).normal(size=(4, 3, 3)).astype("f4")
    np.savez(tmp_path / "raw.npz", frames=values, time_s=np.arange(4) / 8.0)
    program("import", tmp_path / "raw.npz", "--layout", layout, "--out", recording)
    program("export", recording, "--npz", npz)
    written = np.load(npz)
    np.testing.assert_array_equal(written["frames"], values * np.array([1, -1, -1], dtype="f4"))
    np.testing.assert_array_equal(written["time_s"], np.arange(4) / 8.0)
    # The middle of the box around the places is the origin.
    places_m = np.array([[-6, -5, 0], [6, -4, 0], [1, 5, 0]]) / 1000.0
    np.testing.assert_allclose(written["positions_m"], places_m, atol=1e-12)
    printed = [program("contacts", file, "--layout", layout) for file in (tmp_path / "raw.npz", npz)]
    assert printed[0] == printed[1]


def test_the_rest_is_taken_from_the_recording(program, tmp_path):
    frames = balls(41, 6, 14)
    frames[:30] = 0.0
    np.savez(tmp_path / "raw.npz", frames=frames + 7.0, time_s=np.arange(41) / 20.0)
    np.savez(tmp_path / "tared.npz", frames=frames, time_s=np.arange(41) / 20.0)
    expected = read_csv(program("features", tmp_path / "tared.npz"))
    for rest in ("median", "first"):
        found = read_csv(program("features", tmp_path / "raw.npz", "--tare", rest))
        force_n = [np.array(table["force_n"], dtype=float) for table in (expected, found)]
        np.testing.assert_allclose(force_n[1], force_n[0], atol=1e-3)


def test_tables_of_other_programs(program, tmp_path):
    frames = balls(20, 6, 14)
    own, foreign = tmp_path / "own.csv", tmp_path / "foreign.txt"
    flat = frames.reshape(20, -1)
    own.write_text(
        "time_s," + ",".join(f"t{i}" for i in range(84)) + "\n"
        + "".join(f"{i * 0.05}," + ",".join(repr(float(v)) for v in row) + "\n" for i, row in enumerate(flat))
    )
    foreign.write_text(
        "timestamp_ms;" + ";".join(f"s{i + 1}" for i in range(84)) + "\n"
        + "".join(
            f"{i * 50};" + ";".join(repr(float(v)).replace(".", ",") for v in row) + "\n" for i, row in enumerate(flat)
        )
    )
    failed = subprocess.run([PROGRAM, "features", foreign], capture_output=True, text=True, check=False)
    options = "--columns 2..85 --time-column timestamp_ms --time-unit ms"
    assert failed.returncode == 3 and options in failed.stderr, failed.stderr
    printed = [read_csv(program("features", own)), read_csv(program("features", foreign, *options.split()))]
    for name in ("force_n", "cop_x_m", "time_s"):
        values = [[float(v) if v != "NA" else np.nan for v in table[name]] for table in printed]
        np.testing.assert_allclose(values[0], values[1], rtol=1e-12)
    read = teleta.read_frames(foreign, taxel_columns="2..85", time_column="1", rows=6, columns=14)
    np.testing.assert_array_equal(read.values, frames)
    np.testing.assert_allclose(read.time_s, np.arange(20) * 0.05)


def test_wrong_arguments_are_refused(tmp_path):
    np.save(tmp_path / "a.npy", np.zeros((2, 2, 2)))
    with pytest.raises(ValueError, match="frame_axis"):
        teleta.read_frames(tmp_path / "a.npy", frame_axis="middle")
    with pytest.raises(ValueError, match="taxel_columns"):
        teleta.read_frames(tmp_path / "a.npy", taxel_columns="2-85")
    with pytest.raises(ValueError, match="rate_hz"):
        teleta.read_frames(tmp_path / "a.npy", rate_hz=0.0)
    with pytest.raises(teleta.BadInputError, match="--rate"):
        teleta.read_frames(tmp_path / "a.npy")
