# SPDX-License-Identifier: GPL-3.0-or-later
"""Touched objects: stiffness and contour."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from . import _core

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._types import Floats, Table


@dataclass(frozen=True)
class Interval95:
    """A number with the ends of its 95 % interval."""

    value: float
    lower_95: float
    upper_95: float


@dataclass(frozen=True)
class StandardLinearSolid:
    """What a touch with a hold says of an object whose force decays.

    Attributes
    ----------
    static_stiffness_n_per_m : Interval95
        What remains when the force has decayed, N/m.
    ratio : Interval95
        Of the decaying spring to the static one.
    relaxation_s : Interval95
        Time constant of the decay, s.
    """

    static_stiffness_n_per_m: Interval95
    ratio: Interval95
    relaxation_s: Interval95


@dataclass(frozen=True)
class Stiffness:
    """Stiffness of a touched object; the keys of `teleta stiffness --json`.

    Attributes
    ----------
    method : str
        'regression' or 'two-point'.
    samples : int
        Samples that the answer is based on.
    delta_theta_rad, delta_torque_nm : float
        Rotation, rad, and rise of the torque, Nm, over them.
    total_stiffness_n_per_m, total_stiffness_se : float or None
        Of object and link in series, and its standard error, N/m.
    object_stiffness_n_per_m : float or None
        Of the object, N/m; None where it cannot be told from rigid.
    object_stiffness_lower_95, object_stiffness_upper_95 : float or None
        Ends of its 95 % interval, N/m; only the lower one where it may be rigid.
    material : str or None
        'sponge', 'rubber_sponge', 'rubber', 'wood' or 'metal'; None where it cannot be told.
    safe : bool or None
        Whether a collision with it is harmless.
    level : int or None
        1 (softest) to 5.
    reliable : bool
        False: what the samples show is no spring, or too coarse.
    warnings : tuple of str
        What was seen, such as 'correlated_noise'.
    error_budget : tuple of (str, float)
        Sources of the error and their shares.
    effective_samples : float
        Independent samples among them.
    torque_reference_nm, torque_drift_nm_per_s : float
        Torque of the free joint and its change, which were taken off.
    tangent_stiffness_n_per_m, secant_stiffness_n_per_m : float or None
        At the upper end of the window and across it, where the line bends, N/m.
    standard_linear_solid : StandardLinearSolid or None
        Where the force depends on the rate and the log has a hold.
    """

    method: str
    samples: int
    delta_theta_rad: float
    delta_torque_nm: float
    total_stiffness_n_per_m: float | None
    total_stiffness_se: float | None
    object_stiffness_n_per_m: float | None
    object_stiffness_lower_95: float | None
    object_stiffness_upper_95: float | None
    material: str | None
    safe: bool | None
    level: int | None
    reliable: bool
    warnings: tuple[str, ...]
    error_budget: tuple[tuple[str, float], ...]
    effective_samples: float
    torque_reference_nm: float
    torque_drift_nm_per_s: float
    tangent_stiffness_n_per_m: float | None
    secant_stiffness_n_per_m: float | None
    standard_linear_solid: StandardLinearSolid | None


@dataclass(frozen=True)
class Circle:
    """A circle: centre (x, y), radius and root mean square distance of the points from it, all m."""

    x: float
    y: float
    radius: float
    rms: float


@dataclass(frozen=True)
class Contour:
    """What a series of points of contact looks like; the keys of `teleta contour --json`, and the curve.

    Attributes
    ----------
    points : int
        How many points there are.
    shape : str
        'circle', 'rectangle', 'triangle', 'arc', 'line', 'point' or 'unknown'.
    confidence : float
        Probability of the shape, 0 to 1.
    candidates : tuple of str
        The shapes that come into question, the most probable one first.
    probabilities : dict of str to float
        Of each shape.
    closed : bool
        Whether the curve returns to its start.
    length_m : float
        Length of the curve, m.
    vertices : ndarray of float64, (n, 2)
        Corners, or the ends of a line, m.
    circle : Circle or None
        Of a circle or an arc.
    max_curvature_per_m : float
        Largest magnitude of the curvature, 1/m.
    curve : dict of str to ndarray
        The spline, a row a sample: t (0 to 1), x_m, y_m, curvature_per_m (float64).
    """

    points: int
    shape: str
    confidence: float
    candidates: tuple[str, ...]
    probabilities: dict[str, float]
    closed: bool
    length_m: float
    vertices: Floats
    circle: Circle | None
    max_curvature_per_m: float
    curve: Table


def stiffness(
    time_s: npt.ArrayLike,
    joint_angle_rad: npt.ArrayLike,
    joint_torque_nm: npt.ArrayLike,
    *,
    contact_distance_m: float,
    contact_distance_se_m: float | None = None,
    link_half_thickness_m: float = 0.0,
    link_stiffness_n_per_m: float | None = None,
    link_stiffness_se_n_per_m: float = 0.0,
    torque_reference_nm: float | None = None,
    method: Literal["regression", "two-point"] = "regression",
    window_nm: tuple[float, float] = (0.02, 0.05),
) -> Stiffness:
    """Estimate stiffness and material of an object from joint angle and torque during a touch.

    Parameters
    ----------
    time_s : array_like, (n,)
        Times of the samples, s, in any order.
    joint_angle_rad, joint_torque_nm : array_like, (n,)
        Angle, rad, and torque, Nm, of the joint that presses.
    contact_distance_m : float
        Distance of the contact from the joint's axis along the link, m.
    contact_distance_se_m : float, optional
        Its standard error, m. None: 0.05 % of the distance.
    link_half_thickness_m : float
        Half the thickness of the link, m; it cancels out of the stiffness.
    link_stiffness_n_per_m : float, optional
        The link's own stiffness, N/m. None: that of the published arm.
    link_stiffness_se_n_per_m : float
        Its standard error, N/m.
    torque_reference_nm : float, optional
        Torque of the joint without the touch, Nm. None: that of the free motion before the touch.
    method : {'regression', 'two-point'}
        All samples in the window, or those nearest to its ends.
    window_nm : (float, float)
        Torques between which the touch is evaluated, Nm.

    Returns
    -------
    Stiffness
        None where the samples do not determine a value.

    Raises
    ------
    RefusedError
        The log yields no stiffness; the text says why.
    ValueError
        A shape or a value does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> torque_nm = np.linspace(0.0, 0.06, 600)
    >>> angle_rad = torque_nm / (0.17**2 * 800.0)
    >>> touch = stiffness(np.arange(600) / 1000.0, angle_rad, torque_nm, contact_distance_m=0.17)
    >>> round(touch.total_stiffness_n_per_m, 6)
    800.0
    """
    if not link_half_thickness_m >= 0.0:
        raise ValueError(f"link_half_thickness_m: expected 0 or more, got {link_half_thickness_m!r}")
    found = _core.stiffness(
        time_s,
        joint_angle_rad,
        joint_torque_nm,
        contact_distance_m,
        contact_distance_se_m,
        link_stiffness_n_per_m,
        link_stiffness_se_n_per_m,
        torque_reference_nm,
        method,
        window_nm[0],
        window_nm[1],
    )
    solid = found["standard_linear_solid"]
    if solid is not None:
        found["standard_linear_solid"] = StandardLinearSolid(
            **{name: Interval95(**interval) for name, interval in solid.items()}
        )
    return Stiffness(**found)


def contour(
    points_m: npt.ArrayLike,
    *,
    spline: Literal["interpolating", "approximating"] = "interpolating",
    closed: bool | None = None,
    samples: int | None = None,
    resolution_m: float = 0.0034,
) -> Contour:
    """Recognise the shape of a series of points of contact, and lay a spline through them.

    Parameters
    ----------
    points_m : array_like, (n, 2)
        The points (x, y), m, in the order of touch.
    spline : {'interpolating', 'approximating'}
        The curve passes through the points, or they are its control points.
    closed : bool, optional
        Whether the contour is closed. None: the points decide.
    samples : int, optional
        Points of the curve. None: 200.
    resolution_m : float
        A contour smaller than this is a point, m.

    Returns
    -------
    Contour
        Shape, corners and curve.

    Raises
    ------
    BadInputError
        There are no points, or a coordinate is not finite.
    ValueError
        A shape or a value does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> angle_rad = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    >>> found = contour(0.03 * np.column_stack([np.cos(angle_rad), np.sin(angle_rad)]), closed=True)
    >>> found.shape, round(found.circle.radius, 6)
    ('circle', 0.03)
    """
    if spline not in ("interpolating", "approximating"):
        raise ValueError(f"spline: expected 'interpolating' or 'approximating', got {spline!r}")
    found = _core.contour(
        points_m, spline == "interpolating", closed, 200 if samples is None else samples, resolution_m
    )
    if found["circle"] is not None:
        found["circle"] = Circle(**found["circle"])
    return Contour(**found)
