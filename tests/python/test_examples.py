# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run by themselves, and their last line is what it should be."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys

import pytest

FOLDER = pathlib.Path(os.environ["TELETA_SOURCE_DIR"]) / "resources" / "examples" / "python"

#: What the last line is, and the picture.
EXAMPLES: dict[str, tuple[str, str | None]] = {
    "calibrate_and_locate": (r"located to within 0\.\d mm \(median\)", "calibration"),
    "contacts_of_mat": (r"the heaviest one is number \d+", "contacts"),
    "contour_of_points": (r"triangle, confidence [01]\.\d\d", "contour"),
    "features_of_csv": (r"largest force \d+\.\d\d N", "features"),
    "pattern_from_formula": (r"\d{6} bytes of WAV with six channels", "pattern"),
    "press_to_gains": (r"unevenness \d+ % before, \d % after", "gains"),
    "recording_to_arrays": (r"\d+ joint samples between 1 s and 2 s, largest torque \d+ mNm", None),
    "recording_to_lerobot": (r"2\d\d frames at 30 fps", "lerobot"),
    "stiffness_of_log": (r"material: \w+", "stiffness"),
    "study_statistics": (r"condition: p < 0\.001 is True", "study"),
}


def run(name: str, *arguments: object, folder: pathlib.Path) -> str:
    done = subprocess.run(
        [sys.executable, FOLDER / f"{name}.py", *map(str, arguments)],
        capture_output=True,
        text=True,
        cwd=folder,
        env={**os.environ, "TMPDIR": str(folder)},
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_none_is_forgotten():
    assert {path.stem for path in FOLDER.glob("*.py")} == {*EXAMPLES, "pictures"}


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_ends_with_its_line(name, tmp_path):
    last_line, picture = EXAMPLES[name]
    printed = run(name, "--pictures", tmp_path / "pictures", folder=tmp_path)
    assert re.fullmatch(last_line, printed.splitlines()[-1])
    if picture is None:
        return
    if "picture skipped" in printed:
        pytest.skip("python3-matplotlib is not installed")
    assert (tmp_path / "pictures" / f"{picture}.png").stat().st_size > 5000


def test_without_matplotlib_only_the_picture_is_left_out(tmp_path):
    (tmp_path / "matplotlib.py").write_text("raise ImportError('not here')\n")
    done = subprocess.run(
        [sys.executable, FOLDER / "contour_of_points.py"],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": f"{tmp_path}:{os.environ['PYTHONPATH']}"},
        check=True,
    )
    assert "picture skipped: it needs python3-matplotlib" in done.stdout
    assert re.fullmatch(EXAMPLES["contour_of_points"][0], done.stdout.splitlines()[-1])
