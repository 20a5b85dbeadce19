"""Codes that are installed move the beads of their decks as our scheme does."""

import shutil
import subprocess

import numpy as np
import pytest
from lammps import LAMMPS

from granular_fronts.referee.decks import write_decks
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.results_files import read_result
from granular_fronts.referee.tolerances import move

PROBLEMS = load_problems()
COMMANDS = {
    "lammps.in": [LAMMPS, "-in", "lammps.in", "-var", "step"],
    "liggghts.in": [shutil.which("liggghts"), "-in", "liggghts.in", "-var", "step"],
    "yade.py": [shutil.which("yade"), "-n", "-x", "-j1", "yade.py"],
}


@pytest.mark.slow
@pytest.mark.parametrize("file", COMMANDS)
def test_a_code_moves_as_the_lagged_scheme(file, tmp_path):
    """To rounding in velocities, and in positions up to 10, in every case that has the deck."""
    if not COMMANDS[file][0]:
        pytest.skip(f"There is no code for {file}")
    for name, problem in PROBLEMS.items():
        if deck := write_decks(problem).get(file):
            (tmp_path / file).write_text(deck)
            command = [*COMMANDS[file], "0.1"]
            subprocess.run(
                command, cwd=tmp_path, stdin=subprocess.DEVNULL, capture_output=True, check=True
            )
            [written] = tmp_path.glob(f"{name}_0.1.*")
            found, ours = read_result(written, PROBLEMS), move(problem, 0.1)
            np.testing.assert_allclose(found.v, ours.v, rtol=0, atol=2e-13)
            np.testing.assert_allclose(found.x, ours.x, rtol=0, atol=5e-12)
