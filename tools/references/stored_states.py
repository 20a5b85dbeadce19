"""How long-double states are stored: a value is the nearest double and what it leaves, exactly."""

from pathlib import Path

import numpy as np

from granular_fronts.reference_methods.extended import REAL

REFERENCES = Path(__file__).parents[2] / "tests" / "references"
MEANINGS = {"relative_displacement": "u_n = x_n - x_{n+1}", "velocity": "x_n'"}


def store(data, kept, again):
    """Write longdoubles (u_n, x_n') of some states on (state, bead).

    The error of each is the largest difference from the same states computed again.
    """
    for index, (name, meaning) in enumerate(MEANINGS.items()):
        states, others = (
            np.array([pair[index] for pair in run], dtype=REAL) for run in (kept, again)
        )
        high = states.astype(np.float64)
        low = (states - high).astype(np.float64)
        data[name] = (("state", "bead"), high, {"long_name": meaning, "units": "1"})
        data[f"{name}_low"] = (("state", "bead"), low, {"long_name": "what double leaves of it"})
        data[f"{name}_error"] = ("state", np.abs(states - others).max(axis=1).astype(float))
        print(name, data[f"{name}_error"].values)
