"""The page on extensions, carried out as a stranger would; its law is in `test_a_further_law`."""

import shlex

import numpy as np
import pandas as pd
import pytest
from pages import EXTENDING, carry_out, commands

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset
from projects import copy_project, lend_kernels, snakemake

pytestmark = pytest.mark.slow

SUBJECTS = (
    "A figure, in three",
    "A study, in four",
    "A table, in two",
    "A scene's option, in two",
)


def command(word):
    """The command of the page that holds a word, in words."""
    [found] = [line for line in commands(EXTENDING) if word in line]
    return shlex.split(found)


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project with a further figure, study and option."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    numbers = {"two": 2, "three": 3, "four": 4}
    for subject in SUBJECTS:
        places = [name for name in carry_out(copy, subject) if "/" in name]
        assert len(places) == numbers[subject.split()[-1]]
    wanted = [command(word)[-1] for word in ("flux_difference", "front_width.nc", "tabulate")]
    outcome = snakemake("-c2", *wanted, folder=copy)
    assert outcome.returncode == 0, outcome.stderr
    return copy


def test_a_figure_is_added_in_three_places(project):
    figures = project / "results" / "figures"
    drawn = {path.name for path in figures.iterdir()}
    assert drawn == {f"flux_difference.{ending}" for ending in ("pdf", "png", "rst")}
    caption = (figures / "flux_difference.rst").read_text(encoding="utf-8")
    assert "α = 1.5, 1.1" in caption


def test_a_study_is_added_in_four_places_and_its_table_in_two(project):
    found = read_dataset(project / command("front_width.nc")[-1])["front_width"]
    for gamma, width in zip((0.3, 1.0), found.values, strict=True):
        assert width == pytest.approx(gf.solve_front(1.5, gamma).attrs["width_10_90"], rel=1e-12)
    assert found.attrs["long_name"] == "distance from 90 to 10 per cent, in beads"
    table = pd.read_csv(project / "results/tables/front_width.csv")
    np.testing.assert_array_equal(table["front_width"], found.values)
    assert table["front_width_error"].max() == found.attrs["error_estimate"]
    impossible = project / "impossible.yaml"
    impossible.write_text("exact_fronts: {front_width: {gammas: [0.3, 0]}}", encoding="utf-8")
    outcome = snakemake("--configfile", impossible, "-n", folder=project)
    assert outcome.returncode != 0
    said = "exact_fronts.front_width.gammas (entry 2) is 0, but must be above 0"
    assert said in outcome.stdout + outcome.stderr


def test_an_option_is_added_in_two_places(project):
    asked = command("reach.yaml")
    outcome = snakemake(*asked[1:], folder=project)
    assert outcome.returncode == 0, outcome.stderr
    for mu, s in read_dataset(project / asked[-1])["reach"].to_series().items():
        front = gf.heteroclinic(mu, np.array([0.0, s]))
        np.testing.assert_allclose(front["rescaled_force"], [0.5, 0.01], rtol=1e-12)
