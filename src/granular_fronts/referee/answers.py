"""Accurate answers to the problems, each with its error, as netCDF and CSV.

A problem is solved by the chain's integrator, and again with two steps for each.  The largest
difference is the error (see `chain.simulate`).  The number that depends on the damping
(`measurements`) is computed at several dampings around the given one, of either solution.  So a
result can be compared with each.
"""

import csv
import io
from functools import partial

import numpy as np
import pandas as pd
import xarray as xr

from granular_fronts.accuracy import error_attributes, refined_by
from granular_fronts.chain import simulate
from granular_fronts.chain.simulate import ERROR_METHOD
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.referee.measurements import NAMES, read_motion
from granular_fronts.referee.problems import ALPHA
from granular_fronts.scenes.chain import Chain

LAST_BEADS = 3  # whose velocities at the end are listed


def solve(problem):
    """Return the accurate answer to a problem.

    `relative_displacement` is on (t, contact) and `velocity` on (t, bead).  `reading` is on
    (factor,), dampings over γ; `value` and `value_error` are on (quantity,).
    """
    motion = simulate.simulate_chain(problem.scene, problem.name)
    t, u, v = states(problem, motion)
    readings, refined = np.transpose([_read_at(problem, factor) for factor in problem.factors])
    names, values, errors = zip(*_quantities(problem, motion), strict=True)
    field = {
        name: {key: motion[f"{name}_grid"].attrs[key] for key in ("error_estimate", "error_method")}
        for name in ("relative_displacement", "velocity")
    }
    measurement = error_attributes(readings, refined, ERROR_METHOD)
    measurement["long_name"] = NAMES[problem.motion]
    stated = {"error_estimate": float(max(errors)), "error_method": "see value_error"}
    return xr.Dataset(
        {
            "relative_displacement": (("t", "contact"), u, field["relative_displacement"]),
            "velocity": (("t", "bead"), v, field["velocity"]),
            "reading": ("factor", readings, measurement),
            "value": ("quantity", list(values), stated),
            "value_error": ("quantity", list(errors)),
        },
        {
            "t": t,
            "contact": np.arange(1, u.shape[1] + 1),
            "bead": np.arange(1, v.shape[1] + 1),
            "factor": [*problem.factors],
            "quantity": list(names),
        },
    )


def states(problem, motion):
    """Return the times, relative displacements and velocities of all states."""
    u = motion["relative_displacement_grid"].values
    u = u if problem.wall else u[:, :-1]
    return motion["t_grid"].values, u, motion["velocity_grid"].values


def _read_at(problem, factor):
    """Return the number that depends on the damping at a factor times γ, by both solutions."""
    law = problem.scene.law.with_damping(factor)
    scene = Chain.read(problem.scene.plain() | {"law": law}, problem.name)
    motions = refined_by(partial(simulate.refine, scene), simulate.solve(scene))
    return motions.map(lambda motion: read_motion(problem, *states(problem, motion.dataset)))


def _quantities(problem, motion):
    """Names, values and errors of single numbers."""

    def recorded(name):
        return float(motion[name]), float(motion[name].attrs["error_estimate"])

    velocities = motion["velocity_grid"].isel(t_grid=-1)
    error = float(velocities.attrs["error_estimate"])
    yield "largest relative displacement", *recorded("largest_relative_displacement")
    if np.isfinite(motion["first_gap_time"]):
        yield "time of the first gap", *recorded("first_gap_time")
        yield "contact of the first gap", *recorded("first_gap_bead")
    for bead in motion["bead"].values[-LAST_BEADS:]:
        yield f"velocity of bead {bead} at the end", float(velocities.sel(bead=bead)), error
    if problem.motion == "solitary_wave":
        coarse, fine = (solitary_wave(ALPHA, points) for points in (16, 32))
        value, other = (wave.u.max() ** -0.25 for wave in (fine, coarse))
        yield NAMES[problem.motion], value, abs(value - other) + fine.residual


def table_of(answers):
    """Return all single numbers of some answers, a mapping by names of problems, as CSV."""
    rows = [
        {"problem": name, "quantity": quantity, "value": float(value), "error": f"{error:.1e}"}
        for name, answer in answers.items()
        for quantity, value, error in zip(
            *(answer[key].values for key in ("quantity", "value", "value_error")), strict=True
        )
    ]
    return pd.DataFrame(rows).to_csv(index=False)


def problems_of(table):
    """Return the names of the problems of a table, each once."""
    return list(dict.fromkeys(row["problem"] for row in csv.DictReader(io.StringIO(table))))


def rows_of_states(answer):
    """Return the rows of the states that are listed: four, a quarter of the motion apart."""
    return [answer.sizes["t"] * part // 4 for part in (1, 2, 3)] + [answer.sizes["t"] - 1]


def states_of(answer):
    """Return four states as CSV: t, bead, u of its right contact, v, error."""
    fields = answer["relative_displacement"], answer["velocity"]
    error = max(field.attrs["error_estimate"] for field in fields)
    states = (answer.isel(t=row) for row in rows_of_states(answer))
    columns = [
        {
            "t": float(state["t"]),
            "bead": state["bead"].values,
            "u": np.append(state["relative_displacement"], 0.0)[: state.sizes["bead"]],
            "v": state["velocity"].values,
            "error": f"{error:.1e}",
        }
        for state in states
    ]
    return pd.concat(map(pd.DataFrame, columns)).to_csv(index=False)
