"""Ctrl-C ends what runs long, compiled loops too, and nobody sees what was unfinished."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

FOLDERS = [str(Path(__file__).parents[2] / part) for part in ("src", "tests/support")]

LONG = {
    "front": ("gf.solve_front(1.5, 0.3)", "gf.solve_front(1.001, 1e-5)"),
    "chain": (
        "gf.simulate_chain(driven_scene(0.1, 20, 10.0, **PRESSED))",
        "gf.simulate_chain(driven_scene(0.1, 100_000, 1e5, **PRESSED))",
    ),
    "orbit": (
        "gf.heteroclinic(50.0, np.linspace(-5.0, 2.0, 30))",
        "gf.heteroclinic(50.0, np.linspace(-5.0, 2.0, 30_000_000))",
    ),
    "amplitude": ("solve(RING, 1.5, [1.0], 1024, 1e-6)", "solve(RING, 1.5, [1e6], 1024, 1e-10)"),
}
"""For each solver a call that compiles what it needs, and one that takes long."""

SCRIPT = """
import sys
import numpy as np
import granular_fronts as gf
from chains import driven_scene
from granular_fronts.continuum.log_burgers.solution import solve
from granular_fronts.continuum import compilation
from granular_fronts.scenes.ring import Ring

RING = Ring.read(compilation.RING)

# All beads move from the start, and balances are kept.
PRESSED = {{
    "boundary": {{"kind": "pressure", "left": 0.5, "right": 0.5}},
    "record": {{"snapshots": [], "balances": True}},
}}
{short}
print("begins", flush=True)
while True:
    {long}
"""


@pytest.mark.slow
@pytest.mark.parametrize(("short", "long"), LONG.values(), ids=LONG)
def test_interrupt_is_answered_within_two_seconds(short, long):
    """In processor time, which a busy machine does not change: user's and system's, then that
    of children which have ended."""
    earlier = psutil.Process().cpu_times()
    run = subprocess.Popen(
        [sys.executable, "-c", SCRIPT.format(short=short, long=long)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(FOLDERS)},
        # A process in the background of a shell would ignore the interrupt.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    assert run.stdout.readline() == "begins\n"
    process = psutil.Process(run.pid)
    begun = sum(process.cpu_times()[:2])
    while sum(process.cpu_times()[:2]) < begun + 1.0:
        assert run.poll() is None
        time.sleep(0.02)
    sent = sum(process.cpu_times()[:2])
    run.send_signal(signal.SIGINT)
    output, errors = run.communicate(timeout=60.0)
    ended = psutil.Process().cpu_times()
    assert sum(ended[2:4]) - sum(earlier[2:4]) - sent < 2.0
    assert output == ""
    assert errors.rstrip().endswith("KeyboardInterrupt")
