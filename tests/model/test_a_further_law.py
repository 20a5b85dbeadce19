"""A stranger adds the law of the page on extensions, and asks for it by configuration alone.

What a copy of the project computes with the added kind is compared with what this one computes with
the same functions given from Python.
"""

import math
import shlex
import sys

import numpy as np
import pytest
import yaml
from pages import EXTENDING, blocks, carry_out, commands, run
from potentials import cosh
from projects import copy_project, lend_kernels, snakemake

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset

pytestmark = pytest.mark.slow

LAW = {
    "elastic": {"kind": "hyperbolic", "strength": 2.0},
    "viscous": {"kind": "proportional", "gamma": 0.3},
}
SCENE = {
    "law": LAW,
    "beads": 30,
    "boundary": {"kind": "pressure", "left": 0.8, "right": 0.0},
    "start": {"kind": "rest"},
    "end_time": 15.0,
    "tolerance": {"relative": 1e-10, "absolute": 1e-12},
    "record": {"snapshots": [8.0, 15.0], "arrival_level": 0.4, "balances": True},
}
CHAINS = {
    "kind": "chain",
    "law": LAW,
    "axes": {"law.elastic.strength": [1.0, 2.0], "delta": [0.4, 0.8]},
    "fixed": {"beads": 30},
    "tolerance": 1e-8,
}
FRONTS = {
    "kind": "front",
    "law": LAW,
    "axes": {"damping": [0.5, 1.0]},
    "fixed": {"behind": -1.5, "ahead": -0.1},
}


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project that asks for the law before any of its files knows it."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    (copy / "further.yaml").write_text(yaml.safe_dump({"scenes": {"chain": {"mine": SCENE}}}))
    for name, given in (("my_chains", CHAINS), ("my_fronts", FRONTS)):
        (copy / f"config/campaigns/{name}.yaml").write_text(yaml.safe_dump(given, sort_keys=False))
    return copy


@pytest.fixture(scope="module")
def extended(project):
    """The same, after the one place is changed: a function and its entry in `model.kinds`."""
    place = "src/granular_fronts/model/kinds.py"
    run = ask(project, "results/smoke/data/chain/mine.nc")
    assert run.returncode != 0
    assert "law: 'hyperbolic' is no kind of elastic potential" in run.stdout + run.stderr
    changed = carry_out(project, "A contact law")
    assert changed == {place, "mine.yaml", "config/campaigns/hyperbolic.yaml"}
    return project


def ask(project, *arguments):
    return snakemake(
        "--configfile", "config/smoke.yaml", "further.yaml", "--", *arguments, folder=project
    )


def run_campaign(project, name):
    run = snakemake("campaign", "--config", f"campaign={name}", folder=project)
    assert run.returncode == 0, run.stderr
    return read_dataset(project / f"results/data/campaigns/{name}.nc")


def given_law(stiffness=2.0):
    return gf.make_law(elastic=cosh().scaled(stiffness), viscous=LAW["viscous"])


def test_a_scene_has_the_further_law(extended):
    run = ask(extended, "results/smoke/data/chain/mine.nc")
    assert run.returncode == 0, run.stderr
    found = read_dataset(extended / "results/smoke/data/chain/mine.nc")
    expected = gf.simulate_chain(SCENE | {"law": given_law()})
    for name in ("relative_displacement", "velocity"):
        error = found[name].attrs["error_estimate"]
        np.testing.assert_allclose(found[name], expected[name], rtol=0, atol=4.0 * error)
    assert found.attrs["energy_drift"] < 1e-9


def test_a_campaign_of_chains_varies_the_further_law(extended):
    found = run_campaign(extended, "my_chains")
    assert found["front_speed"].dims == ("elastic_strength", "delta")
    assert (found["status"] == 0).all()
    for stiffness, delta in ((1.0, 0.4), (2.0, 0.8)):
        speed = math.sqrt(stiffness * math.sinh(delta) / delta)
        boundary = {"kind": "pressure", "left": delta, "right": 0.0}
        record = {"snapshots": [], "arrival_level": 0.5 * delta, "extremes": True}
        changes = {"boundary": boundary, "end_time": 1.2 * 30 / speed, "record": record}
        motion = gf.simulate_chain(SCENE | {"law": given_law(stiffness)} | changes)
        expected = float(motion["first_peak"].sel(bead=15)) / delta - 1.0
        overshoot = float(found["overshoot"].sel(elastic_strength=stiffness, delta=delta))
        assert overshoot == pytest.approx(expected, abs=1e-8)
        assert overshoot > 1e-4


def test_a_campaign_of_exact_fronts_has_the_further_law(extended):
    found = run_campaign(extended, "my_fronts")
    for damping in FRONTS["axes"]["damping"]:
        law = given_law().with_damping(damping)
        front = gf.solve_front(law=law, states=(-1.5, -0.1))
        overshoot = float(found["overshoot"].sel(damping=damping))
        assert overshoot == pytest.approx(front.attrs["overshoot"], abs=1e-11)
    # The front of the stronger damping is monotone up to rounding.
    assert float(found["overshoot"].sel(damping=0.5)) > 1e-5


def test_the_page_on_extensions_is_true(extended):
    kernels = {"NUMBA_CACHE_DIR": str(extended / ".numba_cache")}
    [line] = [line for line in commands(EXTENDING) if "chain/hyperbolic.nc" in line]
    outcome = snakemake(*shlex.split(line)[1:], folder=extended)
    assert outcome.returncode == 0, outcome.stderr
    [example] = [block for block in blocks(EXTENDING, "python") if block.startswith("import")]
    outcome = run([sys.executable, "-c", example], extended, **kernels)
    assert outcome.returncode == 0, outcome.stderr
    solved, expected = outcome.stdout.splitlines()
    assert float(solved.split()[0]) == pytest.approx(float(expected), rel=1e-10)
    [campaign] = [line for line in commands(EXTENDING) if "campaign" in line]
    outcome = snakemake(*shlex.split(campaign)[2:], folder=extended)
    assert outcome.returncode == 0, outcome.stderr
    found = read_dataset(extended / "results/data/campaigns/hyperbolic.nc")
    assert (found["status"] == 0).all()
    assert np.isfinite(found["overshoot"]).all()
