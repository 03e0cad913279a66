# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera in the soft tube: points, pixels, contacts."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import read_csv, run_program

import teleta


@pytest.fixture(scope="module")
def calibrated(tmp_path_factory):
    folder = tmp_path_factory.mktemp("calibration")
    run_program("simulate", "vtacarm-calibration", "--duration", 200, "--out", folder)
    pairs = {name: np.array(column, dtype=float) for name, column in read_csv(folder / "pairs.csv").items()}
    pixels_px = np.column_stack([pairs["u_px"], pairs["v_px"]])
    points_m = np.column_stack([pairs["x_m"], pairs["y_m"], pairs["z_m"]])
    return pixels_px, points_m, teleta.calibrate(pixels_px, points_m)


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pictures")
    run_program("simulate", "vtacarm-multicontact", "--duration", 3, "--out", folder)
    with teleta.open(folder / "recording.teleta") as recording:
        name = "camera"
        data = recording.read(name)
        details = recording.streams[name].details
    return data, details, folder


def test_points_of_the_surface_are_located_where_they_are(calibrated):
    pixels_px, points_m, found = calibrated
    located_m, sd_m = found.camera.locate(pixels_px[found.kept])
    off_m = np.linalg.norm(located_m - points_m[found.kept], axis=1)
    assert np.nanmean(off_m) < 0.001
    assert (sd_m[np.isfinite(sd_m)] > 0.0).all()
    # On the cylinder.
    np.testing.assert_allclose(np.hypot(located_m[:, 0], located_m[:, 1])[np.isfinite(off_m)], 0.025, rtol=1e-9)


def test_projecting_what_was_located_gives_the_pixel(calibrated):
    pixels_px, _, found = calibrated
    located_m, _, why = found.camera.locate(pixels_px, why=True)
    hit = why == ""
    assert hit.any()
    np.testing.assert_allclose(found.camera.project(located_m[hit]), pixels_px[hit], atol=1e-6)
    assert np.isnan(located_m[~hit]).all()


def test_what_is_not_in_the_image_is_nan(calibrated):
    _, _, found = calibrated
    pixels = found.camera.project([[0.0, 0.0, -5.0], [np.nan, 0.0, 0.0]])
    assert np.isnan(pixels).all()
    points_m, sd_m, why = found.camera.locate([np.nan, 0.0], why=True)
    assert np.isnan(points_m).all() and np.isnan(sd_m).all() and why.tolist() == ["notFinite"]
    assert (found.camera.width_px, found.camera.height_px) == (1640, 1232)


def test_wrong_pairs_are_left_out(calibrated):
    pixels_px, points_m, found = calibrated
    wrong = pixels_px.copy()
    wrong[::17] += 60.0
    robust = teleta.calibrate(wrong, points_m)
    assert not robust.kept[::17].any()
    assert robust.rms_px < 2.0 * found.rms_px + 0.1


def test_pairs_that_are_not_enough_are_refused(calibrated):
    pixels_px, points_m, _ = calibrated
    with pytest.raises(teleta.RefusedError):
        teleta.calibrate(pixels_px[:4], points_m[:4])
    with pytest.raises(ValueError, match=r"points_m: expected \(\d+, 3\)"):
        teleta.calibrate(pixels_px, points_m[:4])
    with pytest.raises(ValueError, match="method"):
        teleta.calibrate(pixels_px, points_m, method="other")


def camera_of(details, folder):
    import json

    path = folder / "camera.json"
    path.write_text(json.dumps(details["camera"]))
    return teleta.Camera.load(path)


def test_contacts_of_pictures_are_those_of_the_program(pictures, program, tmp_path):
    data, details, folder = pictures
    camera = camera_of(details, folder)
    rate_hz = 1.0 / np.diff(data.source_time_s).mean()
    table = teleta.track(data.values, camera, rate_hz=float(rate_hz))
    assert len(table["frame"]) > 0 and "begin" in table["event"]
    # The same pictures as files, through both.
    cv2 = pytest.importorskip("cv2", reason="python3-opencv writes the pictures")
    for i, picture in enumerate(data.values):
        cv2.imwrite(str(tmp_path / f"frame_{i:04d}.png"), picture)
    source = tmp_path / "frame_%04d.png"
    printed = read_csv(program("track", source, "--camera", folder / "camera.json"))
    own = teleta.track(source, camera)
    from conftest import assert_same

    assert list(own) == list(printed)
    assert_same(own, printed, list(printed))


def test_a_tracker_gives_a_table_a_picture(pictures):
    data, details, folder = pictures
    tracker = teleta.CameraTracker(camera_of(details, folder))
    tables = list(tracker.frames(data.values[:10], rate_hz=40.0))
    assert len(tables) == 10
    assert {len(column) for column in tables[0].values()} == {0}
    with pytest.raises(ValueError, match="rate_hz"):
        next(tracker.frames(data.values))
    with pytest.raises(ValueError, match="preset"):
        teleta.CameraTracker(camera_of(details, folder), preset="none")
    with pytest.raises(TypeError, match="uint8"):
        next(teleta.CameraTracker(camera_of(details, folder)).frames(data.values.astype(float), 40.0))


def test_pictures_that_cannot_be_used_are_counted(pictures):
    data, details, folder = pictures
    spoiled = list(data.values[:5]) + [np.zeros_like(data.values[0])[:10, :10]]
    with pytest.warns(UserWarning, match="1 of 6 pictures could not be used"):
        teleta.track(spoiled, camera_of(details, folder), rate_hz=40.0)


def test_a_file_that_is_no_video_is_refused(calibrated, tmp_path):
    path = tmp_path / "film.avi"
    path.write_text("nothing")
    with pytest.raises(teleta.BadInputError):
        teleta.track(path, calibrated[2].camera)
    with pytest.raises(teleta.NotFoundError):
        teleta.track(tmp_path / "nowhere.avi", calibrated[2].camera)


def test_scenes_that_do_not_exist_are_not_found():
    with pytest.raises(teleta.NotFoundError):
        teleta.simulate("no-such-scene")
    with pytest.raises(ValueError, match="duration_s"):
        teleta.simulate("tactile-indenter", duration_s=-1.0)
