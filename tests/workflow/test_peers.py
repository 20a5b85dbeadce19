"""The peers of the speed comparison solve our problems, and an absent one says so."""

import numpy as np
import pytest
from lammps import needs_lammps

from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.reference_methods.half_step import Chain, integrate
from peers import lammps_chain, runs, scilab_chain, scipy_fronts
from peers.chain_system import ChainSystem
from problems.chain import PEERS

DRIVEN = ChainSystem(gamma=0.3, end=12.0, beads=20)


@pytest.mark.parametrize("name", PEERS)
def test_every_present_peer_finds_the_same_motion(name):
    run = PEERS[name](DRIVEN, 1e-11, 1e-13)
    if run.absent:
        pytest.skip(run.message)
    expected = PEERS["scipy_dop853"](DRIVEN, 1e-13, 1e-15)
    for field, values in expected.fields.items():
        np.testing.assert_allclose(run.fields[field], values, rtol=0.0, atol=2e-9)
    gained = DRIVEN.left**1.5 * DRIVEN.end
    assert run.fields["velocity"].sum() == pytest.approx(gained, abs=1e-9)
    assert run.seconds > 0
    assert run.cpu_seconds > 0
    assert run.right_hand_sides > 0


def test_an_absent_tool_says_so(monkeypatch):
    monkeypatch.setattr(scilab_chain.shutil, "which", lambda name: None)
    monkeypatch.setattr(lammps_chain, "find_command", lambda: None)
    monkeypatch.setattr(runs.importlib.util, "find_spec", lambda name: None)
    tools = {
        "scilab_ode": "scilab-cli",
        "lammps_nve": "lmp",
        "numbalsoda_dop853": "numbalsoda",
        "diffrax_dopri8": "jax",
    }
    for name, tool in tools.items():
        run = (PEERS | lammps_chain.METHODS)[name](DRIVEN, 0.1, 1e-10)
        assert run.absent
        assert not run.fields
        assert tool in run.message


def fake_lammps(folder, text, dump=None):
    """A command that prints a text, writes a dump, and fails without one."""
    command = folder / "lmp"
    (folder / "report").write_text(text)
    copy = f"cp {dump} ." if dump else "exit 1"
    command.write_text(f"#!/bin/sh\ncat {folder / 'report'}\n{copy}\n")
    command.chmod(0o755)
    return str(command)


def test_lammps_is_read_as_it_reports(monkeypatch, tmp_path):
    """Its scheme is ours to round-off, see test_half_step.py; here ours takes its place."""
    system = ChainSystem(gamma=0.3, end=12.0, beads=5)
    chain = Chain(1.5, 1.5, 0.3, left=0.1)
    motion = integrate(chain, np.zeros(5), np.zeros(5), 0.5, 24)
    lines = ["ITEM: TIME", "12.0", "ITEM: TIMESTEP", "24", "ITEM: ATOMS id x vx"]
    rows = zip(motion.x[-1].tolist(), motion.v[-1].tolist(), strict=True)
    lines += [f"{n + 1} {n + x!r} {v!r}" for n, (x, v) in enumerate(rows)]
    (tmp_path / "chain_0.5.dump").write_text("\n".join([*lines, ""]))
    report = "Loop time of 0.25 on 1 procs for 24 steps with 5 atoms\n\n90.0% CPU use with 1 MPI"
    command = fake_lammps(tmp_path, report, tmp_path / "chain_0.5.dump")
    monkeypatch.setattr(lammps_chain, "find_command", lambda: command)
    run = lammps_chain.METHODS["lammps_nve"](system, 0.5, 0.0)
    assert (run.seconds, run.cpu_seconds, run.steps) == (0.25, pytest.approx(0.225), 24)
    u = run.fields["relative_displacement"]
    np.testing.assert_allclose(u[:-1], -np.diff(motion.x[-1]), rtol=0, atol=1e-14)
    assert u[-1] == 0.0
    np.testing.assert_array_equal(run.fields["velocity"], motion.v[-1])


def test_failing_lammps_is_quoted(monkeypatch, tmp_path):
    command = fake_lammps(tmp_path, "reading\nERROR: Lost atoms: original 20 current 7\nbye\n")
    monkeypatch.setattr(lammps_chain, "find_command", lambda: command)
    run = lammps_chain.METHODS["lammps_mvv"](DRIVEN, 2.0, 0.0)
    assert "ERROR: Lost atoms: original 20 current 7" in run.message
    assert "no whole number" in lammps_chain.METHODS["lammps_nve"](DRIVEN, 0.7, 0.0).message


@needs_lammps
@pytest.mark.parametrize(("name", "order"), [("lammps_nve", 1.0), ("lammps_mvv", 2.0)])
def test_lammps_comes_closer_at_its_order(name, order):
    system = ChainSystem(gamma=0.3, end=30.0, beads=20)
    expected = PEERS["scipy_dop853"](system, 1e-13, 1e-15)
    errors = []
    for step in (0.1, 0.05):
        run = lammps_chain.METHODS[name](system, step, 0.0)
        assert run.seconds > 0.0
        errors.append(
            max(np.abs(run.fields[field] - expected.fields[field]).max() for field in run.fields)
        )
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.15)


@pytest.mark.slow
@pytest.mark.parametrize("name", scipy_fronts.METHODS)
def test_peer_finds_the_front_of_the_lattice_or_says_why_not(name):
    front = solve_front(1.5, 0.3)
    bead = np.arange(-8, 6)
    run = scipy_fronts.METHODS[name](0.3, bead, 20, 1e-6)
    if name == "scipy_newton_krylov":
        assert "no convergence" in run.message
        return
    expected = evaluate_front(front, bead)
    # A peer stops within ten times its tolerance; where exactly is a matter of the processor.
    found = run.fields["relative_displacement"]
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-5)
    assert run.fields["velocity"][0] == pytest.approx(1.0, abs=0.02)
    assert run.right_hand_sides > 0
