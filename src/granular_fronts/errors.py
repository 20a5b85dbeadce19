"""Errors as sentences for people: the one place where the classes of errors are defined.

A message names what was found, the limit it breaks and the way out.  The classes say who can help:
an `InputError` is cured by another argument or configuration, a `SolveError` says where a
computation ended that looked possible when it began.  Both are kinds of `ValueError`.  A
`NoSpaceError` is no fault of either, and a kind of `OSError`.
"""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


class InputError(ValueError):
    """An argument, or a configuration, that cannot be computed: its value, limit and way out."""


class SolveError(ValueError):
    """A solve that stopped: where, and why."""


class NoFrontError(SolveError):
    """A front that was not found, and why."""


class NoSpaceError(OSError):
    """A file that did not fit on its disk: in which folder."""

    def __init__(self, folder: Path | str):
        super().__init__(
            f"There is no space left in {folder}: free some and run the same command again."
        )


def end_with_reader() -> None:
    """Let a program end in silence, as others do, when nobody reads on: ``… | head``."""
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)


@contextmanager
def exit_on_error(heading: str) -> Iterator[None]:
    """End the program with a heading and the sentences of an InputError, if one is raised."""
    try:
        yield
    except InputError as error:
        sys.exit(f"{heading}\n{error}")
