"""Each figure is there, as whole files of their kinds, with a caption, and says what it shows."""

import re

import pytest
from conftest import listed_as_made

from granular_fronts.output.provenance import read_record

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
    for made_from in read_record(results / f"{stem}.json")["made_from"]:
        keyword = "{scene}:{question}:{data}".format(**made_from).encode()
        for ending in ("png", "pdf"):
            assert keyword in (results / f"{stem}.{ending}").read_bytes()


@pytest.mark.parametrize("stem", FIGURES)
def test_texts_are_filled(results, stem):
    record = read_record(results / f"{stem}.json")
    caption = (results / f"{stem}.rst").read_text(encoding="utf-8")
    for text in (caption, record["title"], record["alt"]):
        assert text.strip()
        assert not re.search(r"[{}]{2}|\bNone\b", text)
