"""The scene of a point of a motion, and what is wrong with a scene and the numbers that vary it."""

import copy
import difflib
import itertools
from collections.abc import Iterator, Mapping
from typing import Any

from granular_fronts.errors import InputError
from granular_fronts.scenes.validation import check_scene


def _numbers(value: Any, path: tuple = ()) -> Iterator[tuple]:
    """Paths of all numbers in a scene."""
    if isinstance(value, Mapping | list):
        items = value.items() if isinstance(value, Mapping) else enumerate(value)
        for key, inside in items:
            yield from _numbers(inside, (*path, key))
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield path


def _axis_of(path: tuple) -> str:
    """Return what an axis calls a number: its keys, and places in lists counted from 1."""
    return ".".join(str(key + 1 if isinstance(key, int) else key) for key in path)


def name_in_grid(axis: str) -> str:
    """Return what the grid calls an axis: ``beads_mass_cell_2`` for ``beads.mass.cell.2``."""
    return axis.replace(".", "_")


def scene_at(scene: Mapping, point: Mapping[str, float]) -> dict[str, Any]:
    """Return a scene with the numbers of a point, by their names in the grid."""
    changed: Any = copy.deepcopy(scene)
    for path in _numbers(scene):
        name = name_in_grid(_axis_of(path))
        if name not in point:
            continue
        *way, key = path
        holder, value = changed, float(point[name])
        for step in way:
            holder = holder[step]
        # Counts, places and seeds are whole.
        whole = isinstance(holder[key], int) and value.is_integer()
        holder[key] = int(value) if whole else value
    return changed


def scene_errors(given: Mapping) -> Iterator[str]:
    """Say that an axis names no number of the scene, or that it has no sensor to measure at."""
    scene, known = given["scene"], [*map(_axis_of, _numbers(given["scene"]))]
    for axis in given["axes"]:
        if axis not in known:
            near = difflib.get_close_matches(axis, known, n=1)
            advice = f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}."
            yield f"axes.{axis} is given, but the scene has no number {axis}: {advice}"
    record = scene.get("record")
    sensors = record.get("sensors") if isinstance(record, Mapping) else None
    named = [*sensors.values()] if isinstance(sensors, Mapping) else []
    if len(named) != 1 or not isinstance(named[0], Mapping) or "contacts" not in named[0]:
        yield (
            f"scene.record.sensors has {len(named)} entries, but must have one, with contacts, at "
            "which numbers are measured: give one sensor with contacts."
        )
    for key in ("fixed", "tolerance"):
        if key in given:
            yield f"{key} is given, but kind motion takes it from its scene: leave it out."


def point_errors(scene: Mapping, grid: Mapping[str, tuple]) -> Iterator[str]:
    """Say what is wrong with the scenes at all corners of the grid."""
    found: dict[str, None] = {}
    for corner in itertools.product(*((values[0], values[-1]) for values in grid.values())):
        try:
            point = dict(zip(grid, corner, strict=True))
            check_scene("chain", scene_at(scene, point), "of the campaign")
        except InputError as error:
            found |= dict.fromkeys(str(error).splitlines())
    yield from found
