"""The points of a chunk solved group by group; a group that fails leaves a reason."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import NamedTuple

import numpy as np
from tqdm.auto import tqdm

from granular_fronts.errors import InputError, SolveError

REASON = "reason"


class Solved(NamedTuple):
    """The answer of a kind to the points of a chunk, arrays of shape (lines, fast[, profile])."""

    values: dict[str, np.ndarray]  # NaN at points that failed
    reasons: np.ndarray  # why a point failed, a text; empty where it is solved
    errors: dict[str, float]  # estimate of the largest absolute error, or NaN
    error_method: str


def solve_groups(
    shape: tuple[int, int],
    sizes: Mapping[str, tuple[int, ...]],
    groups: Iterable[tuple[tuple, Callable[[], dict]]],
    error_method: str,
    activity: str,
) -> Solved:
    """Solve the points of a chunk of some shape (lines, fast).

    `sizes` names what is recorded, with its shape at one point.  A group is the index of its points
    and a function without arguments.  The function returns values and errors (NaN where none is
    estimated) of all that is recorded.  Under ``reason`` it says why single points failed, if any
    did. An InputError or a SolveError is the reason of all points of its group.
    """
    values = {name: np.full((*shape, *size), np.nan) for name, size in sizes.items()}
    reasons, errors = np.full(shape, "", dtype=object), dict.fromkeys(sizes, np.nan)
    total = int(np.prod(shape))
    with tqdm(total=total, desc=activity, unit="point", delay=2.0, disable=None) as bar:
        for members, solve in groups:
            try:
                measured = solve()
            except (InputError, SolveError) as error:
                reasons[members] = str(error)
            else:
                reasons[members] = measured.get(REASON, "")
                for name, value in values.items():
                    value[members], found = measured[name]
                    errors[name] = np.fmax(errors[name], np.fmax.reduce(np.ravel(found)))
            bar.update(np.size(members[0]))
    return Solved(values, reasons, errors, error_method)


def single_points(points: Mapping[str, np.ndarray]) -> Iterator[tuple[tuple, dict]]:
    """Index and parameters of each point of a chunk."""
    for index in np.ndindex(next(iter(points.values())).shape):
        yield index, {name: value[index] for name, value in points.items()}


def groups_along(
    points: Mapping[str, np.ndarray], along: str
) -> Iterator[tuple[tuple, dict[str, float], np.ndarray]]:
    """Points that differ in one parameter only: index, other parameters, values of that one."""
    shape = points[along].shape
    others = [name for name in points if name != along]
    table = np.stack([points[name].ravel() for name in others])
    columns, column_of_point = np.unique(table, axis=1, return_inverse=True)
    for number, column in enumerate(columns.T):
        members = np.unravel_index(np.flatnonzero(column_of_point.ravel() == number), shape)
        yield members, dict(zip(others, map(float, column), strict=True)), points[along][members]
