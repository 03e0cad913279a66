# SPDX-License-Identifier: GPL-3.0-or-later
"""Tactile frames: features, contacts, gains of taxels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Sequence, overload

import numpy as np

from . import _core

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._types import Floats, Path, Table


@dataclass(frozen=True)
class Gains:
    """Gain of each taxel, from frames under an even load.

    Attributes
    ----------
    gain : ndarray of float64, (rows, columns)
        Factor on the load of each taxel; NaN where the taxel is not good.
    gain_se : ndarray of float64, (rows, columns)
        Its standard error.
    state : ndarray of str, (rows, columns)
        'good', 'dead', 'weak', 'strong' or 'stuck'.
    presses, frames : int
        Presses, and frames under load in all of them; 0 when read from a file.
    level : float
        Mean reading in these frames, in raw units above the tare.
    scatter : float
        What the gains do not explain, root mean square, as a share of the level.
    repeatability : float
        Deviation of the gains from press to press, root mean square.
    tilt_x, tilt_y : float
        Change of the response along the array, as a share of its mean.
    tilted : bool
        Whether one of them is significant: the load may have been uneven.
    """

    gain: Floats
    gain_se: Floats
    state: npt.NDArray[np.str_]
    presses: int = 0
    frames: int = 0
    level: float = 0.0
    scatter: float = 0.0
    repeatability: float = 0.0
    tilt_x: float = 0.0
    tilt_y: float = 0.0
    tilted: bool = False

    def save(self, path: Path) -> None:
        """Write the gains as the CSV file that `teleta gains` writes.

        Parameters
        ----------
        path : str or os.PathLike
            The file; it appears when it is complete.

        Raises
        ------
        IoFailedError
            The file cannot be written.

        Examples
        --------
        >>> import numpy as np, os, tempfile
        >>> gains = Gains(np.ones((1, 2)), np.zeros((1, 2)), np.array([["good", "good"]]))
        >>> path = os.path.join(tempfile.mkdtemp(), "gains.csv")
        >>> gains.save(path)
        >>> Gains.load(path).gain
        array([[1., 1.]])
        """
        _core.save_gains(self.gain, self.gain_se, self.state, path)

    @staticmethod
    def load(path: Path) -> Gains:
        """Read gains from a CSV file that `teleta gains` or `save` has written.

        Parameters
        ----------
        path : str or os.PathLike
            The file.

        Returns
        -------
        Gains
            With `gain`, `gain_se` and `state`; the file holds no more.

        Raises
        ------
        BadInputError
            With line and column: not a file of gains.
        """
        read = _core.load_gains(path)
        return Gains(read["gain"], read["gain_se"], read["state"])


@dataclass(frozen=True, slots=True)
class Features:
    """Features of one tactile frame, in the frame of the array (x along the columns, y along the rows).

    Attributes
    ----------
    time_s : float or None
        Time of the frame, s.
    contact_type : str
        'none', 'point' or 'edge'.
    force_n : float
        Sum of the loads, N.
    cop_x_m, cop_y_m : float or None
        Centre of pressure, m; None without load.
    coc_x_m, coc_y_m : float or None
        Centre of contact, m; None without contact.
    dzmp_x_m, dzmp_y_m : float or None
        Distance of the two centres, m, as moments about x and y.
    alpha_z_rad : float or None
        Direction of the first principal axis, rad, in (-pi/2, pi/2].
    lambda1_m2, lambda2_m2 : float or None
        Eigenvalues of the covariance, m2.
    active : int
        Taxels in contact.
    """

    time_s: float | None
    contact_type: str
    force_n: float
    cop_x_m: float | None
    cop_y_m: float | None
    coc_x_m: float | None
    coc_y_m: float | None
    dzmp_x_m: float | None
    dzmp_y_m: float | None
    alpha_z_rad: float | None
    lambda1_m2: float | None
    lambda2_m2: float | None
    active: int


def features(
    frames: npt.ArrayLike,
    *,
    pitch_m: float = 0.0034,
    threshold_n: float = 0.2,
    tare: npt.ArrayLike | None = None,
    gain: float = 1.0,
    inverted: bool = False,
    taxel_gains: npt.ArrayLike | Gains | None = None,
    dead: npt.ArrayLike | None = None,
    orientation: Literal["binarised", "weighted"] = "binarised",
    moment_range: Literal["image", "active"] = "image",
    automatic_threshold: bool = False,
    summit: bool = False,
    noise_n: float | None = None,
    time_s: npt.ArrayLike | None = None,
) -> Table:
    """Compute force, centres, moments and orientation of each tactile frame.

    Parameters
    ----------
    frames : array_like, (frames, rows, columns) or (rows, columns)
        Raw values, row-major; NaN and infinite taxels are dead in their frame.
    pitch_m : float
        Distance of neighbouring taxels, m.
    threshold_n : float
        Load from which a taxel is in contact, N.
    tare : array_like, (rows, columns), optional
        Raw values without load; NaN marks a dead taxel.
    gain : float
        N per raw unit.
    inverted : bool
        The raw values fall under load.
    taxel_gains : array_like, (rows, columns), or Gains, optional
        Factor on the load of each taxel; NaN marks a dead taxel.
    dead : array_like, optional
        Taxels to leave out: a mask (rows, columns), or their numbers, counted row by row from 0.
    orientation : {'binarised', 'weighted'}
        Whether the principal axis counts taxels in contact alike, or by their load.
    moment_range : {'image', 'active'}
        Whether force and centre of pressure take all taxels, or those in contact.
    automatic_threshold : bool
        Find the threshold in each frame; `threshold_n` is the least.
    summit : bool
        Add the place of deepest pressure of the only contact, finer than the taxels, also on a strip (one row
        or one column).
    noise_n : float, optional
        Standard deviation of a taxel's load at rest, N, for the standard errors of the summit.
    time_s : array_like, (frames,), optional
        Times of the frames, s, which do not decrease. None: the table has frame numbers instead.

    Returns
    -------
    dict of str to ndarray
        The columns of `teleta features`, a row a frame: time_s (or frame, int64), contact_type (str),
        force_n, cop_x_m, cop_y_m, coc_x_m, coc_y_m, dzmp_x_m, dzmp_y_m, alpha_z_rad, lambda1_m2,
        lambda2_m2 (float64, NaN where not defined), active (int64). With `summit` also summit_x_m,
        summit_y_m, summit_x_se_m, summit_y_se_m (float64, NaN where not defined).

    Raises
    ------
    ValueError
        A shape or a value does not fit; the text names the parameter.
    TypeError
        The frames are no real numbers.

    Examples
    --------
    >>> import numpy as np
    >>> frame = np.zeros((6, 14), dtype=np.float32)
    >>> frame[2, 3:6] = 1.0
    >>> table = features(frame)
    >>> table["force_n"], table["active"]
    (array([3.]), array([3]))
    >>> str(table["contact_type"][0])
    'edge'
    """
    return _core.features(
        frames,
        pitch_m,
        {
            "threshold_n": threshold_n,
            "automatic_threshold": automatic_threshold,
            "orientation": orientation,
            "moment_range": moment_range,
            "tare": tare,
            "gain": gain,
            "inverted": inverted,
            "taxel_gains": taxel_gains,
            "dead": dead,
            "summit": summit,
            "noise_n": noise_n,
        },
        time_s,
    )


@overload
def contacts(
    frames: npt.ArrayLike,
    *,
    pitch_m: float = ...,
    threshold_n: float = ...,
    tare: npt.ArrayLike | None = ...,
    gain: float = ...,
    inverted: bool = ...,
    taxel_gains: npt.ArrayLike | Gains | None = ...,
    dead: npt.ArrayLike | None = ...,
    automatic_threshold: bool = ...,
    noise_height: float = ...,
    minimum_taxels: int = ...,
    gate_m: float | None = ...,
    memory_s: float = ...,
    summit: bool = ...,
    noise_n: float | None = ...,
    time_s: npt.ArrayLike | None = ...,
    rate_hz: float | None = ...,
    return_labels: Literal[False] = ...,
) -> Table: ...


@overload
def contacts(
    frames: npt.ArrayLike,
    *,
    pitch_m: float = ...,
    threshold_n: float = ...,
    tare: npt.ArrayLike | None = ...,
    gain: float = ...,
    inverted: bool = ...,
    taxel_gains: npt.ArrayLike | Gains | None = ...,
    dead: npt.ArrayLike | None = ...,
    automatic_threshold: bool = ...,
    noise_height: float = ...,
    minimum_taxels: int = ...,
    gate_m: float | None = ...,
    memory_s: float = ...,
    summit: bool = ...,
    noise_n: float | None = ...,
    time_s: npt.ArrayLike | None = ...,
    rate_hz: float | None = ...,
    return_labels: Literal[True],
) -> tuple[Table, npt.NDArray[np.int32]]: ...


def contacts(
    frames: npt.ArrayLike,
    *,
    pitch_m: float = 0.0034,
    threshold_n: float = 0.2,
    tare: npt.ArrayLike | None = None,
    gain: float = 1.0,
    inverted: bool = False,
    taxel_gains: npt.ArrayLike | Gains | None = None,
    dead: npt.ArrayLike | None = None,
    automatic_threshold: bool = False,
    noise_height: float = 0.3,
    minimum_taxels: int = 1,
    gate_m: float | None = None,
    memory_s: float = 0.1,
    summit: bool = False,
    noise_n: float | None = None,
    time_s: npt.ArrayLike | None = None,
    rate_hz: float | None = None,
    return_labels: bool = False,
) -> Table | tuple[Table, npt.NDArray[np.int32]]:
    """Find the contacts of each tactile frame: place, force and identity.

    Parameters
    ----------
    frames, pitch_m, threshold_n, tare, gain, inverted, taxel_gains, dead, automatic_threshold
        As in `features`.
    noise_height : float
        Summits that rise less than this share of the frame's peak are no contacts of their own, 0 to 1.
    minimum_taxels : int
        Contacts of fewer taxels are dropped.
    gate_m : float, optional
        A contact that moved further than this between two frames counts as a new one, m. None: two
        taxels, at least 15 mm.
    memory_s : float
        How long a lost contact keeps its identity, s.
    summit, noise_n
        As in `features`, for each contact.
    time_s : array_like, (frames,), optional
        Times of the frames, s, which do not decrease.
    rate_hz : float, optional
        Instead of times: frames a second, the first one at 0 s.
    return_labels : bool
        Also return the contact of each taxel.

    Returns
    -------
    table : dict of str to ndarray
        A row a contact, by falling force within a frame: frame (int64), time_s (float64), contact_id
        (int64, from 1), x_m, y_m, force_n, peak_n, area_m2 (float64), and with `summit` its columns.
        Without `time_s` and `rate_hz` there are no identities: time_s is NaN and contact_id 0.
    labels : ndarray of int32, the shape of `frames`
        Only with `return_labels`: 1, 2, ... for the contacts of the frame in the order of the rows,
        0 for taxels without contact.

    Raises
    ------
    ValueError, TypeError
        As in `features`.

    Examples
    --------
    >>> import numpy as np
    >>> frames = np.zeros((2, 6, 14), dtype=np.float32)
    >>> frames[:, 2, 2] = 1.0
    >>> frames[1, 3, 11] = 2.0
    >>> table = contacts(frames, rate_hz=200.0)
    >>> table["frame"], table["contact_id"]
    (array([0, 1, 1]), array([1, 2, 1]))
    """
    found: Table | tuple[Table, npt.NDArray[np.int32]] = _core.contacts(
        frames,
        pitch_m,
        {
            "threshold_n": threshold_n,
            "automatic_threshold": automatic_threshold,
            "orientation": "binarised",
            "moment_range": "image",
            "tare": tare,
            "gain": gain,
            "inverted": inverted,
            "taxel_gains": taxel_gains,
            "dead": dead,
            "noise_height": noise_height,
            "minimum_taxels": minimum_taxels,
            "gate_m": gate_m,
            "memory_s": memory_s,
            "summit": summit,
            "noise_n": noise_n,
        },
        time_s,
        rate_hz,
        return_labels,
    )
    return found


class Processor(_core.Processor):
    """Features and contacts of one frame after another, for a control loop.

    All memory of the computation is allocated once. An object belongs to one thread at a time: while one
    is in it, another gets RuntimeError.

    Parameters
    ----------
    rows, columns : int
        Size of the array, 1 to 1024.
    pitch_m, threshold_n, tare, gain, inverted, taxel_gains, dead, orientation, moment_range
        As in `features`.
    automatic_threshold, noise_height, minimum_taxels, gate_m, memory_s
        As in `contacts`.

    Examples
    --------
    >>> import numpy as np
    >>> processor = Processor(6, 14, threshold_n=0.3)
    >>> frame = np.zeros((6, 14), dtype=np.float32)
    >>> frame[2, 3] = 0.5
    >>> now, contacts = processor.process(frame, 0.0)
    >>> now.force_n, now.contact_type, contacts["contact_id"]
    (0.5, 'point', array([1]))
    """

    __slots__ = ("_settings",)

    def __init__(
        self,
        rows: int,
        columns: int,
        *,
        pitch_m: float = 0.0034,
        threshold_n: float = 0.2,
        tare: npt.ArrayLike | None = None,
        gain: float = 1.0,
        inverted: bool = False,
        taxel_gains: npt.ArrayLike | Gains | None = None,
        dead: npt.ArrayLike | None = None,
        orientation: Literal["binarised", "weighted"] = "binarised",
        moment_range: Literal["image", "active"] = "image",
        automatic_threshold: bool = False,
        noise_height: float = 0.3,
        minimum_taxels: int = 1,
        gate_m: float | None = None,
        memory_s: float = 0.1,
    ) -> None:
        settings: dict[str, Any] = {
            "threshold_n": threshold_n,
            "automatic_threshold": automatic_threshold,
            "orientation": orientation,
            "moment_range": moment_range,
            "tare": tare,
            "gain": gain,
            "inverted": inverted,
            "taxel_gains": taxel_gains,
            "dead": dead,
            "noise_height": noise_height,
            "minimum_taxels": minimum_taxels,
            "gate_m": gate_m,
            "memory_s": memory_s,
        }
        super().__init__(rows, columns, pitch_m, settings, Features)
        self._settings = {"rows": rows, "columns": columns, "pitch_m": pitch_m, **settings}

    @property
    def settings(self) -> dict[str, Any]:
        """The arguments that the object was made with, by name."""
        return dict(self._settings)


def gains(
    presses: npt.ArrayLike | Sequence[npt.ArrayLike],
    *,
    pitch_m: float = 0.0034,
    tare: npt.ArrayLike | None = None,
    inverted: bool = False,
    dead: npt.ArrayLike | None = None,
) -> Gains:
    """Find the gain of each taxel from frames in which an even load presses on the whole array.

    Parameters
    ----------
    presses : array_like, (frames, rows, columns), or a sequence of such
        Raw frames of each press: at least 20 under load.
    pitch_m : float
        Distance of neighbouring taxels, m.
    tare, inverted, dead
        As in `features`.

    Returns
    -------
    Gains
        For `taxel_gains` of the other functions.

    Raises
    ------
    RefusedError
        There is too little load to find gains from.
    ValueError
        A shape does not fit.

    Examples
    --------
    >>> import numpy as np
    >>> load = np.linspace(0.0, 10.0, 50)[:, None, None]
    >>> response = np.array([[0.5, 1.0], [1.0, 1.5]])
    >>> found = gains(load * response)
    >>> found.gain.round(6)
    array([[2.      , 1.      ],
           [1.      , 0.666667]])
    """
    several: list[Any] = list(presses) if isinstance(presses, (list, tuple)) else [presses]
    return Gains(
        **_core.gains(
            several,
            pitch_m,
            {"tare": tare, "gain": 1.0, "inverted": inverted, "taxel_gains": None, "dead": dead},
        )
    )
