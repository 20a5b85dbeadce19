"""Scilab's default `ode` on the chain: the paper's own tool; Scilab itself takes the time.

Traps met: its LSODA stops after 500 steps between two output times, and the limit is lifted here.
It may change to its stiff method, with a dense Jacobian.  After contact loss, at t = 3000, a solve
of half a second then took 50 s (rtol 1e-9). It gets no closer than about 1e-12 at t = 700, whatever
the tolerance.
"""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from peers.runs import Run

SCRIPT = Path(__file__).with_name("scilab.sce")


def run_ode(system, rtol, atol):
    """Run Scilab's `ode` on a vectorised right-hand side."""
    if not shutil.which("scilab-cli"):
        return Run(message="scilab-cli is not on the path", absent=True)
    with tempfile.TemporaryDirectory() as folder:
        start, output = Path(folder) / "start.bin", Path(folder) / "final.bin"
        system.start().astype("<f8").tofile(start)
        settings = {
            "GAMMA": repr(system.gamma),
            "LEFT": repr(system.left),
            "BEADS": str(system.beads),
            "END": repr(system.end),
            "RTOL": repr(rtol),
            "ATOL": repr(atol),
            "START": str(start),
            "OUTPUT": str(output),
        }
        process = subprocess.run(
            ["scilab-cli", "-nb", "-f", str(SCRIPT)],
            env=os.environ | {f"CHAIN_{name}": value for name, value in settings.items()},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )
        if not output.exists():
            said = " ".join((process.stdout + process.stderr).split())
            return Run(message=f"Scilab failed: {said}")
        seconds, cpu_seconds, *state = np.fromfile(output, "<f8")
    return Run(system.observe(np.array(state)), seconds, cpu_seconds)


METHODS = {"scilab_ode": run_ode}
