"""A stranger adds the law V = k (cosh r − 1) in one place, and asks for it by configuration alone.

What a copy of the project computes with the added kind is compared with what this one computes with
the same functions given from Python.
"""

import math

import numpy as np
import pytest
import yaml
from projects import copy_project, snakemake

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset

pytestmark = pytest.mark.slow

SHAPE = '''
def cosh(r, order, p):
    """cosh r − 1, p = ()."""
    if order == 0:
        return 2.0 * np.sinh(0.5 * r) ** 2
    return np.sinh(r) if order % 2 == 1 else np.cosh(r)


'''
ENTRY = """
    "cosh": Kind("cosh", cosh, {"stiffness": Parameter("k")}, factor="stiffness"),
"""

LAW = {
    "elastic": {"kind": "cosh", "stiffness": 2.0},
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
    "axes": {"law.elastic.stiffness": [1.0, 2.0], "delta": [0.4, 0.8]},
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
    copy = copy_project(tmp_path_factory.mktemp("project"))
    (copy / "mine.yaml").write_text(yaml.safe_dump({"scenes": {"chain": {"mine": SCENE}}}))
    for name, given in (("my_chains", CHAINS), ("my_fronts", FRONTS)):
        (copy / f"config/campaigns/{name}.yaml").write_text(yaml.safe_dump(given, sort_keys=False))
    return copy


@pytest.fixture(scope="module")
def extended(project):
    """The same, after the one place is changed: a function and its entry in `model.kinds`."""
    run = ask(project, "results/smoke/data/chain/mine.nc")
    assert run.returncode != 0
    assert "law: 'cosh' is no kind of elastic potential" in run.stdout + run.stderr
    file = project / "src/granular_fronts/model/kinds.py"
    text = file.read_text(encoding="utf-8")
    text = text.replace("\nclass Parameter(", SHAPE.removeprefix("\n") + "\nclass Parameter(", 1)
    text = text.replace("\nELASTIC = {\n", "\nELASTIC = {" + ENTRY, 1)
    file.write_text(text, encoding="utf-8")
    return project


def ask(project, *arguments):
    return snakemake(
        "--configfile", "config/smoke.yaml", "mine.yaml", "--", *arguments, folder=project
    )


def run_campaign(project, name):
    run = snakemake("campaign", "--config", f"campaign={name}", folder=project)
    assert run.returncode == 0, run.stderr
    return read_dataset(project / f"results/data/campaigns/{name}.nc")


def given_law(stiffness=2.0):
    potential = gf.Potential(
        lambda r: np.cosh(r) - 1.0, np.sinh, np.cosh, np.sinh, interval=(-3.0, 3.0), name="cosh"
    )
    return gf.make_law(elastic=potential.scaled(stiffness), viscous=LAW["viscous"])


def test_a_scene_has_the_further_law(extended):
    run = ask(extended, "results/smoke/data/chain/mine.nc")
    assert run.returncode == 0, run.stderr
    found = read_dataset(extended / "results/smoke/data/chain/mine.nc")
    expected = gf.simulate_chain(SCENE | {"law": given_law()})
    for name in ("relative_displacement", "velocity"):
        error = found[name].attrs["error_estimate"]
        np.testing.assert_allclose(found[name], expected[name], atol=4.0 * error)
    assert found.attrs["energy_drift"] < 1e-9


def test_a_campaign_of_chains_varies_the_further_law(extended):
    found = run_campaign(extended, "my_chains")
    assert found["front_speed"].dims == ("elastic_stiffness", "delta")
    assert (found["status"] == 0).all()
    for stiffness, delta in ((1.0, 0.4), (2.0, 0.8)):
        speed = math.sqrt(stiffness * math.sinh(delta) / delta)
        boundary = {"kind": "pressure", "left": delta, "right": 0.0}
        record = {"snapshots": [], "arrival_level": 0.5 * delta, "extremes": True}
        changes = {"boundary": boundary, "end_time": 1.2 * 30 / speed, "record": record}
        motion = gf.simulate_chain(SCENE | {"law": given_law(stiffness)} | changes)
        expected = float(motion["first_peak"].sel(bead=15)) / delta - 1.0
        overshoot = float(found["overshoot"].sel(elastic_stiffness=stiffness, delta=delta))
        assert overshoot == pytest.approx(expected, abs=1e-8)
        assert overshoot > 1e-4


def test_a_campaign_of_exact_fronts_has_the_further_law(extended):
    found = run_campaign(extended, "my_fronts")
    for damping in FRONTS["axes"]["damping"]:
        law = given_law().with_damping(damping)
        front = gf.solve_front(law=law, states=(-1.5, -0.1))
        overshoot = float(found["overshoot"].sel(damping=damping))
        assert overshoot == pytest.approx(front.attrs["overshoot"], abs=1e-11)
        assert overshoot > 0.0
