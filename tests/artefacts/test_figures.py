"""Each figure is there, as a whole file of its kind."""

import pytest

FIGURES = [
    "fig01_initiation_underdamped",
    "fig02_spacetime_underdamped",
    "fig03_initiation_overdamped",
    "fig04_log_burgers_fronts",
    "fig05_initial_conditions",
    "fig06_periodic_chain_weak",
    "fig07_periodic_chain_hertz",
    "fig07b_model_error",
    "fig08_heteroclinic",
    "fig09_exact_fronts",
    "fig10_fronts_compared",
    "fig11_continuum_errors",
    "fig12_critical_damping",
    "fig13_multipliers",
    "fig17_jump_conditions",
    "fig18_damping_regimes",
    "fig19_numerical_damping",
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
