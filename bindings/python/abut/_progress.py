"""Progress bars as progress functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._errors import InputTypeError

#: Called with the phase, the elements treated in it and their number; False cancels.
ProgressFunction = Callable[[str, int, int], "bool | None"]
#: Such a function, or a class of bars such as tqdm.
Progress = ProgressFunction | type[Any]


class _Bars:
    """A bar for each phase, closed when the next begins or nobody asks any more."""

    def __init__(self, make: Callable[..., Any]) -> None:
        self._make = make
        self._phase = ""
        self._bar: Any = None

    def __call__(self, phase: str, done: int, total: int) -> None:
        if self._bar is None or phase != self._phase:
            self._close()
            self._phase, self._bar = phase, self._make(total=total, desc=phase)
        self._bar.update(done - self._bar.n)

    def _close(self) -> None:
        if self._bar is not None:
            self._bar.close()

    def __del__(self) -> None:
        self._close()


def progress_function(given: Any) -> ProgressFunction | None:
    """The function given, or one that draws bars of the class given, such as tqdm, or of a
    `functools.partial` of such a class."""
    if given is None:
        return None
    if not callable(given):
        raise InputTypeError(f"progress is a function or a class of bars, not {given!r}")
    kind = getattr(given, "func", given)
    if isinstance(kind, type) and hasattr(kind, "update") and hasattr(kind, "close"):
        return _Bars(given)
    return given  # type: ignore[no-any-return]
