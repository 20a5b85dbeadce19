"""A problem with its answer, and how far a run is from it."""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from peers.runs import Run


class Reference(NamedTuple):
    """The answer for one field."""

    values: np.ndarray  # nearest doubles
    low: np.ndarray  # what double leaves of the accurate values
    error: float  # largest error of `values + low`


class Problem(NamedTuple):
    """What is solved, and by whom."""

    ours: str  # the method of this project
    reference: Mapping[str, Reference]  # one for each field of the solution
    methods: Mapping[str, Callable[[float], Run]]  # each takes a tolerance
    # Of methods that the configuration gives grids or steps for.
    tolerances: Mapping[str, Sequence[float]] = MappingProxyType({})

    @property
    def reference_error(self):
        """Largest error of the answer itself."""
        return max(field.error for field in self.reference.values())


def errors_of(run, reference):
    """Return the errors of a run against the answer, at least the error of the answer.

    `error`, the largest of all fields; `below_reference`, whether the answer is too coarse to
    measure it; `<field>_error_sup` and `<field>_error_rms`.  Empty for a run without a result.
    """
    if not run.fields:
        return {}
    errors, largest = {}, 0.0
    for name, expected in reference.items():
        # Of two near doubles the difference is exact.
        difference = (run.fields[name] - expected.values) - expected.low
        sup, rms = np.abs(difference).max(), np.sqrt(np.mean(difference**2))
        errors[f"{name}_error_sup"] = max(sup, expected.error)
        errors[f"{name}_error_rms"] = max(rms, expected.error)
        largest = max(largest, sup)
    limit = max(expected.error for expected in reference.values())
    return {"error": max(largest, limit), "below_reference": float(largest < limit), **errors}


def stored_state(states, family, **wanted):
    """Return the entry of a family's stored reference with the wanted coordinates, or a refusal."""
    same = np.logical_and.reduce([states[name] == value for name, value in wanted.items()])
    if not same.any():
        listed = " and ".join(f"{name} = {value}" for name, value in wanted.items())
        raise ValueError(
            f"No reference is stored for {listed}: add it to "
            f"tools/references/make_{family}_reference.py, or choose a stored one."
        )
    return states.isel(state=int(np.argmax(same)))


def read_reference(state, names):
    """Return the answer of an entry with `<name>`, `<name>_low`, `<name>_error` for each name."""
    return {
        name: Reference(
            state[name].values, state[f"{name}_low"].values, float(state[f"{name}_error"])
        )
        for name in names
    }
