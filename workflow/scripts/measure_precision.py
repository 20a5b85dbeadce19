"""Speed against error of the chain's integrators: ours and other people's, side by side.

Every method solves the same problem over the same tolerances, in one process and in turns, so that
a slow moment of the machine hits all of them; the least of the repeated times counts. Errors are
measured against the stored long-double states, outside the timing. A method that is not installed
is named and left out.
"""

import os
import platform
import time
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from peers import chain as peers
from tqdm import tqdm

from granular_fronts.chain import plain_forms
from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, prepare, work_done
from granular_fronts.chain.state import make_law
from granular_fronts.datasets import write_dataset
from step import run_step

ABSOLUTE_OVER_RELATIVE = 1.0e-2


def measure_precision(problems: dict, reference: Path, dataset: Path) -> None:
    """Solve every problem by every method over its tolerances, and keep errors and times.

    Parameters
    ----------
    problems : dict
        As under ``precision.chain`` of the configuration.
    reference : Path
        Long-double states, tests/references/chain_reference.nc.
    dataset : Path
        The netCDF file to write, on (problem, method, tolerance).
    """
    load_before = os.getloadavg()[0]
    states = xr.load_dataset(reference)
    rows = [
        {"problem": name} | row
        for name, problem in problems.items()
        for row in measure_problem(name, problem, states)
    ]
    measured = pd.DataFrame(rows).set_index(["problem", "method", "tolerance"]).to_xarray()
    measured["message"] = measured["message"].fillna("").astype(object)
    measured["seconds"].attrs["units"] = "s"
    measured["error"].attrs["error_method"] = "this is the distance to a long-double state"
    own_errors = [reference_error(states, problem) for problem in problems.values()]
    measured["reference_error"] = xr.DataArray(own_errors, {"problem": list(problems)})
    measured.attrs = {
        "machine": f"{platform.machine()}, {os.cpu_count()} cores, Python "
        f"{platform.python_version()}",
        "load_before": load_before,
        "solver": "least wall-clock time of the repeats, one thread",
    }
    write_dataset(measured, dataset, scene_id="precision_chain", config=problems)


def measure_problem(name: str, problem: dict, states: xr.Dataset) -> list[dict]:
    """Errors, times and work of all methods on one problem.

    Parameters
    ----------
    name : str
        Of the problem, for the progress line.
    problem : dict
        One entry of ``precision.chain``.
    states : xarray.Dataset
        Long-double states.

    Returns
    -------
    list of dict
        One for each method and tolerance.
    """
    expected = read_state(states, problem)
    scene = peers.ChainScene(gamma=problem["gamma"], end=problem["end_time"])
    short = peers.ChainScene(gamma=problem["gamma"], end=10.0)
    for method in problem["methods"]:
        METHODS[method](short, 1.0e-4, 1.0e-6)
    rows = []
    for tolerance in tqdm(problem["relative_tolerances"], desc=f"precision, {name}", delay=2.0):
        best = {}
        for _ in range(problem["repeats"]):
            for method in problem["methods"]:
                run = METHODS[method](scene, tolerance, ABSOLUTE_OVER_RELATIVE * tolerance)
                if method not in best or run.seconds < best[method].seconds:
                    best[method] = run
        for method, run in best.items():
            rows.append(
                {
                    "method": method,
                    "tolerance": tolerance,
                    "error": largest_error(run, *expected),
                    "seconds": run.seconds,
                    "right_hand_sides": float(run.right_hand_sides),
                    "message": run.message,
                }
            )
    return rows


def find_state(states, problem):
    """Index of the stored state that a problem ends in."""
    match = (states["gamma"] == problem["gamma"]) & (states["t"] == problem["end_time"])
    found = np.flatnonzero(match)
    if not found.size:
        raise ValueError(
            f"No reference is stored for gamma = {problem['gamma']} at t = {problem['end_time']}: "
            "add it to tests/references/make_chain_reference.py, or choose a stored state."
        )
    return found[0]


def read_state(states, problem):
    """Relative displacements and velocities of the stored state."""
    chosen = states.isel(state=find_state(states, problem))
    return chosen["relative_displacement"].values, chosen["velocity"].values


def reference_error(states, problem):
    """Error of the stored state itself."""
    chosen = states.isel(state=find_state(states, problem))
    return max(float(chosen[f"{name}_error"]) for name in ("relative_displacement", "velocity"))


def largest_error(run, u, velocity):
    """Largest error of u and velocity together, NaN for a run without a result."""
    if not run.u.size:
        return np.nan
    return max(np.abs(run.u - u).max(), np.abs(run.velocity - velocity).max())


def chain_scene(scene):
    """The problem as a scene of this project, recording the final state only."""
    return {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": scene.gamma},
        "beads": scene.beads,
        "boundary": {"kind": "pressure", "left": scene.delta, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": scene.end,
        "record": {"snapshots": [scene.end]},
    }


def run_strain_form(scene, rtol, atol):
    """Our integrator."""
    run = prepare(chain_scene(scene))
    started = time.perf_counter()
    integrate(run, {"relative": rtol, "absolute": atol})
    seconds = time.perf_counter() - started
    state = read_final(run, scene)
    return peers.PeerRun(*state, seconds, work_done(run.clock)["right_hand_sides"])


def read_final(run, scene):
    """U and velocity of a finished run."""
    final = collect(chain_scene(scene), run.recording, run.boundary, run.momentum).isel(t=-1)
    return final["relative_displacement"].values, final["velocity"].values


def run_plain_form(form, scene, rtol, atol):
    """The same pair in (x, w) or (x, ẋ), without window and event location."""
    run = prepare(chain_scene(scene))
    law, rest = make_law(1.5, 1.5, scene.gamma), np.zeros(scene.beads)
    y, ends = plain_forms.pack(form, law, run.boundary, rest, rest)
    started = time.perf_counter()
    y, accepted = plain_forms.integrate_adaptive(form, law, ends, y, 1e-6, scene.end, rtol, atol)
    seconds = time.perf_counter() - started
    state = plain_forms.unpack(form, law, run.boundary, ends, y)
    return peers.PeerRun(*state, seconds, 12 * accepted)


def run_positions_and_w(scene, rtol, atol):
    """The pair in (x, w)."""
    return run_plain_form(plain_forms.XW, scene, rtol, atol)


def run_positions_and_velocities(scene, rtol, atol):
    """The pair in (x, ẋ)."""
    return run_plain_form(plain_forms.XV, scene, rtol, atol)


METHODS = {
    "strain_form": run_strain_form,
    "positions_and_w": run_positions_and_w,
    "positions_and_velocities": run_positions_and_velocities,
    **peers.PEERS,
}


if __name__ == "__main__":
    run_step(measure_precision, globals().get("snakemake"))
