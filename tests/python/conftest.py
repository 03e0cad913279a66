# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests share: the program, its CSV files, frames with contacts."""

from __future__ import annotations

import csv
import os
import pathlib
import subprocess

import numpy as np
import pytest

import teleta

PROGRAM = os.environ["TELETA_PROGRAM"]


def run_program(*arguments: object) -> str:
    """Run the command line program and return what it prints."""
    done = subprocess.run(
        [PROGRAM, *map(str, arguments)],
        capture_output=True,
        text=True,
        env={**os.environ, "LC_ALL": "C.UTF-8", "LANGUAGE": "en"},
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def read_csv(text_or_path: str | pathlib.Path) -> dict[str, list[str]]:
    """Read a CSV as text, column by column."""
    is_path = isinstance(text_or_path, pathlib.Path)
    text = text_or_path.read_text() if is_path else text_or_path
    rows = list(csv.reader(text.splitlines()))
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def assert_same(table: dict[str, np.ndarray], printed: dict[str, list[str]], columns: list[str]) -> None:
    """Assert that a table has the values that the program printed, to the last bit."""
    for name in columns:
        column = table[name]
        assert len(column) == len(printed[name]), name
        if column.dtype.kind == "U":
            assert column.tolist() == printed[name], name
        else:
            numbers = np.array([np.nan if text == "NA" else float(text) for text in printed[name]])
            np.testing.assert_array_equal(column.astype(float), numbers, err_msg=name)


@pytest.fixture
def program():
    return run_program


@pytest.fixture(scope="session")
def indenter(tmp_path_factory) -> pathlib.Path:
    """A folder with the results of a simulated array, made by the program."""
    folder = tmp_path_factory.mktemp("indenter")
    run_program("simulate", "tactile-two-contacts", "--duration", 6, "--out", folder)
    return folder


@pytest.fixture(scope="session")
def frames(indenter) -> teleta.Data:
    return teleta.read_frames(indenter / "frames.csv")


def balls(frames: int, rows: int, columns: int, seed: int = 1) -> np.ndarray:
    """Loads of two round contacts that move over an array, with some noise."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[0:rows, 0:columns]
    loads = np.empty((frames, rows, columns), dtype=np.float32)
    for i in range(frames):
        phase = 2.0 * np.pi * i / max(frames, 1)
        load = np.zeros((rows, columns))
        for share in (0.25, 0.75):
            place = columns * (share + 0.1 * np.sin(phase)), rows * (0.5 + 0.2 * np.cos(phase))
            load += 2.0 * np.maximum(0.0, 1.0 - ((x - place[0]) ** 2 + (y - place[1]) ** 2) / (0.16 * rows**2))
        loads[i] = load + 0.02 * random.random((rows, columns))
    return loads
