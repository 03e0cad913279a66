# SPDX-License-Identifier: GPL-3.0-or-later
"""Vibration patterns of the bracelet."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import _core
from ._errors import Error

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._types import Floats, Path, Table


@dataclass(frozen=True)
class Violation:
    """A place where a pattern breaks a law of what can be felt; the keys of `teleta pattern check --json`.

    Attributes
    ----------
    law : str
        Such as 'burst-too-short'.
    object : int or None
        Number of the object, from 1; None: the tracks.
    tactors : tuple of int
        Tactors 1 to 6.
    begin_s, end_s : float
        When, s.
    value, limit : float
        What was found and what the law allows, in the unit of the law.
    message, suggestion : str
        What is wrong, and what to do about it.
    fixable : bool
        Whether the console can apply the suggestion.
    """

    law: str
    object: int | None
    tactors: tuple[int, ...]
    begin_s: float
    end_s: float
    value: float
    limit: float
    message: str
    suggestion: str
    fixable: bool


class Pattern:
    """A vibration pattern of six tactors. It does not change.

    Made by `pattern` and `Pattern.from_samples`.

    Examples
    --------
    >>> circle = pattern("shape.A.dynamic")
    >>> circle.duration_s
    2.0
    >>> circle.evaluate([0.5]).shape
    (1, 6)
    """

    __slots__ = ("_pattern",)

    def __init__(self, _pattern: _core.Pattern) -> None:
        self._pattern = _pattern

    def __repr__(self) -> str:
        return f"<teleta.Pattern {self.id!r}, {self.duration_s:g} s>"

    @property
    def id(self) -> str:
        """The id, such as 'shape.A.dynamic'."""
        return self._pattern.id

    @property
    def name(self) -> str:
        """The name that people read."""
        return self._pattern.name

    @property
    def task(self) -> str:
        """'shape', 'stiffness' or 'other'."""
        return self._pattern.task

    @property
    def condition(self) -> str:
        """'static', 'dynamic' or ''."""
        return self._pattern.condition

    @property
    def notes(self) -> str:
        """Notes of its author."""
        return self._pattern.notes

    @property
    def tags(self) -> tuple[str, ...]:
        """Tags of its author."""
        return self._pattern.tags

    @property
    def duration_s(self) -> float:
        """How long it lasts, s."""
        return self._pattern.duration_s

    @staticmethod
    def from_samples(
        times_s: npt.ArrayLike, intensities: npt.ArrayLike, *, id: str = "samples", name: str = ""
    ) -> Pattern:
        """Make a pattern from samples, with straight lines between them.

        Parameters
        ----------
        times_s : array_like, (n,)
            Times of the samples, s, from 0 on, which do not decrease. The pattern ends at the last one.
        intensities : array_like, (n, 6)
            Intensity of each tactor, 0 to 1.
        id, name : str
            Of the pattern.

        Returns
        -------
        Pattern
            A tactor is off from the last sample on.

        Raises
        ------
        ValueError
            A shape or a value does not fit.

        Examples
        --------
        >>> import numpy as np
        >>> ramp = Pattern.from_samples([0.0, 1.0], [[0.0] * 6, [1.0] + [0.0] * 5])
        >>> ramp.evaluate([0.25])
        array([[0.25, 0.  , 0.  , 0.  , 0.  , 0.  ]])
        """
        return Pattern(_core.pattern_from_samples(times_s, intensities, id, name))

    def evaluate(self, times_s: npt.ArrayLike) -> Floats:
        """Compute what is commanded.

        Parameters
        ----------
        times_s : array_like, (n,)
            Times, s, in any order.

        Returns
        -------
        ndarray of float64, (n, 6)
            Intensity of each tactor, 0 to 1; 0 outside the pattern.
        """
        return self._pattern.evaluate(times_s)

    def predicted(self, times_s: npt.ArrayLike, motors: Path | None = None) -> Floats:
        """Predict what the motors do.

        Parameters
        ----------
        times_s : array_like, (n,)
            Times, s, from 0 on, which do not decrease.
        motors : str or os.PathLike, optional
            Profile of the motors, as the console's page Calibrate saves it. None: assumed motors, whose
            lag, start and speed are not measured.

        Returns
        -------
        ndarray of float64, (n, 6)
            The intensity at which each motor would turn steadily as it turns then, 0 to 1.

        Raises
        ------
        NotFoundError, BadInputError
            The profile cannot be read.
        ValueError
            A time does not fit.
        """
        return self._pattern.predicted(times_s, motors)

    def save(
        self,
        path: Path,
        rate_hz: float | None = None,
        *,
        predicted: bool = False,
        motors: Path | None = None,
    ) -> None:
        """Write the pattern in the format that the ending of the name says.

        Parameters
        ----------
        path : str or os.PathLike
            A name that ends in .json, .hjif, .haptic.zip, .haptic, .ahap.zip, .ahap, .tact, .csv or .wav.
        rate_hz : float, optional
            Samples a second of .csv (None: 200) and .wav (None: 8000).
        predicted : bool
            .csv and .wav: what the motors will do, not what is commanded.
        motors : str or os.PathLike, optional
            With `predicted`: profile of the motors, as in `predicted`.

        Raises
        ------
        RefusedError
            The format cannot hold the pattern.
        IoFailedError
            The file cannot be written.
        ValueError
            The ending is that of no format.
        """
        self._pattern.save(path, rate_hz, predicted, motors)

    def check(self, motors: Path | None = None) -> list[Violation]:
        """Find where the pattern breaks a law of what can be felt.

        Parameters
        ----------
        motors : str or os.PathLike, optional
            Profile of the motors, as in `predicted`.

        Returns
        -------
        list of Violation
            Empty: it keeps all laws.

        Examples
        --------
        >>> pattern("shape.A.static").check()
        []
        """
        return [Violation(**found) for found in self._pattern.check(motors)]


def pattern(name_or_path: Path) -> Pattern:
    """Return a built-in pattern, or read one from a file.

    Parameters
    ----------
    name_or_path : str or os.PathLike
        Id of a built-in pattern, or a file that ends in .json, .hjif, .haptic.zip, .haptic or .tact.

    Returns
    -------
    Pattern
        The pattern.

    Raises
    ------
    KeyError
        There is no such pattern and no such file; the text has the ids that exist.
    BadInputError
        With line and column: the file is no pattern.

    Examples
    --------
    >>> pattern("stiffness.C.dynamic").task
    'stiffness'
    """
    try:
        return Pattern(_core.pattern(name_or_path))
    except Error:
        # What looks like a file, or is one, is told as such.
        if os.path.exists(name_or_path) or os.path.basename(name_or_path) != name_or_path:
            raise
    ids = ", ".join(patterns()["id"])
    raise KeyError(f"name_or_path: there is no pattern {name_or_path!r}; expected a file or one of {ids}")


def patterns() -> Table:
    """List the built-in patterns.

    Returns
    -------
    dict of str to ndarray
        A row a pattern: id, name, task, condition (str), duration_s (float64).

    Examples
    --------
    >>> len(patterns()["id"])
    22
    """
    return _core.patterns()
