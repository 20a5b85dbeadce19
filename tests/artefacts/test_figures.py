"""Each figure is there, as whole files of their kinds, with a caption, and says what it shows."""

import re

import pytest
from conftest import listed_as_made, read_dataset
from figure_samples import SAMPLES

from dataset_parameters import default_parameters
from granular_fronts.output.datasets import read_sources
from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import disagreements

FIGURES = pytest.mark.parametrize("stem", listed_as_made("figures"))


def test_all_belongs_together_and_answers_the_configuration(results, configuration):
    parameters = default_parameters(configuration)
    sources = read_sources(results / "data", parameters)
    assert len(sources) == len(parameters)
    stems = [*listed_as_made("figures"), *listed_as_made("tables")]
    for stem in stems:
        assert not list(disagreements(results / f"{stem}.json", parameters, sources))


@FIGURES
def test_pictures_are_whole_and_name_what_they_were_drawn_from(results, stem):
    made_from = read_json(results / f"{stem}.json")["made_from"]
    for ending, start, end in (("png", b"\x89PNG", b"IEND"), ("pdf", b"%PDF", b"%%EOF")):
        content = (results / f"{stem}.{ending}").read_bytes()
        assert content.startswith(start)
        assert end in content[-12:]
        for source in made_from:
            assert ":".join(source.values()).encode() in content


@FIGURES
def test_texts_are_filled(results, stem):
    record = read_json(results / f"{stem}.json")
    caption = (results / f"{stem}.rst").read_text(encoding="utf-8")
    for text in (caption, record["title"], record["alt"]):
        assert text.strip()
        assert not re.search(r"[{}]{2}|\bNone\b", text)


@FIGURES
def test_data_have_the_variables_that_the_tests_of_figures_draw(results, stem):
    """Those tests draw samples, which hold for the workflow only if its datasets are alike."""
    scenes = [each["scene"] for each in read_json(results / f"{stem}.json")["made_from"]]
    files = [file for scene in scenes for file in results.glob(f"data/*/{scene}.nc")]
    made = [variables_of(read_dataset(file)) for file in files]
    number = stem.removeprefix("figures/").split("_")[0]
    # A figure of a user's own has no sample.
    for given in SAMPLES.get(number, dict)().values():
        drawn = variables_of(given[0] if isinstance(given, list) else given)
        assert any(drawn <= variables for variables in made)


def variables_of(data):
    """Names and dimensions of what a dataset holds, without its coordinates."""
    return {(name, each.dims) for name, each in data.items()}
