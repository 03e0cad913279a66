# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns: what is commanded, what is predicted, files and laws."""

from __future__ import annotations


import numpy as np
import pytest

import teleta


def ramp() -> teleta.Pattern:
    intensities = np.zeros((3, 6))
    intensities[:, 0] = [0.0, 1.0, 0.5]
    intensities[:, 3] = 0.25
    return teleta.Pattern.from_samples([0.0, 1.0, 2.0], intensities, id="ramp", name="Ramp")


def test_samples_have_straight_lines_between_them():
    pattern = ramp()
    assert (pattern.id, pattern.name, pattern.duration_s) == ("ramp", "Ramp", 2.0)
    values = pattern.evaluate([-1.0, 0.5, 1.0, 1.5, 2.0, np.nan])
    np.testing.assert_allclose(values[:, 0], [0.0, 0.5, 1.0, 0.75, 0.0, 0.0])
    np.testing.assert_allclose(values[:, 3], [0.0, 0.25, 0.25, 0.25, 0.0, 0.0])
    assert values.shape == (6, 6) and not values[:, [1, 2, 4, 5]].any()


def test_a_step_is_followed_with_the_lag_of_the_motor():
    on = np.ones((2, 6))
    step = teleta.Pattern.from_samples([0.0, 1.0], on)
    times_s = np.array([0.0, 0.055, 0.2, 1.0, 1.075, 1.5])
    predicted = step.predicted(times_s)
    # From rest to 90 % of the speed in 55 ms, and down to 10 % of it in 75 ms; a third of the full drive is
    # needed to start, so that speed shares s are intensities (s - 1/3) / (2/3).
    speeds = np.array([0.0, 0.9, 1.0 - 10.0 ** (-0.2 / 0.055), 1.0, 0.1, 10.0 ** (-0.5 / 0.075)])
    wanted = np.clip((speeds - 1.0 / 3.0) / (2.0 / 3.0), 0.0, 1.0)
    np.testing.assert_allclose(predicted[:, 0], wanted, atol=2e-3)


def test_a_pattern_survives_its_own_format(tmp_path):
    ramp().save(tmp_path / "ramp.json")
    again = teleta.pattern(tmp_path / "ramp.json")
    times_s = np.linspace(0.0, 2.0, 50)
    np.testing.assert_array_equal(again.evaluate(times_s), ramp().evaluate(times_s))
    assert again.name == "Ramp"


def test_wav_has_six_channels_of_the_intensities(tmp_path):
    ramp().save(tmp_path / "ramp.wav", rate_hz=1000.0)
    data = (tmp_path / "ramp.wav").read_bytes()
    samples = np.frombuffer(data[data.index(b"data") + 8 :], dtype="<i2").reshape(-1, 6)
    assert len(samples) == 2000
    wanted = ramp().evaluate(np.arange(2000) / 1000.0) * 32767
    np.testing.assert_allclose(samples, wanted, atol=0.51)


def test_laws_that_are_broken_are_told():
    short = np.zeros((4, 6))
    short[1:3, 0] = 1.0
    blip = teleta.Pattern.from_samples([0.0, 0.5, 0.51, 1.0], short[[0, 1, 2, 3]] * [1, 0, 0, 0, 0, 0])
    steps = teleta.Pattern.from_samples(
        [0.0, 0.5, 0.5, 0.51, 0.51, 1.0], np.array([0, 0, 1, 1, 0, 0])[:, None] * np.eye(6)[0]
    )
    assert isinstance(blip.check(), list)
    found = steps.check()
    assert found and found[0].law == "burst-too-short" and found[0].tactors == (1,)
    assert found[0].value == pytest.approx(0.01) and found[0].begin_s == pytest.approx(0.5)


@pytest.mark.parametrize(
    "times_s, intensities, text",
    [
        ([0.0, 1.0], np.zeros((2, 5)), r"intensities: expected \(2, 6\)"),
        ([0.0, 1.0], np.full((2, 6), 1.5), "intensities: expected 0 to 1"),
        ([1.0, 0.0], np.zeros((2, 6)), "times_s: expected times"),
        ([0.0], np.zeros((1, 6)), "times_s: expected 2"),
    ],
)
def test_samples_out_of_range_are_named(times_s, intensities, text):
    with pytest.raises(ValueError, match=text):
        teleta.Pattern.from_samples(times_s, intensities)


def test_an_unknown_ending_is_refused_with_the_known_ones(tmp_path):
    with pytest.raises(ValueError, match=".hjif"):
        ramp().save(tmp_path / "ramp.mp3")
    with pytest.raises(ValueError, match="rate_hz"):
        ramp().save(tmp_path / "ramp.json", rate_hz=100.0)
    assert list(tmp_path.iterdir()) == []


def test_a_bad_file_of_motors_is_named(tmp_path):
    (tmp_path / "motors.toml").write_text("format = 'other'\n")
    with pytest.raises(teleta.BadInputError) as caught:
        ramp().predicted([0.0], motors=tmp_path / "motors.toml")
    assert caught.value.line == 1
