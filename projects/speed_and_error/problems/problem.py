"""A problem with its answer, and how far a run is from it."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.errors import InputError
from peers.runs import Run

FIELDS = ("relative_displacement", "velocity")


class Answer(NamedTuple):
    """The answer for one field."""

    values: np.ndarray  # nearest doubles
    low: np.ndarray  # what double leaves of the accurate values
    error: float  # largest error of `values + low`


class Problem(NamedTuple):
    """What is solved, and by what."""

    answers: Mapping[str, Answer]  # one for each field of the solution
    methods: Mapping[str, Callable[[float], Run]]  # each takes a tolerance, a step, or a number

    @property
    def reference_error(self) -> float:
        """Largest error of the answers themselves."""
        return max(answer.error for answer in self.answers.values())


def error_of(run: Run, problem: Problem) -> float:
    """Return the largest distance to the answers, at least their own error; NaN without a result.

    Of two near doubles the difference is exact.
    """
    distances = [
        float(np.abs((run.fields[name] - answer.values) - answer.low).max())
        for name, answer in problem.answers.items()
        if run.fields
    ]
    return max(*distances, problem.reference_error) if distances else np.nan


def stored_answers(states: xr.Dataset, **wanted: float) -> dict[str, Answer]:
    """Return the stored answers with the wanted coordinates, or refuse in a sentence."""
    same = np.logical_and.reduce([states[name] == value for name, value in wanted.items()])
    if not same.any():
        listed = " and ".join(f"{name} = {value:g}" for name, value in wanted.items())
        raise InputError(
            f"No reference is stored for {listed}: choose a problem of tests/references/README.md."
        )
    state = states.isel(state=int(np.argmax(same)))
    return {
        name: Answer(state[name].values, state[f"{name}_low"].values, float(state[f"{name}_error"]))
        for name in FIELDS
    }
