# SPDX-License-Identifier: GPL-3.0-or-later
"""Recordings (.teleta) and files of frames."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Literal, Sequence

import numpy as np

from . import _core

if TYPE_CHECKING:
    from types import TracebackType

    import numpy.typing as npt

    from ._types import Floats, Path, Progress, Table


@dataclass(frozen=True)
class Stream:
    """What a stream of a recording holds.

    Attributes
    ----------
    kind : str
        'array', 'features', 'joints', 'touches', 'camera', 'contacts', 'tactors', 'wrench' or 'numbers'.
    type : str
        'float32', 'float64' or 'grey8'.
    shape : tuple of int
        Of one frame; of a picture (height, width), in colour (height, width, 3), 0 where it varies.
    unit : str
        Of all values; '' where the columns say it.
    columns : tuple of str
        Names of the values of a frame, where they have any.
    rate_hz : float
        Nominal frames a second; 0: unknown.
    details : dict or None
        What playback needs to know of the source.
    source : str
        The device, as people know it.
    column_units : tuple of str
        Unit of each column.
    """

    kind: str
    type: str
    shape: tuple[int, ...]
    unit: str
    columns: tuple[str, ...]
    rate_hz: float
    details: dict[str, Any] | None
    source: str
    column_units: tuple[str, ...]


@dataclass(frozen=True)
class Data:
    """Frames of a stream.

    Attributes
    ----------
    time_s : ndarray of float64, (frames,)
        Time since the start of the recording, s.
    time_ns : ndarray of int64, (frames,)
        Steady clock, ns; `Recording.utc` makes dates of it.
    source_time_s : ndarray of float64, (frames,)
        The source's own time, s.
    values : ndarray, (frames, ...)
        float32, float64 or uint8, as the stream's type says.
    unit : str
        Of the values.
    columns : tuple of str
        Names of the values of a frame, where they have any.
    damaged : int
        Damaged blocks that were left out.
    """

    time_s: Floats
    time_ns: npt.NDArray[np.int64]
    source_time_s: Floats
    values: npt.NDArray[Any]
    unit: str
    columns: tuple[str, ...]
    damaged: int


@dataclass(frozen=True)
class McapFile:
    """What `Recording.to_mcap` wrote.

    Attributes
    ----------
    path : str
        The file.
    bytes : int
        Its size.
    damaged_blocks : int
        Damaged blocks of the recording that were left out.
    topics : dict of str to ndarray
        Table of `topic`, `type` (str) and `messages` (int64).
    left_out : tuple of str
        Streams that have no messages in ROS.
    y_turned : tuple of str
        Streams of the camera in the soft tube, whose frame is left-handed: their y has changed its sign.
    """

    path: str
    bytes: int
    damaged_blocks: int
    topics: Table
    left_out: tuple[str, ...]
    y_turned: tuple[str, ...]


class Recording:
    """A recording of the console or of `teleta simulate`, open for reading.

    A file that is still written is read up to its last commit. The object belongs to the thread that
    opened it. It is a context manager; `open` makes it.

    Examples
    --------
    >>> import tempfile
    >>> folder = tempfile.mkdtemp()
    >>> _ = simulate("tactile-indenter", duration_s=0.5, out=folder)
    >>> with open(folder + "/recording.teleta") as recording:
    ...     name = next(name for name, stream in recording.streams.items() if stream.kind == "array")
    ...     data = recording.read(name)
    >>> data.values.shape[1:], data.values.dtype
    ((6, 14), dtype('float32'))
    """

    def __init__(self, path: Path) -> None:
        self._file = _core.RecordingFile(path)
        self._about = self._file.describe()
        self._names = [stream["name"] for stream in self._about["streams"]]

    def __enter__(self) -> Recording:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close the file; reading from it then raises ValueError."""
        self._file.close()

    @property
    def streams(self) -> dict[str, Stream]:
        """The streams, by name."""
        return {
            stream["name"]: Stream(
                kind=stream["kind"],
                type=stream["type"],
                shape=stream["shape"],
                unit=stream["unit"],
                columns=stream["columns"],
                rate_hz=stream["rate_hz"],
                details=json.loads(stream["details"]) if stream["details"] else None,
                source=stream["source"],
                column_units=stream["column_units"],
            )
            for stream in self._about["streams"]
        }

    @property
    def scene(self) -> str | None:
        """Name of the simulated scene; None: real devices."""
        return self._about["scene"] or None

    @property
    def complete(self) -> bool:
        """Whether the recording was ended on purpose, not cut off."""
        return bool(self._about["complete"])

    @property
    def start_utc(self) -> np.datetime64:
        """When it was started."""
        return self.utc(np.int64(self._about["start_ns"]))  # type: ignore[return-value]

    @property
    def anchors(self) -> Table:
        """Where wall clock and steady clock met: time_ns (int64), utc (datetime64[ns])."""
        utc = self._about["anchor_utc_ms"].astype("datetime64[ms]").astype("datetime64[ns]")
        return {"time_ns": self._about["anchor_time_ns"].copy(), "utc": utc}

    @property
    def events(self) -> Table:
        """Events and marks: time_s, utc (datetime64[ns]), event, text (str), value (float64)."""
        about = self._about
        return {
            "time_s": about["event_time_s"].copy(),
            "utc": np.atleast_1d(self.utc(about["event_time_ns"])),
            "event": np.array(about["event_kind"], dtype=str),
            "text": np.array(about["event_text"], dtype=str),
            "value": about["event_value"].copy(),
        }

    def utc(self, time_ns: npt.ArrayLike) -> npt.NDArray[np.datetime64] | np.datetime64:
        """Return the wall clock time at times of the steady clock.

        Parameters
        ----------
        time_ns : array_like of int
            Steady clock, ns.

        Returns
        -------
        ndarray of datetime64[ns], or datetime64[ns] for a single time
            UTC, by the last anchor before each time, or the first one.
        """
        steady = np.asarray(time_ns)
        if steady.dtype.kind not in "iu":
            raise TypeError(f"time_ns: expected whole numbers, got {steady.dtype}")
        anchors = self.anchors
        if len(anchors["time_ns"]) == 0:
            nothing = np.full(steady.shape, "NaT", dtype="datetime64[ns]")
            return nothing if steady.ndim else nothing[()]
        at = np.maximum(np.searchsorted(anchors["time_ns"], steady, side="right") - 1, 0)
        since = (steady - anchors["time_ns"][at]).astype("timedelta64[ns]")
        return anchors["utc"][at] + since  # type: ignore[no-any-return]

    def read(
        self, stream: str, start_s: float | None = None, stop_s: float | None = None, step: int = 1
    ) -> Data:
        """Read frames of a stream.

        Parameters
        ----------
        stream : str
            Name of the stream.
        start_s, stop_s : float, optional
            Frames at or after `start_s` and before `stop_s`, s since the start of the recording.
        step : int
            Of these every step-th one.

        Returns
        -------
        Data
            All of them at once; `blocks` needs less memory.

        Raises
        ------
        KeyError
            There is no such stream; the text has the names that exist.
        BadInputError, IoFailedError
            The file cannot be read.

        Warns
        -----
        DamagedDataWarning
            Damaged blocks were left out.
        """
        index = self._index(stream)
        return self._data(index, self._file.read(index, start_s, stop_s, step))

    def blocks(
        self, stream: str, frames: int = 4096, *, start_s: float | None = None, stop_s: float | None = None
    ) -> Iterator[Data]:
        """Iterate over a stream without holding all of it.

        Parameters
        ----------
        stream : str
            Name of the stream.
        frames : int
            Least number of frames in a block but the last; blocks of the file are not split.
        start_s, stop_s : float, optional
            As in `read`.

        Yields
        ------
        Data
            The next frames.

        Raises
        ------
        KeyError, BadInputError, IoFailedError
            As in `read`.
        """
        index = self._index(stream)
        for block in self._file.blocks(index, frames, start_s, stop_s):
            yield self._data(index, block)

    def to_csv(self, folder: Path, *, overwrite: bool = False, progress: Progress = None) -> list[str]:
        """Write each stream, and the events, as a CSV file.

        Parameters
        ----------
        folder : str or os.PathLike
            Made when it is missing.
        overwrite : bool
            Write over files that are there already.
        progress : callable, optional
            Called with the frames done and all frames, at most ten times a second.

        Returns
        -------
        list of str
            The files; they appear together.

        Raises
        ------
        RefusedError
            A file is there already.
        IoFailedError
            A file cannot be written.
        """
        return self._file.to_csv(folder, overwrite, progress)

    def to_mcap(
        self,
        path: Path,
        *,
        streams: Sequence[str] | None = None,
        compression: Literal["zstd", "lz4", "none"] = "zstd",
        chunk_mb: float = 4.0,
        overwrite: bool = False,
        progress: Progress = None,
    ) -> McapFile:
        """Write streams and events as an MCAP file, for Foxglove and ROS 2.

        Parameters
        ----------
        path : str or os.PathLike
            The file; it appears when it is complete.
        streams : sequence of str, optional
            Names of the streams. None: all.
        compression : {'zstd', 'lz4', 'none'}
            Of the chunks.
        chunk_mb : float
            Size of a chunk before compression, MiB, 0.01 to 64.
        overwrite : bool
            Write over a file that is there already.
        progress : callable, optional
            Called with the frames done and all frames, at most ten times a second.

        Returns
        -------
        McapFile
            The topics, and the streams that were left out or turned.

        Raises
        ------
        KeyError
            There is no such stream; the text has the names that exist.
        RefusedError
            The file is there already.
        IoFailedError
            The file cannot be written.
        ValueError
            `compression` or `chunk_mb` is none of these.

        Warns
        -----
        DamagedDataWarning
            Damaged blocks were left out.
        """
        if isinstance(streams, str):
            raise TypeError("streams: expected a sequence of names, got a str")
        names = [] if streams is None else list(streams)
        for name in names:
            self._index(name)
        if streams is not None and not names:
            raise ValueError("streams: expected one or more names, got none")
        written = self._file.to_mcap(path, names, compression, chunk_mb, overwrite, progress)
        topics = {
            "topic": np.array(written.pop("topic"), dtype=str),
            "type": np.array(written.pop("type"), dtype=str),
            "messages": written.pop("messages"),
        }
        return McapFile(topics=topics, **written)

    def _index(self, stream: str) -> int:
        if stream not in self._names:
            raise KeyError(
                f"stream: there is no stream {stream!r}; expected one of {', '.join(self._names)}"
            )
        return self._names.index(stream)

    def _data(self, index: int, read: tuple[Any, ...]) -> Data:
        about = self._about["streams"][index]
        time_s, time_ns, source_time_s, values, damaged = read
        return Data(time_s, time_ns, source_time_s, values, about["unit"], about["columns"], damaged)


def open(path: Path) -> Recording:
    """Open a recording for reading.

    Parameters
    ----------
    path : str or os.PathLike
        A .teleta file.

    Returns
    -------
    Recording
        To be closed, or used in a with statement.

    Raises
    ------
    NotFoundError
        There is no such file.
    BadInputError
        The file is no recording, or is damaged.
    """
    return Recording(path)


def read_frames(
    path: Path,
    *,
    rows: int | None = None,
    columns: int | None = None,
    rate_hz: float | None = None,
    array: str | None = None,
    frame_axis: str | None = None,
    taxel_columns: str | None = None,
    time_column: str | None = None,
    time_unit: str | None = None,
) -> Data:
    """Read the frames of a tactile array from a file, whatever its name.

    Parameters
    ----------
    path : str or os.PathLike
        CSV with the columns time_s,t0,t1,...; a recording, whose first array is read; npy, npz, HDF5,
        a MAT file, a recording of Tekscan in ASCII, or a table of another program.
    rows, columns : int, optional
        Size of the array. None: that of the file, or a known array with as many taxels, or the most
        nearly square one.
    rate_hz : float, optional
        Frames per second of a file without times.
    array : str, optional
        Name of the frames in a file of several arrays. None: frames, or the only one of three dimensions.
    frame_axis : {"first", "last"}, optional
        Dimension that counts the frames. None: the first, or the one with as many entries as time_s;
        of a MAT file only the latter.
    taxel_columns : str, optional
        Columns of a table of another program that are taxels, from 1, such as "2..85".
    time_column : str, optional
        Name or number of its column of times.
    time_unit : {"s", "ms", "us", "ns", "iso"}, optional
        Unit of these times. None: as the name of the column ends.

    Returns
    -------
    Data
        With values (frames, rows, columns) float32 and their times.

    Raises
    ------
    NotFoundError, BadInputError
        With line and column of a CSV.
    ValueError
        Only one of rows and columns is given, or one is out of range.

    Examples
    --------
    >>> import os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "frames.csv")
    >>> import numpy as np
    >>> np.savetxt(path, [[0.0, 1, 2], [0.1, 3, 4]], delimiter=",", header="time_s,t0,t1", comments="")
    >>> read_frames(path, rows=1, columns=2).values
    array([[[1., 2.]],
    <BLANKLINE>
           [[3., 4.]]], dtype=float32)
    """
    if _core.is_recording(path):
        with Recording(path) as recording:
            arrays = [name for name, stream in recording.streams.items() if stream.kind == "array"]
            if not arrays:
                raise KeyError(f"path: the recording has no array; its streams are {recording._names}")
            return recording.read(arrays[0])
    time_s, values, unit = _core.read_frames(
        path,
        {
            "rows": rows,
            "columns": columns,
            "rate_hz": rate_hz,
            "array": array,
            "frame_axis": frame_axis,
            "taxel_columns": taxel_columns,
            "time_column": time_column,
            "time_unit": time_unit,
        },
    )
    time_ns = np.rint(time_s * 1e9).astype(np.int64)
    return Data(time_s, time_ns, time_s.copy(), values, unit, (), 0)
