# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes, orders, types and ownership of arrays that go in and come out."""

from __future__ import annotations

import sys

import numpy as np
import pytest
from conftest import balls

import teleta

LOADS = balls(12, 6, 14)
WANTED = teleta.features(LOADS)


class Subclass(np.ndarray):
    """A class of its own, as libraries have them."""


def variants():
    yield "float64", LOADS.astype(np.float64)
    yield "big-endian", LOADS.astype(">f4")
    yield "Fortran order", np.asfortranarray(LOADS)
    yield "strided", np.repeat(LOADS, 2, axis=2)[:, :, ::2]
    yield "reversed twice", LOADS[::-1].copy()[::-1]
    yield "list", LOADS.tolist()
    yield "subclass", LOADS.view(Subclass)
    frozen = LOADS.copy()
    frozen.flags.writeable = False
    yield "read-only", frozen


@pytest.mark.parametrize("name, frames", list(variants()), ids=lambda value: value if isinstance(value, str) else "")
def test_every_kind_of_array_gives_the_same(name, frames):
    table = teleta.features(frames)
    for column, values in WANTED.items():
        np.testing.assert_array_equal(table[column], values, err_msg=name)


@pytest.mark.parametrize("kind", ["u1", "i2", "i8", "f2", "?"])
def test_whole_numbers_and_short_floats_are_converted(kind):
    raw = (LOADS > 1.0).astype(kind)
    np.testing.assert_array_equal(
        teleta.features(raw)["force_n"], (LOADS > 1.0).sum(axis=(1, 2)).astype(float)
    )


@pytest.mark.parametrize("kind", ["c8", "c16", "O", "U3", "M8[s]"])
def test_other_kinds_are_refused(kind):
    frames = np.zeros((2, 6, 14), dtype=kind)
    with pytest.raises(TypeError, match="frames: expected real numbers"):
        teleta.features(frames)


def test_masked_taxels_are_dead():
    mask = np.zeros(LOADS.shape, dtype=bool)
    mask[:, 3, 4] = True
    masked = teleta.features(np.ma.masked_array(LOADS, mask))
    dead = np.zeros((6, 14), dtype=bool)
    dead[3, 4] = True
    np.testing.assert_array_equal(masked["force_n"], teleta.features(LOADS, dead=dead)["force_n"])


@pytest.mark.parametrize("shape", [(6,), (1, 1, 1, 1), ()])
def test_a_wrong_shape_is_named(shape):
    with pytest.raises(ValueError, match=r"frames: expected \(frames, rows, columns\), got \("):
        teleta.features(np.zeros(shape))


def test_no_frames_give_empty_columns():
    table = teleta.features(np.zeros((0, 6, 14)))
    assert {len(column) for column in table.values()} == {0}
    assert table["contact_type"].dtype.kind == "U" and table["active"].dtype == np.int64
    table, labels = teleta.contacts(np.zeros((0, 6, 14)), rate_hz=1.0, return_labels=True)
    assert {len(column) for column in table.values()} == {0} and labels.shape == (0, 6, 14)


def test_a_single_taxel_is_an_array():
    table = teleta.features([[[2.0]], [[0.0]]])
    assert table["contact_type"].tolist() == ["point", "none"]
    assert table["cop_x_m"][0] == 0.0
    assert teleta.contacts([[2.0]], rate_hz=1.0)["force_n"].tolist() == [2.0]


def test_results_own_their_memory_and_can_be_written_to():
    table = teleta.features(LOADS)
    for name, column in table.items():
        assert column.ndim == 1 and column.flags.writeable and column.flags.c_contiguous, name
        kept = column.copy()
        column[0] = column[-1]
        assert column[0] == kept[-1] or column[0] != column[0]
    again = teleta.features(LOADS)
    np.testing.assert_array_equal(again["force_n"], WANTED["force_n"])


def test_nothing_keeps_a_reference_to_an_input():
    frames = LOADS.copy()
    tare = np.zeros((6, 14), dtype=np.float32)
    processor = teleta.Processor(6, 14)
    before = sys.getrefcount(frames), sys.getrefcount(tare)
    teleta.features(frames, tare=tare)
    teleta.contacts(frames, tare=tare, return_labels=True)
    processor.process(frames[0], 0.0)
    teleta.contour(np.zeros((3, 2)))
    assert (sys.getrefcount(frames), sys.getrefcount(tare)) == before


def test_no_copy_is_made_of_what_fits():
    # A copy of this input would need 160 MB.
    import resource

    # Written, so that its own pages are counted before: whether reading zeros takes memory depends on the kernel.
    large = np.full((500_000, 8, 10), 0.01, dtype=np.float32)
    before_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    teleta.features(large)
    grown_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kib
    # The table: 12 columns of 8 bytes, 20 bytes of text.
    columns_kib = 500_000 * (12 * 8 + 20) / 1024
    assert grown_kib < columns_kib + 20 * 1024


def test_a_table_is_what_pandas_takes():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(WANTED)
    assert list(table.columns) == list(WANTED)
    assert len(table) == len(LOADS)
