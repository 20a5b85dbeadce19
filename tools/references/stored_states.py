"""Long-double states computed three times, and how they are stored.

Each state is computed with other sequences of substeps, other numbers of columns and other
tolerances. The largest difference from the kept run is the error stated for it. A value is stored
as the nearest double and the double that is left of it, exact together.
"""

import json
import time
from dataclasses import asdict
from pathlib import Path

import numpy as np
import xarray as xr
from extrapolation import REAL, integrate

REFERENCES = Path(__file__).parents[2] / "tests" / "references"
MEANINGS = {"relative_displacement": "u_n = x_n - x_{n+1}", "velocity": "x_n'"}


def largest_differences(kept, others):
    """Return the largest |difference| of each quantity from the kept state over all other runs."""
    return [
        max(float(np.max(np.abs(part - other[index]))) for other in others)
        for index, part in enumerate(kept)
    ]


def solve_case(make_flow, times, every_settings):
    """Compute one motion with every choice of settings, of which the first is kept.

    Returns a row for each time, {t, state, errors}, and a log: counts of the kept run and
    wall-clock seconds of each.
    """
    runs, seconds = [], []
    for settings in every_settings:
        started = time.perf_counter()
        runs.append(integrate(make_flow(), times, settings))
        seconds.append(round(time.perf_counter() - started, 1))
    rows = []
    for index, instant in enumerate(times):
        kept, *others = [states[index] for states, _ in runs]
        errors = largest_differences(kept, others)
        rows.append({"t": instant, "state": kept, "errors": errors})
    return rows, {"seconds": seconds, **asdict(runs[0][1])}


def in_two_doubles(values):
    """Split longdouble values into a double and the double remainder, exact together."""
    high = values.astype(np.float64)
    return high, (values - high).astype(np.float64)


def store(data, kept, errors):
    """Write longdoubles (u_n, x_n') of some states, and their errors, on (state, bead)."""
    for index, (name, meaning) in enumerate(MEANINGS.items()):
        high, low = in_two_doubles(np.array([state[index] for state in kept], dtype=REAL))
        data[name] = (("state", "bead"), high, {"long_name": meaning, "units": "1"})
        data[f"{name}_low"] = (("state", "bead"), low, {"long_name": "what double leaves of it"})
        data[f"{name}_error"] = ("state", [error[index] for error in errors])


def build_dataset(rows, logs, **attributes):
    """Return the Dataset that is written, from the results of `solve_case`."""
    data = xr.Dataset(
        coords={
            "t": ("state", [row["t"] for row in rows]),
            "bead": np.arange(1, rows[0]["state"][0].size + 1),
        },
        attrs={
            **attributes,
            "log": json.dumps(logs),
            "versions": f"numpy {np.__version__}, xarray {xr.__version__}",
            "error_method": "largest difference from two further runs with other substep "
            "sequences, numbers of columns and tolerances",
        },
    )
    store(data, [row["state"] for row in rows], [row["errors"] for row in rows])
    return data
