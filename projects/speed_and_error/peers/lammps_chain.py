"""LAMMPS on the chain, by steps of equal length; its own report of the loop is the time.

LAMMPS is built for millions of particles of many laws in space.  It is compared since people
compute granular chains with such codes.  `fix nve` is the usual scheme, of order one with viscous
forces, `fix mvv/dpd 1.0` one of order two.  A tolerance is a step in units of time here.
"""

import re
import shutil
import sys
from functools import partial
from pathlib import Path

import numpy as np

from granular_fronts.errors import SolveError
from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.lammps_run import run_lammps
from granular_fronts.scenes.chain import Chain
from peers.runs import Run

NAME = "chain"


def solve(system, step, _atol, integrator):
    """Let LAMMPS move a chain that is pressed at its left end."""
    command = find_command()
    if not command:
        message = "the command lmp of LAMMPS is not on the path (see peers-environment.txt)"
        return Run(message=message, absent=True)
    if abs(round(system.end / step) * step - system.end) > 1e-9 * system.end:
        return Run(message=f"no whole number of steps {step:g} ends at {system.end:g}")
    try:
        result, report = run_lammps(command, NAME, _deck_of(system), step, integrator)
    except SolveError as error:
        return Run(message=str(error))
    return Run(
        {
            "relative_displacement": _relative_displacements(result.x[-1]),
            "velocity": result.v[-1],
        },
        **_times_of(report),
        steps=round(system.end / step),
    )


def find_command():
    """Return the command from the folder of this Python or from the path, or None."""
    near = Path(sys.executable).with_name("lmp")
    return str(near) if near.exists() else shutil.which("lmp")


def _deck_of(system):
    """Return the input file, which writes the first and the last state."""
    scene = Chain(
        law={"alpha": 1.5, "beta": 1.5, "gamma": system.gamma},
        beads=system.beads,
        boundary={"kind": "pressure", "left": system.left, "right": 0.0},
        start={"kind": "rest"},
        end_time=system.end,
        tolerance={"relative": 1e-12, "absolute": 1e-14},
        record={"snapshots": []},
    )
    return write_deck(NAME, "front initiation", scene, system.end)


def _relative_displacements(x):
    """Return u_1 … u_N; the last one is at the free end."""
    return np.append(x[:-1] - x[1:], 0.0)


def _times_of(report):
    """Return the times of the loop that LAMMPS reports, without setup and input."""
    seconds = float(re.search(r"^Loop time of (\S+) on 1 procs", report, re.MULTILINE).group(1))
    share = re.search(r"^(\S+)% CPU use", report, re.MULTILINE).group(1)
    return {"seconds": seconds, "cpu_seconds": 0.01 * float(share) * seconds}


METHODS = {
    "lammps_nve": partial(solve, integrator="nve"),
    "lammps_mvv": partial(solve, integrator="mvv"),
}
