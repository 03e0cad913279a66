# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames that h5py and SciPy wrote, read by the module and the program."""

from __future__ import annotations

import subprocess

import numpy as np
import pytest
from conftest import PROGRAM

import teleta

# They are packages of Debian, which another interpreter does not see.
h5py = pytest.importorskip("h5py", reason="python3-h5py is not installed for this interpreter")
sio = pytest.importorskip("scipy.io", reason="python3-scipy is not installed for this interpreter")

SHAPE = (7, 6, 14)
TYPES = [order + kind for order in "<>" for kind in ("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f2", "f4", "f8")]
TIME_S = np.cumsum(np.full(7, 0.25))


def numbers(dtype: str) -> np.ndarray:
    random = np.random.default_rng(3)
    if np.dtype(dtype).kind == "f":
        return random.normal(0.0, 100.0, SHAPE).astype(dtype)
    info = np.iinfo(dtype)
    return random.integers(info.min, info.max, SHAPE, dtype=np.dtype(dtype).newbyteorder("=")).astype(dtype)


def as_read(values: np.ndarray) -> np.ndarray:
    return values.astype(np.float64).astype(np.float32)


@pytest.mark.parametrize("dtype", TYPES)
def test_every_type_of_hdf5(tmp_path, dtype):
    values = numbers(dtype)
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["frames"] = values
        file["time_s"] = TIME_S
    read = teleta.read_frames(tmp_path / "a.h5")
    np.testing.assert_array_equal(read.values, as_read(values))
    np.testing.assert_array_equal(read.time_s, TIME_S)


@pytest.mark.parametrize(
    "how",
    [
        {},
        {"chunks": (2, 5, 3)},
        {"chunks": (2, 5, 3), "compression": "gzip"},
        {"compression": "gzip", "shuffle": True, "fletcher32": True},
    ],
)
@pytest.mark.parametrize("libver", ["earliest", "latest"])
def test_every_layout_of_hdf5(tmp_path, how, libver):
    values = numbers("f4")
    with h5py.File(tmp_path / "a.dat", "w", libver=libver) as file:
        file.create_dataset("trial/3/pad", data=values, **how).attrs["unit"] = "N"
        file["trial/3/time_s"] = TIME_S
        file["time_s"] = np.arange(3.0)
    read = teleta.read_frames(tmp_path / "a.dat")
    np.testing.assert_array_equal(read.values, values)
    np.testing.assert_array_equal(read.time_s, TIME_S)
    assert read.unit == "N"


def test_a_dataset_that_is_read_in_several_pieces(tmp_path):
    values = np.arange(3 * 1001 * 1003, dtype="f4").reshape(3, 1001, 1003)
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["frames"] = np.moveaxis(values, 0, 2)
    read = teleta.read_frames(tmp_path / "a.h5", rate_hz=10.0, frame_axis="last")
    np.testing.assert_array_equal(read.values, values)


def hdf5_of(path, **kinds):
    with h5py.File(path, "w") as file:
        for name, make in kinds.items():
            make(file, name)


def virtual_layout():
    layout = h5py.VirtualLayout(SHAPE, "f4")
    layout[:] = h5py.VirtualSource("b.h5", "frames", shape=SHAPE)
    return layout


@pytest.mark.parametrize(
    "make, reason",
    [
        (lambda f, n: f.create_dataset(n, data=numbers("f4"), compression="lzf"), "lzf"),
        (lambda f, n: f.create_dataset(n, data=numbers("f4").astype(complex)), "compound"),
        (lambda f, n: f.create_dataset(n, data="text"), "contains text"),
        (lambda f, n: f.create_dataset(n, shape=(1 << 20, 6, 14), dtype="f4", chunks=(1, 6, 14)), "never written"),
        (lambda f, n: f.create_dataset(n, data=h5py.Empty("f4")), "no values"),
        (lambda f, n: f.create_dataset(n, shape=(1 << 30, 6, 14), dtype="f4", chunks=(1, 6, 14)), "never|too large"),
        (
            lambda f, n: f.create_dataset(n, SHAPE, "f4", external=[("/etc/hostname", 0, h5py.h5f.UNLIMITED)]),
            "other files",
        ),
        (lambda f, n: f.create_virtual_dataset(n, virtual_layout()), "other files"),
    ],
)
def test_what_is_no_frame_in_hdf5_is_refused(tmp_path, make, reason):
    hdf5_of(tmp_path / "a.h5", frames=make)
    with pytest.raises(teleta.BadInputError, match=reason):
        teleta.read_frames(tmp_path / "a.h5", rate_hz=1.0)


def test_links_to_other_files_are_not_followed(tmp_path):
    hdf5_of(tmp_path / "b.h5", frames=lambda f, n: f.create_dataset(n, data=numbers("f4")))
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["frames"] = h5py.ExternalLink("b.h5", "/frames")
        file["loop"] = h5py.SoftLink("/")
    with pytest.raises(teleta.BadInputError, match="no arrays"):
        teleta.read_frames(tmp_path / "a.h5", rate_hz=1.0)


@pytest.mark.parametrize("form, compressed", [("5", False), ("5", True), ("4", False)])
@pytest.mark.parametrize("axis", ["first", "last"])
def test_mat_files(tmp_path, form, compressed, axis):
    values = numbers("f8")
    flat = values.reshape(7, 84) if form == "4" else values
    stored = flat if axis == "first" else np.moveaxis(flat, 0, -1)
    sio.savemat(
        tmp_path / "a.mat", {"pad": stored, "time_s": TIME_S, "who": "x"}, format=form, do_compression=compressed
    )
    read = teleta.read_frames(tmp_path / "a.mat", rows=6, columns=14)
    np.testing.assert_array_equal(read.values, as_read(values))
    np.testing.assert_array_equal(read.time_s, TIME_S)


@pytest.mark.parametrize("dtype", ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"])
def test_every_type_of_mat(tmp_path, dtype):
    values = numbers(dtype)
    sio.savemat(tmp_path / "a.mat", {"frames": values})
    read = teleta.read_frames(tmp_path / "a.mat", rate_hz=2.0, frame_axis="first")
    np.testing.assert_array_equal(read.values, as_read(values))


@pytest.mark.parametrize(
    "variables, reason",
    [
        ({"a": np.zeros((2, 2, 2)), "b": np.ones((3, 2, 2))}, r"a \(2 x 2 x 2\), b \(3 x 2 x 2\)"),
        ({"a": np.zeros((2, 2, 2), dtype=complex)}, "complex"),
        ({"a": {"b": np.zeros((2, 2, 2))}}, "other variables"),
        ({"a": np.zeros((2, 2, 2))}, "--frame-axis"),
    ],
)
def test_what_is_no_frame_in_mat_is_refused(tmp_path, variables, reason):
    sio.savemat(tmp_path / "a.mat", variables)
    with pytest.raises(teleta.BadInputError, match=reason):
        teleta.read_frames(tmp_path / "a.mat", rate_hz=1.0)


def test_the_program_reads_them_like_a_table(tmp_path):
    values = np.abs(numbers("f4"))
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["one"] = values
        file["two"] = values * 2
        file["time_s"] = TIME_S
    sio.savemat(tmp_path / "a.mat", {"pad": values, "time_s": TIME_S})
    np.savez(tmp_path / "a.npz", frames=values, time_s=TIME_S)
    outputs = []
    for command in ("features", "contacts"):
        for file in (["a.npz"], ["a.h5", "--array", "one"], ["a.h5:/one"], ["a.mat"]):
            done = subprocess.run([PROGRAM, command, *file], cwd=tmp_path, capture_output=True, text=True)
            assert done.returncode == 0, done.stderr
            outputs.append(done.stdout)
        assert len(set(outputs[-4:])) == 1
    done = subprocess.run([PROGRAM, "features", "a.h5"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 3
    assert "one (7 x 6 x 14), two (7 x 6 x 14)" in done.stderr
    assert "HDF5-DIAG" not in done.stderr


def test_other_users_of_the_library_are_left_alone(tmp_path):
    hdf5_of(tmp_path / "a.h5", frames=lambda f, n: f.create_dataset(n, data=numbers("f4")))
    with h5py.File(tmp_path / "a.h5", "r") as file:
        read = teleta.read_frames(tmp_path / "a.h5", rate_hz=1.0)
        np.testing.assert_array_equal(file["frames"][:], read.values)
