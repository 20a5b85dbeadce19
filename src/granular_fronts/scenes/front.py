"""Scenes of the family ``front``: an exact front and a driven chain, section 6."""

from collections.abc import Iterator, Mapping

from granular_fronts.scenes.limits import (
    COLUMNS_PER_ROW,
    NUMBERS_PER_BEAD,
    SECONDS_PER_CROSSING,
    Part,
    grid_part,
    points_of,
)
from granular_fronts.scenes.sections import Need, Section


def _size_of_front(scene: Mapping) -> Iterator[Part]:
    """An exact front on a window, and a chain driven up to a bead."""
    numbers, bead = 6.0 * COLUMNS_PER_ROW * points_of(scene["window"]), float(scene["driven_bead"])
    yield grid_part(("window.stop",), ("window.step",), numbers)
    # On its way the front sets one bead after the other in motion.
    seconds = 0.5 * bead * bead * SECONDS_PER_CROSSING
    yield Part(("driven_bead",), (), NUMBERS_PER_BEAD * bead, seconds)


FRONT = Section(
    size=_size_of_front,
    needs=(Need("underdamped.window", "figure 9"), Need("overdamped.window", "figure 9")),
)
