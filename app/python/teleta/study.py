# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics of user studies in which patterns are identified."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, Mapping, Sequence

import numpy as np

from . import _core

if TYPE_CHECKING:
    import numpy.typing as npt

    from ._types import Path, Table

__all__ = [
    "InformationTransfer",
    "Results",
    "analyze",
    "clopper_pearson",
    "information_transfer",
    "repeated_anova",
    "wilson",
]


@dataclass(frozen=True)
class Results:
    """Tables of a study, with the columns of the CSV files of `teleta study analyze`.

    Attributes
    ----------
    summary : dict of str to ndarray
        A row a participant and condition: accuracy and its intervals, information transfer, times.
    group : dict of str to ndarray
        A row a task and condition, all participants together.
    confusion : dict of str to ndarray
        A row a pair of presented and answered pattern.
    anova : dict of str to ndarray
        A row an effect.
    """

    summary: Table
    group: Table
    confusion: Table
    anova: Table


@dataclass(frozen=True)
class InformationTransfer:
    """Information that answers carry about the patterns, bit.

    Attributes
    ----------
    it_bits : float
        As counted; too high on average.
    it_bias_bits : float
        What is taken off.
    it_corrected_bits : float
        Without bias; can be below 0.
    it_few_trials : bool
        Too few trials for more than a rough value.
    """

    it_bits: float
    it_bias_bits: float
    it_corrected_bits: float
    it_few_trials: bool


def analyze(
    path_or_table: Path | Sequence[Path] | Mapping[str, npt.ArrayLike],
    out: Path | None = None,
    *,
    mode: Literal["run", "pilot", "simulated"] | None = None,
) -> Results:
    """Compute confusion matrices, accuracies, information transfer and analyses of variance.

    Parameters
    ----------
    path_or_table : str, os.PathLike, a sequence of them, or dict of str to array_like
        Folders of studies, CSV files of trials, or a table with a row a trial: participant_id, task,
        condition, stimulus, response ('', 'NA' or 'NONE': no answer in time), and if known phase
        ('practice' or 'test') and response_time_s, s.
    out : str or os.PathLike, optional
        Folder for what `teleta study analyze --out` writes: report, tables, figures.
    mode : {'run', 'pilot', 'simulated'}, optional
        Only data of this mode; different modes are not merged. For files.

    Returns
    -------
    Results
        Its tables.

    Raises
    ------
    BadInputError, NotFoundError
        With line and column: a file cannot be read, or there are no completed trials.
    RefusedError
        Modes are mixed, or trials are counted twice.

    Examples
    --------
    >>> results = analyze(
    ...     {
    ...         "participant_id": ["P1"] * 4 + ["P2"] * 4,
    ...         "task": ["shape"] * 8,
    ...         "condition": ["static"] * 8,
    ...         "stimulus": ["A", "A", "B", "B"] * 2,
    ...         "response": ["A", "A", "B", "A", "A", "B", "B", "B"],
    ...     }
    ... )
    >>> results.summary["accuracy"]
    array([0.75, 0.75])
    """
    if isinstance(path_or_table, Mapping):
        needed = ("participant_id", "task", "condition", "stimulus", "response")
        missing = [name for name in needed if name not in path_or_table]
        if missing:
            raise KeyError(f"path_or_table: the table has no column {', '.join(missing)}")
        return Results(**_core.study_analyze(dict(path_or_table), out, mode))
    single = not isinstance(path_or_table, (list, tuple))
    paths = [path_or_table] if single else list(path_or_table)  # type: ignore[arg-type]
    return Results(**_core.study_analyze(paths, out, mode))


def information_transfer(matrix: npt.ArrayLike, *, alternatives: int | None = None) -> InformationTransfer:
    """Compute the information that the answers of one matrix carry about the patterns.

    Parameters
    ----------
    matrix : array_like, (k, k) or (k, k + 1)
        How often each pattern (row) was answered as each (column); a last column counts trials without
        an answer.
    alternatives : int, optional
        Number of patterns to choose from, if the matrix has fewer.

    Returns
    -------
    InformationTransfer
        In bit.

    Raises
    ------
    RefusedError
        The matrix has no trials.
    ValueError
        It is no matrix of counts.

    Examples
    --------
    >>> information_transfer([[10, 0], [0, 10]]).it_bits
    1.0
    """
    return InformationTransfer(**_core.study_information_transfer(matrix, alternatives or 0))


def wilson(k: int, n: int, confidence: float = 0.95) -> tuple[float, float]:
    """Return Wilson's score interval of a proportion.

    Parameters
    ----------
    k, n : int
        Successes and trials.
    confidence : float
        Between 0 and 1.

    Returns
    -------
    low, high : float
        Ends of the interval.

    Raises
    ------
    ValueError
        Not 0 <= k <= n, n is 0, or the confidence is out of range.

    Examples
    --------
    >>> low, high = wilson(15, 20)
    >>> round(low, 4), round(high, 4)
    (0.5313, 0.8881)
    """
    return _core.study_wilson(k, n, confidence)


def clopper_pearson(k: int, n: int, confidence: float = 0.95) -> tuple[float, float]:
    """Return the exact interval of Clopper and Pearson of a proportion.

    Parameters
    ----------
    k, n, confidence
        As in `wilson`.

    Returns
    -------
    low, high : float
        Ends of the interval.

    Raises
    ------
    ValueError
        As in `wilson`.

    Examples
    --------
    >>> low, high = clopper_pearson(0, 10)
    >>> low, round(high, 4)
    (0.0, 0.3085)
    """
    return _core.study_clopper_pearson(k, n, confidence)


def repeated_anova(
    table: Mapping[str, npt.ArrayLike], *, value: str = "value", participant: str = "participant_id"
) -> Table:
    """Analyse variance with repeated measures over one or two factors.

    Parameters
    ----------
    table : dict of str to array_like
        A row a participant and cell of the design: the participant, the value, and one or two more
        columns, which are the factors.
    value : str
        Name of the column of values.
    participant : str
        Name of the column of participants.

    Returns
    -------
    dict of str to ndarray
        A row an effect: effect (str), df1, df2, ss, ss_error, f, p, eps_gg, p_gg, eps_hf, p_hf,
        partial_eta2, generalized_eta2 (float64, NaN where not defined), n, dropped (int64: participants
        with and without complete data), note (str: why there is no F).

    Raises
    ------
    RefusedError
        There is no analysis of such data; the text says why.
    KeyError, ValueError
        The table does not have these columns, or a cell has two values.

    Examples
    --------
    >>> people, levels = ["P1", "P1", "P2", "P2", "P3", "P3"], ["a", "b"] * 3
    >>> table = {"participant_id": people, "level": levels, "value": [1.0, 2.0, 2.0, 4.0, 3.0, 4.0]}
    >>> float(repeated_anova(table)["f"][0].round(6))
    16.0
    """
    columns = {name: np.asarray(column) for name, column in table.items()}
    for name in (value, participant):
        if name not in columns:
            raise KeyError(f"table: there is no column {name!r}; it has {', '.join(columns)}")
    factors = [name for name in columns if name not in (value, participant)]
    if not 1 <= len(factors) <= 2:
        raise ValueError(f"table: expected one or two factors, got {factors}")
    rows = len(columns[value])
    if any(column.shape != (rows,) for column in columns.values()):
        raise ValueError("table: expected columns of one length")
    places = []
    sizes = []
    for name in (participant, *factors):
        levels, place = np.unique(columns[name], return_inverse=True)
        places.append(place)
        sizes.append(len(levels))
    cells = np.full(sizes, np.nan)
    counts = np.zeros(sizes, dtype=int)
    np.add.at(counts, tuple(places), 1)
    if counts.max(initial=0) > 1:
        raise ValueError("table: expected one value a participant and cell, got several")
    cells[tuple(places)] = columns[value]
    return _core.study_repeated_anova(cells, factors[0], factors[1] if len(factors) == 2 else "")
