# SPDX-License-Identifier: GPL-3.0-or-later
"""Stiffness and contour against closed forms and a solve of numpy."""

from __future__ import annotations

import numpy as np
import pytest

import teleta


def touch(stiffness_n_per_m: float, distance_m: float, samples: int = 2000) -> tuple[np.ndarray, ...]:
    """Joint angle and torque of a joint that presses a spring, without noise."""
    time_s = np.arange(samples) / 1000.0
    torque_nm = 0.08 * time_s / time_s[-1]
    return time_s, torque_nm / (distance_m**2 * stiffness_n_per_m), torque_nm


@pytest.mark.parametrize("method", ["regression", "two-point"])
def test_a_spring_in_series_with_the_link(method):
    link, spring = 3000.0, 900.0
    together = 1.0 / (1.0 / link + 1.0 / spring)
    found = teleta.stiffness(
        *touch(together, 0.15), contact_distance_m=0.15, link_stiffness_n_per_m=link, method=method
    )
    assert found.method == method
    assert found.total_stiffness_n_per_m == pytest.approx(together, rel=1e-9)
    assert found.object_stiffness_n_per_m == pytest.approx(spring, rel=1e-8)
    assert found.standard_linear_solid is None


def test_what_is_as_stiff_as_the_link_has_only_a_bound():
    found = teleta.stiffness(*touch(3000.0, 0.15), contact_distance_m=0.15, link_stiffness_n_per_m=3000.0)
    assert found.object_stiffness_n_per_m is None
    assert found.object_stiffness_lower_95 > 3000.0
    assert found.object_stiffness_upper_95 is None


@pytest.mark.parametrize(
    "options, text",
    [
        ({"contact_distance_m": 0.0}, "contact_distance_m"),
        ({"contact_distance_m": 0.1, "window_nm": (0.05, 0.02)}, "window_nm"),
        ({"contact_distance_m": 0.1, "method": "guess"}, "method"),
        ({"contact_distance_m": 0.1, "link_stiffness_n_per_m": -1.0}, "link_stiffness_n_per_m"),
        ({"contact_distance_m": 0.1, "link_half_thickness_m": -1.0}, "link_half_thickness_m"),
    ],
)
def test_settings_out_of_range_are_named(options, text):
    with pytest.raises(ValueError, match=text):
        teleta.stiffness(*touch(800.0, 0.1), **options)


def test_columns_of_different_length_are_refused():
    time_s, angle_rad, torque_nm = touch(800.0, 0.1)
    with pytest.raises(ValueError, match=r"joint_torque_nm: expected \(2000,\), got \(5,\)"):
        teleta.stiffness(time_s, angle_rad, torque_nm[:5], contact_distance_m=0.1)


def test_the_closed_spline_is_that_of_a_solve_of_numpy():
    random = np.random.default_rng(2)
    angle_rad = np.sort(random.uniform(0.0, 2.0 * np.pi, 12))
    points_m = np.column_stack([0.04 * np.cos(angle_rad), 0.03 * np.sin(angle_rad)])
    n = len(points_m)
    matrix = 4.0 * np.eye(n) + np.roll(np.eye(n), 1, axis=1) + np.roll(np.eye(n), -1, axis=1)
    control = np.linalg.solve(matrix / 6.0, points_m)
    basis = np.array([[-1, 3, -3, 1], [3, -6, 3, 0], [-3, 0, 3, 0], [1, 4, 1, 0]]) / 6.0
    curve = teleta.contour(points_m, closed=True, samples=12 * 7 + 1).curve
    for sample in range(12 * 7):
        segment, u = divmod(sample, 7)
        near = control[[(segment + k - 1) % n for k in range(4)]]
        place_m = np.array([(u / 7.0) ** k for k in (3, 2, 1, 0)]) @ basis @ near
        np.testing.assert_allclose([curve["x_m"][sample], curve["y_m"][sample]], place_m, atol=1e-15)
    assert curve["t"][0] == 0.0 and curve["t"][-1] == 1.0


def test_the_curvature_of_a_circle_is_one_over_its_radius():
    angle_rad = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    found = teleta.contour(0.05 * np.column_stack([np.cos(angle_rad), np.sin(angle_rad)]), closed=True)
    np.testing.assert_allclose(found.curve["curvature_per_m"], 20.0, rtol=1e-3)
    assert found.length_m == pytest.approx(0.1 * np.pi, rel=1e-5)
    assert found.circle.radius == pytest.approx(0.05, rel=1e-9)


def test_corners_of_a_rectangle_are_found():
    corners_m = np.array([[0.0, 0.0], [0.08, 0.0], [0.08, 0.05], [0.0, 0.05]])
    points_m = np.concatenate(
        [
            start + (end - start) * np.linspace(0.0, 1.0, 8, endpoint=False)[:, None]
            for start, end in zip(corners_m, np.roll(corners_m, -1, axis=0))
        ]
    )
    found = teleta.contour(points_m, closed=True)
    assert found.shape == "rectangle" and found.vertices.shape == (4, 2)
    for corner_m in corners_m:
        assert np.linalg.norm(found.vertices - corner_m, axis=1).min() < 1e-6


def test_no_points_and_infinite_ones_are_refused():
    with pytest.raises(teleta.BadInputError, match="no points"):
        teleta.contour(np.zeros((0, 2)))
    with pytest.raises(teleta.BadInputError, match="not finite"):
        teleta.contour([[0.0, np.inf], [1.0, 1.0]])
    with pytest.raises(ValueError, match=r"points_m: expected \(n, 2\), got \(3, 3\)"):
        teleta.contour(np.zeros((3, 3)))
    with pytest.raises(ValueError, match="samples"):
        teleta.contour(np.zeros((3, 2)), samples=1)
