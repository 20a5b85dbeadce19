"""Ctrl-C ends what runs long, compiled loops too, and nobody sees what was unfinished."""

import os
import resource
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


def seconds_of(process):
    """Processor time that a running process has taken."""
    times = process.cpu_times()
    return times.user + times.system


def seconds_of_children():
    """Processor time that all processes have taken that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@pytest.mark.slow
@pytest.mark.parametrize(("short", "long"), LONG.values(), ids=LONG)
def test_interrupt_is_answered_within_two_seconds(short, long):
    """In processor time, which a busy machine does not change."""
    earlier = seconds_of_children()
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
    begun = seconds_of(process)
    while seconds_of(process) < begun + 1.0:
        assert run.poll() is None
        time.sleep(0.02)
    sent = seconds_of(process)
    run.send_signal(signal.SIGINT)
    output, errors = run.communicate(timeout=60.0)
    assert seconds_of_children() - earlier - sent < 2.0
    assert output == ""
    assert errors.rstrip().endswith("KeyboardInterrupt")
