"""The ring against its amplitude equations, and what is measured on both."""

import json

import numpy as np
import pytest
from configurations import DEFAULT, SMOKE

from granular_fronts.scenes.ring import Ring
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies import ring_measures as measures
from granular_fronts.studies.ring_against_equations import compare_with_chain, make_chain_scene

RECORD = {"snapshots": [0, 15, 30], "grid": {"step": 1}}
SMOKE_SCENE = load_configuration(DEFAULT, SMOKE)["scenes"]["periodic"]["weak"]
SCENE = SMOKE_SCENE | {"end_time": 30, "record": RECORD}


@pytest.fixture(scope="module")
def compared():
    dataset = compare_with_chain(SCENE, "weak")
    return dataset.assign_attrs(config=json.dumps(SCENE))


def test_ring_starts_as_the_paper_says():
    scene = make_chain_scene(Ring.read(SCENE, "weak"))
    u, velocity = (np.array(scene["start"][key]) for key in ("relative_displacement", "velocity"))
    assert u.size == 79
    assert u[39] == 5.0
    assert velocity[39] == pytest.approx(5.0**1.05)
    np.testing.assert_allclose(velocity / 5.0**1.05, (u / 5.0) ** 1.1, rtol=1e-12)
    np.testing.assert_array_equal(u, u[::-1])


def test_chain_and_equations_start_alike(compared):
    start = compared.sel(t=0.0)
    for name in ("logarithmic", "unlimited", "upwind"):
        equation = start[f"relative_displacement_{name}"].sel(site=start["bead"].values)
        near = 1.0e-12 if name != "upwind" else 0.01
        np.testing.assert_allclose(equation, start["relative_displacement"], atol=near)


def test_scheme_of_the_paper_stays_with_the_accurate_solution(compared):
    names = (f"relative_displacement_{solver}" for solver in ("upwind", "logarithmic"))
    scheme, accurate = (compared[name] for name in names)
    assert (abs(scheme - accurate).mean("site") < 0.005).all()


def test_solvers_contribute_far_less_than_the_model(compared):
    later = compared.isel(t_grid=slice(1, None))
    for field in ("relative_displacement", "velocity"):
        for equation in ("logarithmic", "unlimited"):
            names = [f"{field}_{kind}_{equation}" for kind in ("sup", "rms", "floor")]
            sup, rms, floor = (later[name] for name in names)
            assert np.all(rms <= sup)
            assert np.all(floor < 0.02 * sup)


def test_shock_runs_at_the_speed_of_the_front(compared):
    """The speed of a front into an uncompressed chain is c, eq. (21)."""
    chain, equation = measures.shock_speed(compared), measures.shock_speed_equation(compared)
    front = 5.0**0.05
    assert chain.value == pytest.approx(front, abs=0.02)
    assert equation.value == pytest.approx(front, abs=0.02)
    assert abs(measures.shock_lead(compared).value) < 1.0


def test_gap_and_bump_are_found(compared):
    assert measures.deepest_gap(compared).value < -1.0
    assert 0.0 <= measures.gap_of_equation(compared).value < 1e-3
    assert abs(measures.bump_of_equation(compared).value) < 0.01
    assert abs(measures.bump_birthplace(compared).value) < 5.0
    assert 0.05 < measures.bump_height(compared).value < 0.3
    assert -1.2 < measures.bump_velocity(compared).value < -0.8
