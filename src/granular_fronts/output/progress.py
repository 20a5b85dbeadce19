"""Progress bars: on a terminal, and in the page of a notebook; nowhere else.

A bar appears when its work has lasted `DELAY` seconds, and says what is solved for which scene.  It
is drawn by tqdm: with widgets in a notebook that has them (package ipywidgets), in text otherwise.
Where messages go into a file or a pipe, nothing is shown.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tqdm import tqdm

DELAY = 2.0
"""Seconds of work before a bar appears."""

SIGNIFICANT_DIGITS = 3
"""Digits of the end time; a time on the way has as many decimal places."""


def count_bar(description: str, total: int, unit: str) -> tqdm:
    """Return a bar over a number of things, a context that has a method ``update(count)``."""
    return _bar(total=total, desc=description, unit=unit)


def counted(items: Iterable, description: str, unit: str) -> Iterator:
    """Pass items through and count them on a bar."""
    items = list(items)
    with count_bar(description, len(items), unit) as bar:
        for item in items:
            yield item
            bar.update()


@contextmanager
def time_bar(description: str, end_time: float) -> Iterator[Callable[[float], None]]:
    """A bar over the time of a motion, rounded to a few digits of the end time, above 0.

    It gives a function to be called with the time that is passed.
    """
    # An end time in [100, 1000) and above is shown without decimals, one in [1, 10) with two.
    decimals = max(0, SIGNIFICANT_DIGITS - 1 - math.floor(math.log10(end_time)))
    times = f"t = {{n:.{decimals}f}} of {{total:.{decimals}f}}"
    style = f"{{desc}}: {{percentage:3.0f}}%|{{bar}}| {times} [{{elapsed}}<{{remaining}}]"
    with _bar(total=float(end_time), desc=description, bar_format=style) as bar:
        yield lambda time: bar.update(min(time, end_time) - bar.n)
        # Sums of differences may miss the end by their rounding, and tqdm calls that a failure.
        bar.update(bar.total - bar.n)


def _bar(**settings: Any) -> tqdm:
    """Return the bar of a notebook where one runs, or else of a terminal."""
    in_notebook = "ipykernel" in sys.modules
    if in_notebook and _has_widgets():
        from tqdm.notebook import tqdm
    else:
        from tqdm import tqdm
    # None leaves out the bar where the messages do not go to a terminal.
    return tqdm(delay=DELAY, disable=False if in_notebook else None, **settings)


def _has_widgets() -> bool:
    """Return whether widgets are installed, without which tqdm has no bar for notebooks."""
    from importlib.util import find_spec

    return find_spec("ipywidgets") is not None
