# SPDX-License-Identifier: GPL-3.0-or-later
"""The same input through the program and through the module: every number is the same double."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import assert_same, read_csv

import teleta

FEATURES = [
    "time_s",
    "contact_type",
    "force_n",
    "cop_x_m",
    "cop_y_m",
    "coc_x_m",
    "coc_y_m",
    "dzmp_x_m",
    "dzmp_y_m",
    "alpha_z_rad",
    "lambda1_m2",
    "lambda2_m2",
    "active",
]


@pytest.mark.parametrize(
    "flags, options",
    [
        ([], {}),
        (["--threshold", "0.3", "--weighted"], {"threshold_n": 0.3, "orientation": "weighted"}),
        (
            ["--auto-threshold", "--active-only", "--dead", "3,17", "--gain", "2"],
            {"automatic_threshold": True, "moment_range": "active", "dead": [3, 17], "gain": 2.0},
        ),
    ],
)
def test_features(program, indenter, frames, flags, options):
    printed = read_csv(program("features", indenter / "frames.csv", *flags))
    table = teleta.features(frames.values, time_s=frames.time_s, **options)
    assert list(table) == FEATURES == list(printed)
    assert_same(table, printed, FEATURES)


@pytest.mark.parametrize(
    "flags, options",
    [
        ([], {}),
        (["--noise-height", "0.1", "--min-taxels", "3"], {"noise_height": 0.1, "minimum_taxels": 3}),
        (["--auto-threshold", "--pitch-mm", "5"], {"automatic_threshold": True, "pitch_m": 0.005}),
    ],
)
def test_contacts(program, indenter, frames, flags, options):
    printed = read_csv(program("contacts", indenter / "frames.csv", *flags))
    table = teleta.contacts(frames.values, time_s=frames.time_s, **options)
    assert list(table)[1:] == list(printed)
    assert_same(table, printed, list(printed))
    np.testing.assert_array_equal(frames.time_s[table["frame"]], table["time_s"])


@pytest.mark.parametrize("noise", [None, 0.02])
def test_summit(program, indenter, frames, noise):
    flags = ["--summit"] + ([] if noise is None else ["--noise-sd", str(noise)])
    for command, function in (("features", teleta.features), ("contacts", teleta.contacts)):
        printed = read_csv(program(command, indenter / "frames.csv", *flags))
        table = function(frames.values, time_s=frames.time_s, summit=True, noise_n=noise)
        assert list(printed)[-4:] == ["summit_x_m", "summit_y_m", "summit_x_se_m", "summit_y_se_m"]
        assert_same(table, printed, list(printed))
        assert np.isfinite(table["summit_x_m"]).any()
        assert np.isfinite(table["summit_x_se_m"]).any() == (noise is not None)


def test_summit_of_a_strip():
    # An even pressure of 4 N a taxel from 1.75 to 4.5 taxels, and one that covers the end.
    frames = np.array([[[0, 0, 3, 4, 4, 0, 0]], [[4, 1, 0, 0, 0, 0, 0]]], dtype=np.float32)
    table = teleta.features(frames, pitch_m=0.01, summit=True)
    np.testing.assert_allclose(table["summit_x_m"], [0.01 * (0.5 * (1.75 + 4.5) - 3), np.nan], atol=1e-9)
    with pytest.raises(ValueError, match="noise_n"):
        teleta.features(frames, summit=True, noise_n=0.0)


def test_gains(program, tmp_path):
    program("simulate", "tactile-even-load", "--out", tmp_path)
    program("gains", tmp_path / "frames.csv", "--out", tmp_path / "gains.csv")
    printed = read_csv(tmp_path / "gains.csv")
    frames = teleta.read_frames(tmp_path / "frames.csv")
    found = teleta.gains(frames.values)
    table = {"gain": found.gain.ravel(), "gain_se": found.gain_se.ravel(), "state": found.state.ravel()}
    assert_same(table, printed, ["gain", "gain_se", "state"])
    document = json.loads(program("gains", tmp_path / "frames.csv", "--json"))
    for name in ("presses", "frames", "level", "scatter", "repeatability", "tilt_x", "tilt_y", "tilted"):
        assert getattr(found, name) == document[name], name
    found.save(tmp_path / "own.csv")
    assert (tmp_path / "own.csv").read_bytes() == (tmp_path / "gains.csv").read_bytes()
    loaded = teleta.Gains.load(tmp_path / "gains.csv")
    printed = read_csv(program("features", tmp_path / "frames.csv", "--gains", tmp_path / "gains.csv"))
    table = teleta.features(frames.values, time_s=frames.time_s, taxel_gains=loaded)
    assert_same(table, printed, FEATURES)


@pytest.fixture(scope="module")
def touch_log(tmp_path_factory):
    from conftest import run_program

    folder = tmp_path_factory.mktemp("touch")
    run_program("simulate", "teleta-touch", "--duration", 8, "--out", folder)
    joints = read_csv(folder / "joints.csv")
    names = list(joints)
    columns = [np.array(joints[names[i]], dtype=float) for i in (0, 4, 8)]
    path = folder / "touch.csv"
    rows = zip(*(joints[names[i]] for i in (0, 4, 8)))
    path.write_text(
        "time_s,joint_angle_rad,joint_torque_nm\n" + "".join(",".join(row) + "\n" for row in rows)
    )
    return path, columns


@pytest.mark.parametrize("method", ["regression", "two-point"])
def test_stiffness(program, touch_log, method):
    path, columns = touch_log
    document = json.loads(
        program("stiffness", path, "--contact-distance", "0.1695", "--method", method, "--json")
    )
    found = teleta.stiffness(*columns, contact_distance_m=0.1695, method=method)
    for name, value in document.items():
        own = getattr(found, name)
        if name == "warnings":
            assert list(own) == value
        elif name == "error_budget":
            assert [{"source": source, "share": share} for source, share in own] == value
        elif name == "standard_linear_solid" and value is not None:
            for part, interval in value.items():
                assert vars(getattr(own, part)) == interval
        else:
            assert own == value, name
    assert {field for field in vars(found)} == set(document)


@pytest.mark.parametrize("flags, options", [([], {}), (["--spline", "interpolating"], {"spline": "interpolating"})])
def test_contour(program, tmp_path, flags, options):
    program("simulate", "teleta-contour-triangle", "--out", tmp_path)
    points = read_csv(tmp_path / "contour.csv")
    points_m = np.column_stack([np.array(points[name], dtype=float) for name in ("x_m", "y_m")])
    curve_path = tmp_path / "curve.csv"
    document = json.loads(
        program("contour", tmp_path / "contour.csv", "--closed", "--curve", curve_path, "--json", *flags)
    )
    found = teleta.contour(points_m, closed=True, **{"spline": "approximating", **options})
    assert_same(found.curve, read_csv(curve_path), ["t", "x_m", "y_m", "curvature_per_m"])
    for name, value in document.items():
        own = getattr(found, name)
        if name == "vertices":
            np.testing.assert_array_equal(own, np.reshape(value, (-1, 2)))
        elif name == "candidates":
            assert list(own) == value
        elif name == "circle":
            assert (vars(own) if own else None) == value
        else:
            assert own == value, name
    assert set(vars(found)) == {*document, "curve"}


def test_patterns(program, tmp_path):
    listed = json.loads(program("pattern", "list", "--json"))
    table = teleta.patterns()
    assert list(table) == list(listed[0])
    for name, column in table.items():
        assert column.tolist() == [row[name] for row in listed]
    for name in ("shape.A.dynamic", "stiffness.E.dynamic", "shape.D.static"):
        pattern = teleta.pattern(name)
        rendered = read_csv(program("pattern", "render", name, "--rate", 200))
        times_s = np.array(rendered["time_s"], dtype=float)
        motors = [f"t{i}" for i in range(1, 7)]
        own = pattern.evaluate(times_s)
        assert_same(dict(zip(motors, own.T)), rendered, motors)
        predicted = read_csv(program("pattern", "render", name, "--rate", 200, "--predicted"))
        assert_same(dict(zip(motors, pattern.predicted(times_s).T)), predicted, motors)
        for ending in (".json", ".hjif", ".tact", ".csv", ".wav"):
            program("pattern", "convert", name, tmp_path / ("program" + ending))
            pattern.save(tmp_path / ("own" + ending))
            first, second = ((tmp_path / (who + ending)).read_bytes() for who in ("program", "own"))
            assert first == second, ending
        document = json.loads(program("pattern", "check", name, "--json"))
        findings = [{**vars(found), "tactors": list(found.tactors)} for found in pattern.check()]
        assert findings == document["findings"]


def test_study(program, tmp_path):
    program("study", "rehearse", "--participants", 4, "--seed", 3, "--out", tmp_path / "study")
    program("study", "analyze", tmp_path / "study", "--out", tmp_path / "program")
    results = teleta.study.analyze(tmp_path / "study", out=tmp_path / "own")
    for table, name in (
        (results.summary, "summary"),
        (results.group, "group"),
        (results.confusion, "confusion_long"),
        (results.anova, "anova"),
    ):
        printed = read_csv(tmp_path / "program" / (name + ".csv"))
        assert list(table) == list(printed)
        assert_same(table, printed, list(printed))
        first, second = ((tmp_path / who / (name + ".csv")).read_bytes() for who in ("program", "own"))
        assert first == second
    for name in ("report.html", "analysis.R"):
        assert (tmp_path / "own" / name).stat().st_size > 0


def test_camera(program, tmp_path):
    program("simulate", "vtacarm-calibration", "--duration", 60, "--out", tmp_path)
    pairs = read_csv(tmp_path / "pairs.csv")
    pixels_px = np.column_stack([np.array(pairs[name], dtype=float) for name in ("u_px", "v_px")])
    points_m = np.column_stack([np.array(pairs[name], dtype=float) for name in ("x_m", "y_m", "z_m")])
    document = json.loads(
        program(
            "calibrate",
            tmp_path / "pairs.csv",
            "--out",
            tmp_path / "camera.json",
            "--residuals",
            tmp_path / "residuals.csv",
            "--json",
        )
    )
    found = teleta.calibrate(pixels_px, points_m)
    for name in ("rms_px", "mean_px", "valid_radius_px"):
        assert getattr(found, name) == document[name], name
    assert 1e3 * found.mean_m == document["mean_mm"]
    assert 1e3 * found.uncertainty_m == document["uncertainty_mm"]
    assert list(found.warnings) == document["warnings"]
    residuals = read_csv(tmp_path / "residuals.csv")
    assert found.kept.dtype == bool and found.kept.sum() == document["kept"]
    table = {"kept": found.kept.astype(int), "du_px": found.residual_px[:, 0], "dv_px": found.residual_px[:, 1]}
    assert_same(table, residuals, list(table))
    found.camera.save(tmp_path / "own.json")
    assert (tmp_path / "own.json").read_bytes() == (tmp_path / "camera.json").read_bytes()
    printed = read_csv(program("locate", tmp_path / "camera.json", tmp_path / "pairs.csv"))
    located_m, sd_m = teleta.Camera.load(tmp_path / "camera.json").locate(pixels_px)
    table = {"x_m": located_m[:, 0], "y_m": located_m[:, 1], "z_m": located_m[:, 2], "sd_m": sd_m}
    assert_same(table, printed, list(table))


def test_simulation(program, tmp_path):
    program("simulate", "teleta-touch", "--duration", 3, "--seed", 5, "--out", tmp_path / "program")
    summary = teleta.simulate("teleta-touch", seed=5, duration_s=3.0, out=tmp_path / "own")
    printed = json.loads((tmp_path / "program" / "summary.json").read_text())
    for name in ("scene", "seed", "simulated_s", "measures", "events"):
        assert summary[name] == printed[name], name
    files = {path.name for path in (tmp_path / "program").iterdir()}
    assert {path.name for path in (tmp_path / "own").iterdir()} == files
    for name in files - {"summary.json", "recording.teleta"}:
        assert (tmp_path / "own" / name).read_bytes() == (tmp_path / "program" / name).read_bytes(), name


def test_export(program, indenter, tmp_path):
    program("export", indenter / "recording.teleta", "--csv", tmp_path / "program")
    with teleta.open(indenter / "recording.teleta") as recording:
        paths = recording.to_csv(tmp_path / "own")
        assert sorted(paths) == sorted(str(path) for path in (tmp_path / "own").iterdir())
        assert (tmp_path / "own" / "recording.json").exists()
        with pytest.raises(teleta.RefusedError):
            recording.to_csv(tmp_path / "own")
        recording.to_csv(tmp_path / "own", overwrite=True)
    for path in (tmp_path / "program").glob("*.csv"):
        assert (tmp_path / "own" / path.name).read_bytes() == path.read_bytes()
