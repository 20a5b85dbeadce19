"""Run LAMMPS on an input file that `lammps_deck` wrote, and read what it leaves."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from granular_fronts.errors import SolveError
from granular_fronts.referee.results_files import read_result


def find_lammps():
    """Return the command ``lmp`` from the folder of this Python or from the path, or None."""
    near = Path(sys.executable).with_name("lmp")
    return str(near) if near.exists() else shutil.which("lmp")


def run_lammps(command, name, deck, step, integrator="nve"):
    """Return the `Result` that LAMMPS computes from a deck, and what it prints, its version first.

    The integrator is "nve" or "mvv", ``fix nve`` or ``fix mvv/dpd``; a SolveError quotes what
    LAMMPS says if it fails.
    """
    options = {"step": repr(step), "integrator": integrator}
    variables = [word for key, value in options.items() for word in ("-var", key, value)]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, f"{name}.lmp").write_text(deck, encoding="utf-8")
        process = subprocess.run(
            [command, "-in", f"{name}.lmp", *variables],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
        if process.returncode:
            lines = process.stdout.splitlines()
            said = [line for line in lines if line.startswith("ERROR")] or lines[-1:]
            raise SolveError(f"LAMMPS failed: {' '.join(said)}")
        return read_result(Path(folder, f"{name}_{step!r}.dump"), [name]), process.stdout
