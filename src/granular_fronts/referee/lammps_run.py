"""Run LAMMPS on an input file that `lammps_deck` wrote, and read what it leaves."""

import subprocess
import tempfile
from pathlib import Path

from granular_fronts.errors import SolveError
from granular_fronts.referee.results_files import read_result


def run_lammps(command, name, deck, step, integrator="nve"):
    """The motion that LAMMPS computes, and what it reports.

    Parameters
    ----------
    command : str
        LAMMPS itself, usually ``lmp``.
    name, deck : str
        As `write_deck` took and gave them.
    step : float
        Time step, above 0.
    integrator : {"nve", "mvv"}
        ``fix nve`` or ``fix mvv/dpd``.

    Returns
    -------
    result : Result
        The states that the input file asks for.
    report : str
        What LAMMPS printed; its first line is its version.

    Raises
    ------
    SolveError
        If LAMMPS fails; the sentence quotes its errors.
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
