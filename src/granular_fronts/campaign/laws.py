"""A campaign's law by the kinds of its potentials, and the numbers of it that vary.

The file gives ``law: {elastic: …, viscous: …}``; an axis ``law.elastic.rate`` varies one of its
numbers.  The grid calls it ``elastic_rate``, a name that data can have.
"""

from collections.abc import Iterator, Mapping

from granular_fronts.errors import InputError
from granular_fronts.model.laws import make_law

PREFIX = "law."
PARTS = ("elastic", "viscous")


def name_of(axis: str) -> str:
    """Name of an axis in the grid: ``elastic_rate`` for ``law.elastic.rate``."""
    return axis.removeprefix(PREFIX).replace(".", "_", 1) if axis.startswith(PREFIX) else axis


def varied_numbers(names) -> list[str]:
    """Return the names of a grid that are numbers of a law."""
    return [name for name in names if name.partition("_")[0] in PARTS]


def law_at(law: Mapping, point: Mapping) -> dict:
    """Return the law of a campaign at one of its points, as a scene would give it."""
    parts = {part: dict(potential) for part, potential in law.items()}
    for name in varied_numbers(point):
        part, _, number = name.partition("_")
        parts.setdefault(part, {})[number] = float(point[name])
    return parts


def errors_of_law(law: Mapping, grid: Mapping) -> Iterator[str]:
    """Say why a law cannot be made at the ends of the axes that vary it."""
    middle = {name: values[0] for name, values in grid.items()}
    found = {}
    for name in [None, *varied_numbers(grid)]:
        for end in (0, -1):
            point = middle | ({} if name is None else {name: grid[name][end]})
            try:
                make_law(law_at(law, point))
            except InputError as error:
                found[f"law: {error}"] = None
    yield from found
