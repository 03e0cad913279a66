# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera in the soft tube, and simulated scenes. Loads OpenCV, so it is imported at the first use."""

from __future__ import annotations

import json
import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Literal, overload

import numpy as np

from . import _vision

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._types import Floats, Path, Progress, Table


class Camera:
    """A calibrated camera that looks at the inside of a cylinder. It does not change.

    Made by `Camera.load` and `calibrate`. Points are in the frame of the sensor, m; its z is the axis of
    the cylinder.
    """

    __slots__ = ("_camera",)

    def __init__(self, _camera: _vision.Camera) -> None:
        self._camera = _camera

    @staticmethod
    def load(path: Path) -> Camera:
        """Read a camera file that `teleta calibrate` or `save` has written.

        Parameters
        ----------
        path : str or os.PathLike
            The file.

        Returns
        -------
        Camera
            The camera.

        Raises
        ------
        NotFoundError, BadInputError
            With line and column: not a camera file.
        """
        return Camera(_vision.Camera.load(path))

    @property
    def width_px(self) -> int:
        """Width of the image, px."""
        return self._camera.width_px

    @property
    def height_px(self) -> int:
        """Height of the image, px."""
        return self._camera.height_px

    def save(self, path: Path) -> None:
        """Write the camera file.

        Parameters
        ----------
        path : str or os.PathLike
            The file; it appears when it is complete.

        Raises
        ------
        IoFailedError
            The file cannot be written.
        """
        self._camera.save(path)

    @overload
    def locate(self, pixels_px: npt.ArrayLike, *, why: Literal[False] = ...) -> tuple[Floats, Floats]: ...

    @overload
    def locate(
        self, pixels_px: npt.ArrayLike, *, why: Literal[True]
    ) -> tuple[Floats, Floats, npt.NDArray[np.str_]]: ...

    def locate(self, pixels_px: npt.ArrayLike, *, why: bool = False) -> tuple[Any, ...]:
        """Find the points of the surface that pixels show.

        Parameters
        ----------
        pixels_px : array_like, (n, 2) or (2,)
            Pixels (u, v), px, from the centre of the upper left one, u to the right and v down.
        why : bool
            Also say why a pixel shows no point.

        Returns
        -------
        points_m : ndarray of float64, (n, 3)
            Points, m; NaN where a pixel shows none.
        sd_m : ndarray of float64, (n,)
            Standard deviation of each, m; NaN where it is not known.
        why : ndarray of str, (n,)
            Only with `why`: '' or such as 'beyondEnds'.

        Raises
        ------
        ValueError, TypeError
            The pixels have another shape, or are no real numbers.
        """
        points_m, sd_m, reasons = self._camera.locate(pixels_px)
        return (points_m, sd_m, reasons) if why else (points_m, sd_m)

    def project(self, points_m: npt.ArrayLike) -> Floats:
        """Find the pixels that show points.

        Parameters
        ----------
        points_m : array_like, (n, 3) or (3,)
            Points, m.

        Returns
        -------
        ndarray of float64, (n, 2)
            Pixels (u, v), px; NaN where a point is not in the image.

        Raises
        ------
        ValueError, TypeError
            The points have another shape, or are no real numbers.
        """
        return self._camera.project(points_m)


@dataclass(frozen=True)
class Calibration:
    """A camera that was found from pairs, and how well it fits them.

    Attributes
    ----------
    camera : Camera
        The camera.
    kept : ndarray of bool, (n,)
        Pairs that were not left out as wrong.
    residual_px : ndarray of float64, (n, 2)
        Projected point minus pixel, px; NaN where a point is not in front of the lens.
    rms_px, mean_px : float
        Root mean square and mean distance from the pixels, kept pairs, px.
    mean_m : float
        Mean distance of the located points from the points, kept pairs, m.
    valid_radius_px : float
        Distance from the principal point within which the lens model is valid, px.
    uncertainty_m : float
        Standard deviation of a located point by the camera alone, m.
    warnings : tuple of str
        What in the pairs makes the camera doubtful, such as 'structured'.
    """

    camera: Camera
    kept: npt.NDArray[np.bool_]
    residual_px: Floats
    rms_px: float
    mean_px: float
    mean_m: float
    valid_radius_px: float
    uncertainty_m: float
    warnings: tuple[str, ...]


def calibrate(
    pixels_px: npt.ArrayLike,
    points_m: npt.ArrayLike,
    *,
    width_px: int = 1640,
    height_px: int = 1232,
    radius_m: float = 0.025,
    length_m: float = 0.1,
    method: Literal["robust", "paper", "least_squares", "dlt"] = "robust",
) -> Calibration:
    """Find pose and lens of a camera in a cylinder from pairs of pixels and points.

    Parameters
    ----------
    pixels_px : array_like, (n, 2)
        Pixels (u, v), px; at least six.
    points_m : array_like, (n, 3)
        The points that they show, m, in the frame of the sensor.
    width_px, height_px : int
        Size of the image, px.
    radius_m, length_m : float
        Radius of the elastomer, and its length from z = 0, m.
    method : {'robust', 'paper', 'least_squares', 'dlt'}
        Camera and lens with wrong pairs left out; the published method, without a lens; all pairs; the
        direct linear transformation.

    Returns
    -------
    Calibration
        The camera and its errors.

    Raises
    ------
    RefusedError
        The pairs do not determine a camera; the text says why.
    ValueError, TypeError
        A shape or a value does not fit.

    Examples
    --------
    >>> import tempfile
    >>> folder = tempfile.mkdtemp()
    >>> _ = simulate("vtacarm-calibration", duration_s=60.0, out=folder)
    >>> import numpy as np
    >>> pairs = np.genfromtxt(folder + "/pairs.csv", delimiter=",", names=True)
    >>> pixels_px = np.column_stack([pairs["u_px"], pairs["v_px"]])
    >>> points_m = np.column_stack([pairs["x_m"], pairs["y_m"], pairs["z_m"]])
    >>> found = calibrate(pixels_px, points_m)
    >>> located_m, sd_m = found.camera.locate(pixels_px[found.kept])
    >>> bool(np.nanmean(np.linalg.norm(located_m - points_m[found.kept], axis=1)) < 0.001)
    True
    """
    found = _vision.calibrate(pixels_px, points_m, width_px, height_px, radius_m, length_m, method)
    found["camera"] = Camera(found["camera"])
    return Calibration(**found)


class CameraTracker:
    """Follows the contacts on the soft tube in one picture after another.

    Nothing touches the tube in the first picture. An object belongs to one thread at a time: while one is
    in it, another gets RuntimeError.

    Parameters
    ----------
    camera : Camera
        The camera that took the pictures.
    preset : str
        How contacts are found, as `teleta track --preset`: 'dots', or a more exact and slower one.
    """

    def __init__(self, camera: Camera, *, preset: str = "dots") -> None:
        self._tracker = _vision.Tracker(camera._camera, preset)
        self._next_frame = 0

    def frames(self, source: Path | Iterable[npt.ArrayLike], rate_hz: float | None = None) -> Iterator[Table]:
        """Follow the contacts through a video, picture by picture.

        Parameters
        ----------
        source : str, os.PathLike, or an iterable of uint8 (height, width)
            A video file, a pattern of numbered images (frame_%04d.png), or the pictures.
        rate_hz : float, optional
            Pictures a second. None: the times of the file; needed for pictures.

        Yields
        ------
        dict of str to ndarray
            The rows of `track` for each picture; without rows for one that could not be decoded.

        Raises
        ------
        RefusedError
            The first picture cannot be a reference.
        NotFoundError, BadInputError
            The file is no video.
        ValueError, TypeError
            Times or pictures do not fit.

        Warns
        -----
        UserWarning
            Pictures could not be used.
        """
        for picture, time_s in _timed(source, rate_hz):
            yield self._tracker.next(picture, self._next_frame, time_s)
            self._next_frame += 1
        unusable = self._tracker.unusable_frames()
        if unusable:
            warnings.warn(
                f"{unusable} of {self._next_frame} pictures could not be used. "
                f"The last reason: {self._tracker.why_unusable()}",
                stacklevel=2,
            )


def _timed(
    source: Path | Iterable[npt.ArrayLike], rate_hz: float | None
) -> Iterator[tuple[npt.ArrayLike | None, float]]:
    if rate_hz is not None and not (np.isfinite(rate_hz) and rate_hz > 0.0):
        raise ValueError(f"rate_hz: expected a finite number above 0, got {rate_hz!r}")
    if isinstance(source, (str, os.PathLike)):
        for frame, (picture, time_s) in enumerate(_vision.Video(source)):
            yield picture, time_s if rate_hz is None else frame / rate_hz
        return
    if rate_hz is None:
        raise ValueError("rate_hz: expected the pictures a second, got None")
    for frame, given in enumerate(source):
        yield given, frame / rate_hz


def track(
    pictures_or_path: Path | Iterable[npt.ArrayLike],
    camera: Camera,
    *,
    preset: str = "dots",
    rate_hz: float | None = None,
) -> Table:
    """Find the contacts on the soft tube in a video.

    Parameters
    ----------
    pictures_or_path : str, os.PathLike, or array_like of uint8, (frames, height, width)
        A video file, a pattern of numbered images (frame_%04d.png), or the pictures. Nothing touches the
        tube in the first one.
    camera : Camera
        The camera that took them.
    preset : str
        As in `CameraTracker`.
    rate_hz : float, optional
        Pictures a second. None: the times of the file; needed for pictures.

    Returns
    -------
    dict of str to ndarray
        The columns of `teleta track`, a row a contact and picture: frame, contact_id (int64), time_s,
        u_px, v_px, x_m, y_m, z_m, dx_m, dy_m, dz_m, area_px (float64), event (str: 'begin', 'bump',
        'end' or 'NA').

    Raises
    ------
    RefusedError, NotFoundError, BadInputError, ValueError, TypeError
        As in `CameraTracker.frames`.
    """
    tables = list(CameraTracker(camera, preset=preset).frames(pictures_or_path, rate_hz))
    if not tables:
        raise ValueError("pictures_or_path: expected at least one picture, got none")
    return {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}


def simulate(
    scene: Path,
    seed: int = 1,
    duration_s: float | None = None,
    out: Path | None = None,
    *,
    progress: Progress = None,
) -> dict[str, Any]:
    """Run a simulated scene as fast as possible and measure what was estimated.

    Parameters
    ----------
    scene : str or os.PathLike
        A scene file, or the name of a scene that comes with the program; see `scenes`.
    seed : int
        Of all random numbers.
    duration_s : float, optional
        Simulated time, s. None: as the scene says.
    out : str or os.PathLike, optional
        Folder for summary, recording and data, as `teleta simulate --out`.
    progress : callable, optional
        Called with the simulated time and the whole time, s, at most ten times a second.

    Returns
    -------
    dict
        The content of summary.json.

    Raises
    ------
    NotFoundError, BadInputError
        With line and column: there is no such scene, or it is not valid.
    IoFailedError
        A file cannot be written.

    Examples
    --------
    >>> summary = simulate("tactile-indenter", duration_s=0.5)
    >>> summary["simulated_s"]
    0.5
    """
    summary: dict[str, Any] = json.loads(_vision.simulate(scene, seed, duration_s, out, progress))
    return summary


def scenes() -> list[str]:
    """Return the names of the scenes that come with the program.

    Examples
    --------
    >>> "tactile-indenter" in scenes()
    True
    """
    return _vision.scenes()
