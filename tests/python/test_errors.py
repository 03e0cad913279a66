# SPDX-License-Identifier: GPL-3.0-or-later
"""Every exception: its class, its place among the built-in ones, its fields and its text."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import teleta

FRAME = np.zeros((6, 14))


@pytest.mark.parametrize(
    "name, builtin, kind",
    [
        ("BadInputError", ValueError, "bad_input"),
        ("NotFoundError", FileNotFoundError, "not_found"),
        ("IoFailedError", OSError, "io_failed"),
        ("RefusedError", ValueError, "refused"),
        ("UnavailableError", ConnectionError, "unavailable"),
    ],
)
def test_each_class_is_also_a_built_in_one(name, builtin, kind):
    cls = getattr(teleta, name)
    assert issubclass(cls, teleta.Error) and issubclass(cls, builtin)
    error = cls("it broke", "a.csv", 3, 4, "a number")
    assert (error.message, error.kind, error.file) == ("it broke", kind, "a.csv")
    assert (error.line, error.column, error.expected) == (3, 4, "a number")
    assert str(error) == "a.csv:3:4: it broke (expected a number)"
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is cls and vars(again) == vars(error)


def test_a_bad_file_is_named_with_its_place(tmp_path):
    path = tmp_path / "frames.csv"
    path.write_text("time_s,t0,t1\n0.0,1,2\n0.1,1,x\n")
    with pytest.raises(teleta.BadInputError) as caught:
        teleta.read_frames(path, rows=1, columns=2)
    error = caught.value
    assert (error.file, error.line, error.column) == (str(path), 3, 7)
    assert error.expected is not None


def test_a_missing_file_is_not_found(tmp_path):
    for read in (teleta.open, teleta.read_frames, teleta.Camera.load, teleta.Gains.load):
        with pytest.raises(FileNotFoundError) as caught:
            read(tmp_path / "nowhere")
        assert isinstance(caught.value, teleta.NotFoundError)
        assert caught.value.file == str(tmp_path / "nowhere")


def test_a_folder_that_cannot_be_written_to_fails():
    with pytest.raises(OSError) as caught:
        teleta.pattern("shape.A.static").save("/proc/nowhere/a.json")
    assert isinstance(caught.value, teleta.IoFailedError)


def test_what_cannot_be_answered_is_refused():
    with pytest.raises(teleta.RefusedError, match="torque"):
        teleta.stiffness([0.0, 1.0], [0.0, 0.1], [0.0, 0.0], contact_distance_m=0.1)


def test_unknown_names_are_told_the_ones_that_exist(indenter):
    with pytest.raises(KeyError, match="shape.A.static"):
        teleta.pattern("no.such.pattern")
    with teleta.open(indenter / "recording.teleta") as recording:
        name = next(iter(recording.streams))
        with pytest.raises(KeyError, match=name):
            recording.read("no such stream")


@pytest.mark.parametrize(
    "options, text",
    [
        ({"pitch_m": 0.0}, "pitch_m: expected a finite number above 0, got 0.0"),
        ({"threshold_n": -1.0}, "threshold_n: expected a finite number above 0, got -1.0"),
        ({"gain": 0.0}, "gain: expected a finite number other than 0"),
        ({"orientation": "round"}, "orientation: expected 'binarised' or 'weighted', got 'round'"),
        ({"tare": np.zeros((2, 3))}, r"tare: expected \(6, 14\), got \(2, 3\)"),
        ({"dead": [84]}, "dead: expected"),
        ({"time_s": [0.0, 1.0]}, r"time_s: expected \(1,\), got \(2,\)"),
        ({"time_s": [np.nan]}, "time_s: expected finite times"),
    ],
)
def test_a_wrong_value_names_its_parameter(options, text):
    with pytest.raises(ValueError, match=text):
        teleta.features(FRAME, **options)


def test_a_wrong_type_is_a_type_error():
    with pytest.raises(TypeError, match="pitch_m|incompatible"):
        teleta.features(FRAME, pitch_m="wide")
    with pytest.raises(TypeError, match="gain: expected a number"):
        teleta.features(FRAME, gain="much")
    with pytest.raises(TypeError):
        teleta.features(object())


def test_times_that_go_back_are_refused():
    with pytest.raises(ValueError, match="do not decrease"):
        teleta.contacts(np.zeros((2, 6, 14)), time_s=[1.0, 0.5])
    processor = teleta.Processor(6, 14)
    processor.process(FRAME, 1.0)
    with pytest.raises(ValueError, match="do not decrease"):
        processor.process(FRAME, 0.5)
    with pytest.raises(ValueError, match=r"frame: expected \(6, 14\), got \(14, 6\)"):
        processor.process(FRAME.T, 2.0)
