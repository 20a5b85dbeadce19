"""Speed against error: how it is measured and compared, and each peer that is installed."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import measure_speed as measuring
import tabulate_speed_error as tabulating
from granular_fronts.errors import InputError, SolveError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.reference_methods.half_step import Chain, integrate
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import load_configuration
from peers import lammps_chain, runs, scilab_chain, scipy_fronts
from peers.chain_system import ChainSystem
from peers.runs import Run
from problems import log_burgers
from problems.chain import PEERS, make_chain
from problems.fronts import make_front
from problems.problem import Answer, Problem, error_of
from projects import ROOT
from speed_and_error_settings import SpeedAndError

ANSWERS = {"velocity": Answer(np.array([1.0, 2.0]), np.zeros(2), 1e-9)}
DRIVEN = ChainSystem(gamma=0.3, end=12.0, beads=20)


def solution(error, seconds=0.5, share=1.0):
    return Run({"velocity": np.array([1.0, 2.0 + error])}, seconds, share * seconds)


def stop(_):
    raise SolveError("the step size collapsed")


def test_error_is_the_distance_to_the_answer_and_not_below_its_own():
    problem = Problem(ANSWERS, {})
    assert error_of(solution(1e-12), problem) == 1e-9
    assert error_of(solution(1e-3), problem) == pytest.approx(1e-3)
    assert np.isnan(error_of(Run(message="stopped"), problem))
    # What double leaves of the answer counts.
    exact = Problem({"velocity": Answer(np.ones(2), np.full(2, 3e-17), 1e-20)}, {})
    found = error_of(Run({"velocity": np.full(2, np.nextafter(1.0, 2.0))}), exact)
    assert found == pytest.approx(np.spacing(1.0) - 3e-17, rel=1e-3, abs=0)


def test_least_time_counts_and_what_fails_or_is_absent_is_named():
    times, calls = iter([9.0, 0.3, 0.1, 0.2]), []

    def long(_):
        calls.append("long")
        return solution(1e-4, 60.0, share=0.5)

    methods = {
        "quick": lambda _: solution(1e-3, next(times)),
        "long": long,
        "broken": stop,
        "elsewhere": lambda _: Run(message="not installed", absent=True),
    }
    asked = {name: [1e-3] for name in methods}
    rows, missing = measuring.measure(Problem(ANSWERS, methods), asked, 3)
    assert [row["method"] for row in rows] == ["quick", "long", "broken"]
    assert missing == {"elsewhere"}
    assert [row["seconds"] for row in rows] == pytest.approx([0.1, 60.0, np.nan], nan_ok=True)
    assert len(calls) == 2
    assert [row["disturbed"] for row in rows] == [0, 1, 0]
    assert rows[2]["message"] == "the step size collapsed"


def test_methods_are_compared_at_equal_error():
    """Seconds are cost / fineness^(1/8), so that an interpolated time is exact."""
    costs = {"slow": 100.0, "quick": 1.0, "coarse": 0.5}
    listed = pd.DataFrame(
        [
            {
                "problem": "one",
                "method": method,
                "error": fineness * (1e3 if method == "coarse" else 1.0),
                "reference_error": 1e-11,
                "seconds": cost * fineness**-0.125,
                "disturbed": int(method == "slow"),
            }
            for method, cost in costs.items()
            for fineness in (1e-4, 1e-8, 1e-10)
        ]
    )
    found = pd.DataFrame(tabulating.compare_methods(listed, 1e-9)).set_index("method")
    assert list(found.index) == ["quick", "slow"]
    assert found.loc["quick", "milliseconds"] == pytest.approx(1e3 * 1e-9**-0.125)
    assert found.loc["slow", "times_the_fastest"] == pytest.approx(100.0)
    assert list(found["disturbed"]) == [0, 1]
    assert list(tabulating.compare_methods(listed, 1e-12)) == []


def test_every_problem_has_an_answer_that_our_first_method_comes_to():
    own = load_configuration(ROOT / "projects" / "speed_and_error" / "config.yaml")
    makers = {"chain": make_chain, "front": make_front}
    for settings in read_part(SpeedAndError, own).plain()["tasks"].values():
        if settings["kind"] in makers:
            stored = "fronts" if settings["kind"] == "front" else "chain"
            states = xr.load_dataset(ROOT / "tests" / "references" / f"{stored}_reference.nc")
            problem = makers[settings["kind"]](settings, states)
            assert settings["methods"].keys() <= problem.methods.keys()
            first, (*_, finest) = next(iter(settings["methods"].items()))
            assert error_of(problem.methods[first](finest), problem) < 1e-12
            with pytest.raises(InputError, match="No reference is stored for gamma = 7"):
                makers[settings["kind"]](settings | {"gamma": 7.0}, states)


def test_a_ring_is_solved_by_four_schemes(monkeypatch):
    for name, value in {"CELLS": 1024, "TOLERANCE": 1e-9, "POINTS": 512}.items():
        monkeypatch.setattr(log_burgers, name, value)
    scene = load_configuration(ROOT / "config" / "default.yaml")["scenes"]["periodic"]["weak"]
    problem = log_burgers.make_ring({}, scene)
    assert 0.0 < problem.reference_error < 1e-8
    finest = {"upwind": 1000, "finite_volumes": 256, "uniform_cells": 256, "fourier": 0.02}
    errors = {name: error_of(problem.methods[name](one), problem) for name, one in finest.items()}
    assert errors["upwind"] == pytest.approx(2.8e-2, rel=0.02)
    assert errors["finite_volumes"] < 1e-5
    assert errors["uniform_cells"] > 2.0 * errors["finite_volumes"]
    assert errors["fourier"] < 1e-6


@pytest.mark.parametrize("name", [name for name in PEERS if not name.startswith("lammps")])
def test_every_present_peer_finds_the_same_motion(name):
    run = PEERS[name](DRIVEN, 1e-11, 1e-13)
    if run.absent:
        pytest.skip(run.message)
    expected = PEERS["scipy_dop853"](DRIVEN, 1e-13, 1e-15)
    for field, values in expected.fields.items():
        np.testing.assert_allclose(run.fields[field], values, rtol=0.0, atol=2e-9)
    gained = DRIVEN.left**1.5 * DRIVEN.end
    assert run.fields["velocity"].sum() == pytest.approx(gained, abs=1e-9)
    assert min(run.seconds, run.cpu_seconds) > 0


def test_an_absent_tool_says_so(monkeypatch):
    monkeypatch.setattr(scilab_chain.shutil, "which", lambda name: None)
    monkeypatch.setattr(lammps_chain, "find_lammps", lambda: None)
    monkeypatch.setattr(runs.importlib.util, "find_spec", lambda name: None)
    tools = {"scilab": "scilab-cli", "lammps": "lmp", "numbalsoda": "numbalsoda", "diffrax": "jax"}
    for name in PEERS.keys() - {"scipy_dop853"}:
        run = PEERS[name](DRIVEN, 0.1, 1e-10)
        assert run.absent
        assert tools[name.partition("_")[0]] in run.message


def fake_lammps(monkeypatch, folder, text, dump=None):
    """A command that prints a text, writes a dump, and fails without one."""
    command = folder / "lmp"
    (folder / "report").write_text(text)
    copy = f"cp {dump} ." if dump else "exit 1"
    command.write_text(f"#!/bin/sh\ncat {folder / 'report'}\n{copy}\n")
    command.chmod(0o755)
    monkeypatch.setattr(lammps_chain, "find_lammps", lambda: str(command))


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
    fake_lammps(monkeypatch, tmp_path, report, tmp_path / "chain_0.5.dump")
    run = PEERS["lammps_nve"](system, 0.5, 0.0)
    assert (run.seconds, run.cpu_seconds) == (0.25, pytest.approx(0.225))
    u = run.fields["relative_displacement"]
    np.testing.assert_allclose(u, np.append(-np.diff(motion.x[-1]), 0.0), rtol=0, atol=1e-14)
    np.testing.assert_array_equal(run.fields["velocity"], motion.v[-1])


def test_failing_lammps_is_quoted(monkeypatch, tmp_path):
    fake_lammps(monkeypatch, tmp_path, "reading\nERROR: Lost atoms: original 20 current 7\nbye\n")
    with pytest.raises(SolveError, match="ERROR: Lost atoms: original 20 current 7"):
        PEERS["lammps_mvv"](DRIVEN, 2.0, 0.0)
    assert "no whole number" in PEERS["lammps_nve"](DRIVEN, 0.7, 0.0).message


@pytest.mark.slow
def test_scipy_finds_the_front_of_the_lattice():
    bead = np.arange(-8, 6)
    run = scipy_fronts.solve(0.3, bead, 20, 1e-6)
    # It stops within ten times its tolerance; where exactly is a matter of the processor.
    for name, found in run.fields.items():
        expected = evaluate_front(solve_front(1.5, 0.3), bead, name)
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-5)
