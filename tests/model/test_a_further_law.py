"""A stranger adds the law of the page on extensions, and asks for it by configuration alone.

What a copy of the project computes with the added kind is compared with what this one computes with
the same functions given from Python.
"""

import shlex
import sys

import numpy as np
import pytest
from pages import EXTENDING, blocks, carry_out, commands, run
from potentials import cosh

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset
from granular_fronts.scenes.yaml_files import read_yaml
from projects import copy_project, lend_kernels, snakemake


@pytest.fixture(scope="module")
def extended(tmp_path_factory):
    """A copy of the project after the one place is changed."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    changed = carry_out(copy, "A contact law")
    kinds = "src/granular_fronts/model/kinds.py"
    assert changed == {kinds, "mine.yaml", "config/campaigns/hyperbolic.yaml"}
    return copy


def ask(project, word):
    """Run the command of the page that holds a word."""
    [line] = [line for line in commands(EXTENDING) if word in line]
    outcome = snakemake(*shlex.split(line)[1:], folder=project)
    assert outcome.returncode == 0, outcome.stderr


def given_law(stiffness, viscous):
    return gf.make_law(elastic=cosh().scaled(stiffness), viscous=viscous)


@pytest.mark.slow
def test_a_scene_has_the_further_law(extended):
    ask(extended, "chain/hyperbolic.nc")
    found = read_dataset(extended / "results/data/chain/hyperbolic.nc")
    scene = read_yaml(extended / "mine.yaml")["scenes"]["chain"]["hyperbolic"]
    expected = gf.simulate_chain(scene | {"law": given_law(1.0, scene["law"]["viscous"])})
    for name in ("relative_displacement", "velocity"):
        error = found[name].attrs["error_estimate"]
        np.testing.assert_allclose(found[name], expected[name], rtol=0, atol=4.0 * error)


# The kernels of fronts are compiled anew; other tests vary, and give, the laws that are there.
@pytest.mark.nightly
def test_a_campaign_varies_the_further_law(extended):
    ask(extended, "campaign")
    found = read_dataset(extended / "results/data/campaigns/hyperbolic.nc")
    assert (found["status"] == 0).all()
    viscous = read_yaml(extended / "config/campaigns/hyperbolic.yaml")["law"]["viscous"]
    law = given_law(2.0, viscous).with_damping(0.5)
    overshoot = gf.solve_front(law=law, states=(-1.0, 0.0)).attrs["overshoot"]
    point = found["overshoot"].sel(elastic_strength=2.0, damping=0.5)
    assert float(point) == pytest.approx(overshoot, abs=1e-11)
    assert overshoot > 1e-4


# It needs the same kernels.
@pytest.mark.nightly
def test_python_has_the_further_law(extended):
    kernels = {"NUMBA_CACHE_DIR": str(extended / ".numba_cache")}
    [example] = [block for block in blocks(EXTENDING, "python") if block.startswith("import")]
    outcome = run([sys.executable, "-c", example], extended, **kernels)
    assert outcome.returncode == 0, outcome.stderr
    solved, expected = outcome.stdout.splitlines()
    assert float(solved.split()[0]) == pytest.approx(float(expected), rel=1e-10)
