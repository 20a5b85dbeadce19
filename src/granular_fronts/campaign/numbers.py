"""Numbers inside a law or a scene, by their paths.

A path joins keys and places in lists, counted from 1: ``beads.mass.cell.2``.  The grid of a
campaign calls a number by a name that data can have, ``beads_mass_cell_2``.
"""

import copy
from collections.abc import Iterator, Mapping
from typing import Any

Path = tuple[str | int, ...]


def number_paths(value: Any, path: Path = ()) -> Iterator[Path]:
    """Return the keys and indices that lead to each number inside a value."""
    if isinstance(value, Mapping | list):
        items = value.items() if isinstance(value, Mapping) else enumerate(value)
        for key, inside in items:
            yield from number_paths(inside, (*path, key))
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield path


def dotted(path: Path) -> str:
    """Return what an axis calls a number."""
    return ".".join(str(key + 1 if isinstance(key, int) else key) for key in path)


def name_in_grid(axis: str) -> str:
    """Return what the grid calls the number of an axis."""
    return axis.replace(".", "_")


def with_numbers(given: Mapping[str, Any], point: Mapping[str, Any]) -> dict[str, Any]:
    """Return a law or a scene with the numbers of a point, by their names in the grid.

    A parameter of a potential that the law leaves out is added to it.
    """
    changed: Any = copy.deepcopy(given)
    places = {name_in_grid(dotted(path)): path for path in number_paths(given)}
    for name, number in point.items():
        value, holder = float(number), changed
        *way, key = places.get(name, name.split("_", 1))
        for step in way:
            if isinstance(holder, dict) and holder.get(step) is None:
                holder[step] = {}
            holder = holder[step]
        # Counts, places and seeds are whole.
        is_whole = name in places and isinstance(holder[key], int) and value.is_integer()
        holder[key] = int(value) if is_whole else value
    return changed


def law_at(law: Mapping[str, Any], point: Mapping[str, Any]) -> dict[str, Any]:
    """Return the law of a campaign at a point, which has numbers of its own beside it."""
    inside = {name for name in point if name.startswith(("elastic_", "viscous_"))}
    return with_numbers(law, {name: point[name] for name in inside})
