"""Progress bars: on the terminal, or in the page of a notebook that can show them.

A bar appears when its work has lasted `DELAY` seconds, and says what is solved for which scene.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tqdm import tqdm

DELAY = 2.0
"""Seconds of work before a bar appears."""

SIGNIFICANT_DIGITS = 3
"""Of the end time; a time on the way has as many decimal places."""


def count_bar(description: str, total: int, unit: str) -> tqdm:
    """A bar over a number of things, a context that has a method ``update(count)``.

    Parameters
    ----------
    description : str
        What is done, and for which scene.
    total : int
        How many there are.
    unit : str
        What one of them is called.

    Returns
    -------
    tqdm.tqdm
    """
    return _bar_class()(total=total, desc=description, unit=unit, delay=DELAY)


def counted(items: Iterable, description: str, unit: str) -> Iterator:
    """Pass items through and count them on a bar.

    Parameters
    ----------
    items : iterable
    description, unit : str
        As in `count_bar`.

    Yields
    ------
    object
        The items.
    """
    items = list(items)
    with count_bar(description, len(items), unit) as bar:
        for item in items:
            yield item
            bar.update()


@contextmanager
def time_bar(description: str, end_time: float) -> Iterator[Callable[[float], None]]:
    """A bar over the time of a motion, rounded to a few digits of the end time.

    Parameters
    ----------
    description : str
        What is done, and for which scene.
    end_time : float
        Above 0.

    Yields
    ------
    callable
        To be called with the time that is passed.
    """
    # An end time in [100, 1000) and above is shown without decimals, one in [1, 10) with two.
    decimals = max(0, SIGNIFICANT_DIGITS - 1 - math.floor(math.log10(end_time)))
    times = f"t = {{n:.{decimals}f}} of {{total:.{decimals}f}}"
    style = f"{{desc}}: {{percentage:3.0f}}%|{{bar}}| {times} [{{elapsed}}<{{remaining}}]"
    with _bar_class()(
        total=float(end_time), desc=description, bar_format=style, delay=DELAY
    ) as bar:
        yield lambda time: bar.update(min(time, end_time) - bar.n)


def _bar_class() -> type[tqdm]:
    """The bar of a notebook where one runs and has the widgets for it, else the terminal's."""
    if "ipykernel" in sys.modules and _has_widgets():
        from tqdm.auto import tqdm
    else:
        from tqdm import tqdm
    return tqdm


def _has_widgets() -> bool:
    """Whether widgets are installed; without them `tqdm.auto` warns."""
    from importlib.util import find_spec

    return find_spec("ipywidgets") is not None
