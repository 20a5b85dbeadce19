"""Each figure is there, as whole files of their kinds, with a caption, and says what it shows."""

import json
import re

import pytest
from conftest import PROJECT, listed_as_made, read_dataset
from figure_samples import SAMPLES, TAKEN

from dataset_parameters import FAMILIES, default_parameters
from granular_fronts.output.datasets import configuration_of
from granular_fronts.scenes.yaml_files import read_yaml

LISTED = read_yaml(PROJECT / "workflow/figures.yaml")
FIGURES = pytest.mark.parametrize("stem", listed_as_made("figures"))


def number_of(stem):
    """The name of a figure in the list, such as fig01."""
    return stem.removeprefix("figures/").split("_")[0]


def data_behind(stem, results, configuration):
    """The datasets that a figure is drawn from."""
    folders = {family: folder for folder, family in FAMILIES.items()}
    for named in LISTED[number_of(stem)]["data"].values():
        names = [named]
        if isinstance(named, dict):
            scenes = configuration["scenes"][named["family"]]
            names = [f"{folders[named['family']]}/{scene}" for scene in scenes]
        for name in names:
            yield read_dataset(results / f"data/{name}.nc")


def test_data_answer_the_configuration(results, configuration):
    for name, parameters in default_parameters(configuration).items():
        data = read_dataset(results / f"data/{name}.nc")
        assert configuration_of(data) == json.loads(json.dumps(parameters)), name
        assert TAKEN.isdisjoint(data.dims), name


@FIGURES
def test_pictures_are_whole_and_name_what_they_were_drawn_from(results, configuration, stem):
    for ending, start, end in (("png", b"\x89PNG", b"IEND"), ("pdf", b"%PDF", b"%%EOF")):
        content = (results / f"{stem}.{ending}").read_bytes()
        assert content.startswith(start)
        assert end in content[-12:]
        for data in data_behind(stem, results, configuration):
            assert f"{data.attrs['scene']}:{data.attrs['data_digest']}".encode() in content


@FIGURES
def test_captions_are_filled(results, stem):
    caption = (results / f"{stem}.rst").read_text(encoding="utf-8")
    assert caption.strip()
    assert not re.search(r"[{}]{2}|\bNone\b", caption)


@FIGURES
def test_data_have_the_variables_that_the_tests_of_figures_draw(results, configuration, stem):
    """Those tests draw samples, which hold for the workflow only if its datasets are alike."""
    made = [variables_of(data) for data in data_behind(stem, results, configuration)]
    # A figure of a user's own has no sample.
    for given in SAMPLES.get(number_of(stem), dict)().values():
        drawn = variables_of(given[0] if isinstance(given, list) else given)
        assert any(drawn <= variables for variables in made)


def variables_of(data):
    """Names and dimensions of what a dataset holds, without its coordinates."""
    return {(name, each.dims) for name, each in data.items()}
