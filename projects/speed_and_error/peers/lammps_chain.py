"""LAMMPS on the chain, by steps of equal length; its own report of the loop is the time.

LAMMPS is built for millions of particles of many laws in space.  It is compared since people
compute granular chains with such codes.  `fix nve` is the usual scheme, of order one with viscous
forces, `fix mvv/dpd 1.0` one of order two.  A tolerance is a step in units of time here.
"""

import re
from functools import partial

import numpy as np

from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.lammps_run import find_lammps, run_lammps
from granular_fronts.scenes.chain import Chain
from peers.runs import Run

NAME = "chain"


def solve(system, step, _atol, integrator):
    """Let LAMMPS move a chain that is pressed at its left end."""
    command = find_lammps()
    if not command:
        return Run(message="the command lmp of LAMMPS is not on the path", absent=True)
    if abs(round(system.end / step) * step - system.end) > 1e-9 * system.end:
        return Run(message=f"no whole number of steps {step:g} ends at {system.end:g}")
    deck = write_deck(NAME, "front initiation", Chain.read(system.scene()), system.end)
    result, report = run_lammps(command, NAME, deck, step, integrator)
    x, velocity = result.x[-1], result.v[-1]
    fields = {"relative_displacement": np.append(x[:-1] - x[1:], 0.0), "velocity": velocity}
    seconds = float(re.search(r"^Loop time of (\S+) on 1 procs", report, re.MULTILINE).group(1))
    share = float(re.search(r"^(\S+)% CPU use", report, re.MULTILINE).group(1))
    return Run(fields, seconds, 0.01 * share * seconds)


METHODS = {
    "lammps_nve": partial(solve, integrator="nve"),
    "lammps_mvv": partial(solve, integrator="mvv"),
}
