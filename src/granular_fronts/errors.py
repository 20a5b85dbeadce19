"""Classes of errors, whose messages are sentences for people.

A message names the value, the limit that it breaks, and what to do.  An `InputError` asks for
another argument or configuration.  A `SolveError` says where a computation failed that had looked
possible.  Both are kinds of `ValueError`.  A `NoSpaceError`, of a full disk, is a kind of
`OSError`.
"""

import signal
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path


class InputError(ValueError):
    """An argument or a configuration that cannot be computed."""


def raise_if_any(sentences: Sequence[str]) -> None:
    """Raise an InputError of some sentences, one a line, if there are any."""
    if sentences:
        raise InputError("\n".join(sentences))


class SolveError(ValueError):
    """A solve that stopped; the message says where and why."""


class NoFrontError(SolveError):
    """A front that was not found; the message says why."""


class NoSpaceError(OSError):
    """A file that did not fit on its disk; the message names the folder."""

    def __init__(self, folder: Path | str):
        super().__init__(
            f"There is no space left in {folder}: free some and run the same command again."
        )


def end_with_reader() -> None:
    """Let a program end in silence, as others do, when nobody reads on: ``… | head``."""
    if hasattr(signal, "SIGPIPE"):  # Windows has none.
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)


@contextmanager
def exit_on_error(heading: str) -> Iterator[None]:
    """End the program with a heading and the sentences of an InputError, if one is raised."""
    try:
        yield
    except InputError as error:
        sys.exit(f"{heading}\n{error}")
