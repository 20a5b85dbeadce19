"""Each figure is there, as whole files of their kinds, with a caption, and says what it shows."""

import re

import pytest
from conftest import listed_as_made, read_dataset
from figure_samples import SAMPLES

from granular_fronts.output.files import read_json

FIGURES = listed_as_made().figures


@pytest.mark.parametrize("stem", FIGURES)
def test_png_is_whole(results, stem):
    content = (results / f"{stem}.png").read_bytes()
    assert content.startswith(b"\x89PNG")
    assert b"IEND" in content[-12:]


@pytest.mark.parametrize("stem", FIGURES)
def test_pdf_is_whole(results, stem):
    content = (results / f"{stem}.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert b"%%EOF" in content[-12:]


@pytest.mark.parametrize("stem", FIGURES)
def test_picture_names_what_it_was_drawn_from(results, stem):
    for made_from in read_json(results / f"{stem}.json")["made_from"]:
        keyword = ":".join(made_from.values()).encode()
        for ending in ("png", "pdf"):
            assert keyword in (results / f"{stem}.{ending}").read_bytes()


@pytest.mark.parametrize("stem", FIGURES)
def test_texts_are_filled(results, stem):
    record = read_json(results / f"{stem}.json")
    caption = (results / f"{stem}.rst").read_text(encoding="utf-8")
    for text in (caption, record["title"], record["alt"]):
        assert text.strip()
        assert not re.search(r"[{}]{2}|\bNone\b", text)


def number_of(stem):
    return stem.removeprefix("figures/").split("_")[0]


@pytest.mark.parametrize("stem", [stem for stem in FIGURES if number_of(stem) in SAMPLES])
def test_data_have_the_variables_that_the_tests_of_figures_draw(results, stem):
    """Those tests draw samples, which hold for the workflow only if its datasets are alike."""
    made_from = read_json(results / f"{stem}.json")["made_from"]
    files = [file for each in made_from for file in results.glob(f"data/*/{each['scene']}.nc")]
    made = [variables_of(read_dataset(file)) for file in files]
    for given in SAMPLES[number_of(stem)]().values():
        drawn = variables_of(given[0] if isinstance(given, list) else given)
        assert any(drawn <= variables for variables in made)


def variables_of(data):
    """Names and dimensions of what a dataset holds, without its coordinates."""
    return {(name, each.dims) for name, each in data.items()}
