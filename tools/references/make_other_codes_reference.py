"""Motions of short chains by LIGGGHTS and YADE, to compare the half-step scheme with.

Both have one law in common with the package: LIGGGHTS β = 3/2, YADE β = 5/4, the latter as long as
no viscous force exceeds the elastic one, since it allows no attraction. The chains are pressed from
rest; with LIGGGHTS the last contacts open. Their input is written by the package from the scene.

Needs the commands liggghts and yade: apt-get install liggghts yade. Run
``python tools/references/make_other_codes_reference.py --help`` for the command line.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import xarray as xr
from make_lammps_reference import BEADS, REFERENCES, STEP, scene_of

from granular_fronts.referee.decks import write_decks
from granular_fronts.referee.problems import Problem
from granular_fronts.referee.results_files import read_result

GAMMAS = (0.06, 0.3)
STEPS = {"liggghts": 600, "yade": 300}
BETA = {"liggghts": 1.5, "yade": 1.25}
COMMANDS = {
    "liggghts": ["liggghts", "-in", "liggghts.in", "-var", "step", repr(STEP)],
    "yade": ["yade", "-n", "-x", "-j1", "yade.py", repr(STEP)],
}


def run_code(code, gamma):
    """Final positions less those at rest, and final velocities."""
    end_time = STEP * STEPS[code]
    scene = scene_of(BETA[code], gamma, 0.1, 0.0).model_copy(update={"end_time": end_time})
    problem = Problem(
        name="chain",
        motion="front",
        scene=scene,
        displacement=0.1,
        interval=end_time,
        factors=[0.9, 1.0, 1.1],
    )
    with tempfile.TemporaryDirectory() as folder:
        for name, deck in write_decks(problem).items():
            Path(folder, name).write_text(deck)
        process = subprocess.run(COMMANDS[code], cwd=folder, capture_output=True, text=True)
        process.check_returncode()
        [written] = Path(folder).glob("chain_0.1.*")
        result = read_result(written, ["chain"])
    return result.x[-1], result.v[-1]


def main():
    """Run both codes and write what they find."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "other_codes_reference.nc")
    parser.add_argument("--versions", required=True, help="what to name in the file")
    options = parser.parse_args()
    found = [[run_code(code, gamma) for gamma in GAMMAS] for code in COMMANDS]
    xr.Dataset(
        {
            "displacement": (("code", "gamma", "bead"), [[x for x, _ in row] for row in found]),
            "velocity": (("code", "gamma", "bead"), [[v for _, v in row] for row in found]),
            "beta": ("code", [BETA[code] for code in COMMANDS]),
            "steps": ("code", [STEPS[code] for code in COMMANDS]),
        },
        {"code": list(COMMANDS), "gamma": list(GAMMAS), "bead": np.arange(1, BEADS + 1)},
        {"title": options.versions, "step": STEP},
    ).to_netcdf(options.output)
    print(f"{options.output}: {options.versions}")


if __name__ == "__main__":
    main()
