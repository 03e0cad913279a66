# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions and warnings of the package."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """A failure that the package reports.

    Attributes
    ----------
    message : str
        What happened, a sentence without the place.
    kind : str
        'bad_input', 'not_found', 'io_failed', 'refused' or 'unavailable'.
    file : str or None
        The file that the error is in.
    line, column : int or None
        The place in that file, counted from 1.
    expected : str or None
        What was expected instead.
    """

    kind = "bad_input"

    def __init__(
        self,
        message: str,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        expected: str | None = None,
    ) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.line = line
        self.column = column
        self.expected = expected

    def __str__(self) -> str:
        places = [str(part) for part in (self.file, self.line, self.column) if part is not None]
        text = ":".join(places) + ": " if places else ""
        text += self.message
        return f"{text} (expected {self.expected})" if self.expected else text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.file, self.line, self.column, self.expected)


class BadInputError(Error, ValueError):
    """A file or a value is wrong."""

    kind = "bad_input"


class NotFoundError(Error, FileNotFoundError):
    """A file or a name does not exist."""

    kind = "not_found"


class IoFailedError(Error, OSError):
    """Reading or writing failed."""

    kind = "io_failed"


class RefusedError(Error, ValueError):
    """The request is well-formed but cannot be answered."""

    kind = "refused"


class UnavailableError(Error, ConnectionError):
    """A service is not there now."""

    kind = "unavailable"


class DamagedDataWarning(UserWarning):
    """Damaged blocks of a recording were left out."""


_CLASSES: dict[str, type[Error]] = {
    each.kind: each for each in (BadInputError, NotFoundError, IoFailedError, RefusedError, UnavailableError)
}


def error_of(
    kind: str,
    message: str,
    file: str | None,
    line: int | None,
    column: int | None,
    expected: str | None,
) -> Error:
    """Return the exception for an error of the extension modules."""
    return _CLASSES[kind](message, file, line, column, expected)
