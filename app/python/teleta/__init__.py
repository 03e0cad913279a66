# SPDX-License-Identifier: GPL-3.0-or-later
"""Tactile frames, touches, cameras, patterns, studies and recordings of the TeleTA Console, as numpy arrays.

Everything is in SI units; names end with their unit. Frames are (frames, rows, columns), points (n, 2) or
(n, 3). A table is a dict of equally long arrays, as `pandas.DataFrame` takes it. What has no value is NaN in
arrays and None elsewhere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import study
from ._contact import Features, Gains, Processor, contacts, features, gains
from ._core import version as __version__
from ._errors import (
    BadInputError,
    DamagedDataWarning,
    Error,
    IoFailedError,
    NotFoundError,
    RefusedError,
    UnavailableError,
)
from ._pattern import Pattern, Violation, pattern, patterns
from ._recording import Data, McapFile, Recording, Stream, open, read_frames
from ._touch import Circle, Contour, Interval95, StandardLinearSolid, Stiffness, contour, stiffness

if TYPE_CHECKING:
    from ._camera import Calibration, Camera, CameraTracker, calibrate, scenes, simulate, track

__all__ = [
    "BadInputError",
    "Calibration",
    "Camera",
    "CameraTracker",
    "Circle",
    "Contour",
    "DamagedDataWarning",
    "Data",
    "Error",
    "Features",
    "Gains",
    "Interval95",
    "IoFailedError",
    "McapFile",
    "NotFoundError",
    "Pattern",
    "Processor",
    "Recording",
    "RefusedError",
    "StandardLinearSolid",
    "Stiffness",
    "Stream",
    "UnavailableError",
    "Violation",
    "__version__",
    "calibrate",
    "contacts",
    "contour",
    "features",
    "gains",
    "open",
    "pattern",
    "patterns",
    "read_frames",
    "scenes",
    "simulate",
    "stiffness",
    "study",
    "track",
]

#: These load OpenCV, which takes half a second, and are imported at their first use.
_OF_CAMERA = frozenset(["Calibration", "Camera", "CameraTracker", "calibrate", "scenes", "simulate", "track"])


def __getattr__(name: str) -> Any:
    if name not in _OF_CAMERA:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import _camera

    value = getattr(_camera, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_OF_CAMERA})
