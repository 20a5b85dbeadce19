"""Each figure is there, as a whole file of its kind."""

import pytest

FIGURES = [
    "fig01_initiation_underdamped",
    "fig02_spacetime_underdamped",
    "fig03_initiation_overdamped",
    "fig08_heteroclinic",
]


@pytest.mark.parametrize("name", FIGURES)
def test_png_is_whole(results, name):
    content = (results / "figures" / f"{name}.png").read_bytes()
    assert content.startswith(b"\x89PNG")
    assert b"IEND" in content[-12:]


@pytest.mark.parametrize("name", FIGURES)
def test_pdf_is_whole(results, name):
    content = (results / "figures" / f"{name}.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert b"%%EOF" in content[-12:]
