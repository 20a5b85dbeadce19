"""The page on extensions, carried out as a stranger would; its law is in `test_a_further_law`."""

import shlex

import numpy as np
import pytest
from pages import EXTENDING, carry_out, commands

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset
from projects import copy_project, lend_kernels, snakemake

pytestmark = pytest.mark.slow

SUBJECTS = ("A figure", "A study", "A scene's option")


def command(word):
    """The command of the page that holds a word, in words."""
    [found] = [line for line in commands(EXTENDING) if word in line]
    return shlex.split(found)


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project with a further figure, study and option."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    for subject in SUBJECTS:
        assert carry_out(copy, subject)
    wanted = [command(word)[-1] for word in ("flux_difference", "front_width.nc")]
    outcome = snakemake("-c2", *wanted, folder=copy)
    assert outcome.returncode == 0, outcome.stderr
    return copy


def test_a_figure_is_added(project):
    figures = project / "results" / "figures"
    drawn = {path.name for path in figures.iterdir()}
    assert drawn == {f"flux_difference.{ending}" for ending in ("pdf", "png", "rst")}


def test_a_study_is_added(project):
    found = read_dataset(project / command("front_width.nc")[-1])["front_width"]
    for gamma, width in zip((0.3, 1.0), found.values, strict=True):
        assert width == pytest.approx(gf.solve_front(1.5, gamma).attrs["width_10_90"], rel=1e-12)
    assert found.attrs["long_name"]
    impossible = project / "impossible.yaml"
    impossible.write_text("exact_fronts: {front_width: {gammas: [0.3, 0]}}", encoding="utf-8")
    outcome = snakemake("--configfile", impossible, "-n", folder=project)
    assert outcome.returncode != 0
    said = "exact_fronts.front_width.gammas (entry 2) is 0, but must be above 0"
    assert said in outcome.stdout + outcome.stderr


def test_an_option_is_added(project):
    asked = command("reach.yaml")
    outcome = snakemake(*asked[1:], folder=project)
    assert outcome.returncode == 0, outcome.stderr
    for mu, s in read_dataset(project / asked[-1])["reach"].to_series().items():
        front = gf.heteroclinic(mu, np.array([0.0, s]))
        np.testing.assert_allclose(front["rescaled_force"], [0.5, 0.01], rtol=1e-12)
