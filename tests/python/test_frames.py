# SPDX-License-Identifier: GPL-3.0-or-later
"""Features and contacts of frames against sums that numpy makes, and against closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import balls

import teleta


def test_forces_and_centres_are_those_of_numpy():
    loads = balls(50, 6, 14).astype(np.float64)
    pitch_m = 0.0034
    table = teleta.features(loads.astype(np.float32), pitch_m=pitch_m)
    loads = loads.astype(np.float32).astype(np.float64)
    x_m = (np.arange(14) - 6.5) * pitch_m
    y_m = (np.arange(6) - 2.5) * pitch_m
    force_n = loads.sum(axis=(1, 2))
    np.testing.assert_allclose(table["force_n"], force_n, rtol=1e-15)
    np.testing.assert_allclose(table["cop_x_m"], (loads * x_m).sum(axis=(1, 2)) / force_n, rtol=1e-12, atol=1e-17)
    np.testing.assert_allclose(
        table["cop_y_m"], (loads * y_m[:, None]).sum(axis=(1, 2)) / force_n, rtol=1e-12, atol=1e-17
    )
    active = loads >= np.float32(0.2)
    np.testing.assert_array_equal(table["active"], active.sum(axis=(1, 2)))


def test_the_principal_axis_is_that_of_the_covariance_of_numpy():
    frame = np.zeros((8, 8))
    for i in range(2, 7):
        frame[i, i] = frame[i, i - 1] = 1.0
    table = teleta.features(frame, pitch_m=1.0)
    rows, columns = np.nonzero(frame)
    values, vectors = np.linalg.eigh(np.cov(columns, rows))
    np.testing.assert_allclose(table["lambda1_m2"], values[1], rtol=1e-12)
    np.testing.assert_allclose(table["lambda2_m2"], values[0], rtol=1e-12)
    angle_rad = np.arctan(vectors[1, 1] / vectors[0, 1])
    np.testing.assert_allclose(table["alpha_z_rad"], angle_rad, rtol=1e-12)


def test_an_empty_frame_has_no_centre():
    table = teleta.features(np.zeros((1, 6, 14)))
    assert table["contact_type"].tolist() == ["none"]
    assert table["force_n"][0] == 0.0
    assert np.isnan(table["cop_x_m"][0]) and np.isnan(table["lambda1_m2"][0])


def test_conditioning_is_tare_gain_sign_and_dead_taxels():
    loads = balls(20, 6, 14)
    wanted = teleta.features(loads)
    raw = 50.0 - 4.0 * loads
    table = teleta.features(raw, tare=np.full((6, 14), 50.0), gain=0.25, inverted=True)
    np.testing.assert_allclose(table["force_n"], wanted["force_n"], rtol=1e-5)
    mask = np.zeros((6, 14), dtype=bool)
    mask[3, 4] = mask[0, 2] = True
    by_mask = teleta.features(loads, dead=mask)
    by_number = teleta.features(loads, dead=[3 * 14 + 4, 2])
    np.testing.assert_array_equal(by_mask["force_n"], by_number["force_n"])
    np.testing.assert_allclose(
        by_mask["force_n"], np.where(mask, 0.0, loads.astype(float)).sum(axis=(1, 2)), rtol=1e-14
    )


@pytest.mark.parametrize("missing", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite_is_dead(missing):
    loads = balls(5, 6, 14)
    holes = loads.copy()
    holes[:, 2, 3] = missing
    zeros = loads.copy()
    zeros[:, 2, 3] = 0.0
    np.testing.assert_array_equal(
        teleta.features(holes)["force_n"], teleta.features(zeros)["force_n"]
    )


def test_gains_of_taxels_multiply_their_loads():
    loads = balls(5, 6, 14)
    gain = np.linspace(0.5, 1.5, 84).reshape(6, 14)
    table = teleta.features(loads, taxel_gains=gain)
    wanted = np.maximum(loads.astype(np.float64) * gain.astype(np.float32), 0.0).sum(axis=(1, 2))
    np.testing.assert_allclose(table["force_n"], wanted, rtol=1e-6)
    as_object = teleta.Gains(gain, gain * 0.0, np.full((6, 14), "good"))
    np.testing.assert_array_equal(
        teleta.features(loads, taxel_gains=as_object)["force_n"], table["force_n"]
    )


def test_contacts_keep_their_identity():
    loads = balls(100, 24, 48)
    table = teleta.contacts(loads, rate_hz=100.0)
    assert set(table["contact_id"]) == {1, 2}
    left = table["x_m"] < 0.0
    assert len(set(table["contact_id"][left])) == 1
    np.testing.assert_array_equal(table["time_s"], table["frame"] / 100.0)


def test_without_times_there_are_no_identities():
    table = teleta.contacts(balls(3, 24, 48))
    assert set(table["contact_id"]) == {0}
    assert np.isnan(table["time_s"]).all()


def test_labels_are_the_taxels_of_the_contacts():
    loads = balls(10, 24, 48)
    table, labels = teleta.contacts(loads, rate_hz=10.0, return_labels=True)
    assert labels.shape == loads.shape and labels.dtype == np.int32
    for frame in range(10):
        rows = np.nonzero(table["frame"] == frame)[0]
        for label, row in enumerate(rows, start=1):
            inside = labels[frame] == label
            np.testing.assert_allclose(
                table["force_n"][row], loads[frame].astype(float)[inside].sum(), rtol=1e-12
            )
            np.testing.assert_allclose(table["area_m2"][row], inside.sum() * 0.0034**2, rtol=1e-12)


def test_a_processor_does_what_the_batch_does():
    loads = balls(60, 12, 20)
    times_s = np.arange(60) / 200.0
    options = {"threshold_n": 0.3, "noise_height": 0.2}
    contacts = teleta.contacts(loads, time_s=times_s, **options)
    features = teleta.features(loads, time_s=times_s, threshold_n=0.3)
    processor = teleta.Processor(12, 20, **options)
    assert processor.settings["threshold_n"] == 0.3 and processor.settings["rows"] == 12
    for _ in range(2):
        ids = []
        for i in range(60):
            now, found = processor.process(loads[i], times_s[i])
            assert isinstance(now, teleta.Features)
            for name in features:
                value = features[name][i]
                missing = not isinstance(value, str) and np.isnan(value)
                assert getattr(now, name) == (None if missing else value), name
            ids.extend(found["contact_id"])
            at = contacts["frame"] == i
            for name in ("x_m", "y_m", "force_n", "peak_n", "area_m2"):
                np.testing.assert_array_equal(found[name], contacts[name][at])
        np.testing.assert_array_equal(ids, contacts["contact_id"])
        processor.reset()


def test_features_of_a_processor_are_frozen():
    now, _ = teleta.Processor(2, 2).process(np.ones((2, 2), dtype=np.float32), 0.0)
    with pytest.raises(AttributeError):
        now.force_n = 1.0


def test_an_even_load_gives_the_gains_that_it_had(tmp_path):
    random = np.random.default_rng(3)
    response = random.uniform(0.7, 1.3, (6, 14))
    level = np.concatenate([np.linspace(0.0, 8.0, 200), np.linspace(8.0, 0.0, 200)])
    raw = level[:, None, None] * response + random.normal(0.0, 0.01, (400, 6, 14))
    found = teleta.gains([raw, raw[::-1]])
    assert (found.state == "good").all()
    np.testing.assert_allclose(found.gain, response.mean() / response, rtol=0.01)
    found.save(tmp_path / "gains.csv")
    again = teleta.Gains.load(tmp_path / "gains.csv")
    np.testing.assert_array_equal(again.gain, found.gain)
    np.testing.assert_array_equal(again.state, found.state)


def test_gains_of_no_load_are_refused():
    with pytest.raises(teleta.RefusedError):
        teleta.gains(np.zeros((50, 2, 2)))
