"""Exceptions: one for each error code of the library."""

from __future__ import annotations


class Error(Exception):
    """Base of all errors that abut raises on purpose.

    The text is one sentence: what happened, where, the value, what to do. `code` is the exit code
    that the command-line tool has for errors of this kind.
    """

    code: int = 1


class UnexpectedError(Error, RuntimeError):
    """A fault of abut itself."""


class UsageError(Error, ValueError):
    """An option out of range, or an algorithm that does not support what was asked."""

    code = 2


class InputError(Error, ValueError):
    """Elements that are not valid, or a file that cannot be read as such."""

    code = 3


class InputTypeError(Error, TypeError):
    """An argument of a type that is not taken, such as complex numbers as positions."""

    code = 3


class LimitError(Error, MemoryError):
    """A limit or the memory would be exceeded; raised before anything is allocated."""

    code = 4


class OutputError(Error, OSError):
    """The output cannot be written."""

    code = 5


class UnavailableError(Error, RuntimeError):
    """A device, library or instruction set that was asked for is not there."""

    code = 6


class CheckError(Error, AssertionError):
    """A verification found a difference."""

    code = 7


class Cancelled(Error, KeyboardInterrupt):
    """The progress function returned False."""

    code = 130


BY_CODE: dict[int, type[Error]] = {
    kind.code: kind
    for kind in (
        UnexpectedError,
        UsageError,
        InputError,
        LimitError,
        OutputError,
        UnavailableError,
        CheckError,
        Cancelled,
    )
}


# Shown as what they are imported from.
for _kind in (Error, InputTypeError, *BY_CODE.values()):
    _kind.__module__ = "abut"


def made(code: int, sentence: str) -> Error:
    """Makes the error for a code of the library; called by the compiled module."""
    return BY_CODE.get(code, UnexpectedError)(sentence)
