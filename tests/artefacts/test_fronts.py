"""The numbers behind the figures of exact fronts, against what must hold for any front."""

import numpy as np
import pytest
from conftest import read_dataset

SCENES = ["underdamped", "overdamped", "weak_underdamped", "weak_overdamped"]
ACCURACY = 1.0e-12


def exact_power(alpha):
    return (alpha - 1.0) / (2.0 * (alpha + 1.0))


@pytest.fixture(params=SCENES)
def front(request, results, as_in_the_paper):
    as_in_the_paper(f"fronts/{request.param}")
    return read_dataset(results / "data" / "fronts" / f"{request.param}.nc", request.param)


@pytest.fixture
def survey(results, as_in_the_paper):
    as_in_the_paper("fronts/survey")
    return read_dataset(results / "data" / "fronts" / "survey.nc", "survey")


@pytest.fixture
def plane(results, as_in_the_paper):
    as_in_the_paper("fronts/critical_damping")
    return read_dataset(results / "data" / "fronts" / "critical_damping.nc", "critical_damping")


@pytest.fixture
def spectra(results, as_in_the_paper):
    as_in_the_paper("fronts/multipliers")
    return read_dataset(results / "data" / "fronts" / "multipliers.nc", "multipliers")


def test_two_methods_give_one_front(front):
    for field in ("relative_displacement", "velocity"):
        assert front[f"{field}_shooting"].attrs["distance"] < ACCURACY
        assert front[field].attrs["error_estimate"] < ACCURACY


def test_a_driven_chain_comes_close_to_the_exact_front(front):
    assert front["relative_displacement_driven"].attrs["distance"] < 0.02


def test_every_front_has_its_power_and_its_speed(front, survey):
    power = exact_power(front.attrs["alpha"])
    assert front.attrs["dissipated_power"] == pytest.approx(power, rel=ACCURACY)
    assert abs(front.attrs["speed_defect"]) < ACCURACY
    assert (abs(survey["speed_defect"]) < ACCURACY).all()
    assert (abs(survey["dissipated_power"] / exact_power(survey["alpha"]) - 1.0) < ACCURACY).all()


def test_every_front_of_the_survey_is_accurate(survey):
    assert (survey["converged"] == 1).all()
    assert (survey["error"] < ACCURACY).all()


def test_continuum_fronts_hold_where_they_should(survey):
    strong = survey.isel(gamma=-1)
    assert (strong["distance_unlimited"] < strong["distance_logarithmic"]).all()
    weak = survey.isel(gamma=0).sel(alpha=survey["alpha"] <= 2.0)
    assert (weak["distance_heteroclinic"] < weak["distance_unlimited"]).all()


def test_meanings_of_critical_damping_are_in_order(plane):
    """Below alpha* the tail is a double root, near the long-wave formula; above it crosses."""
    below = plane.sel(alpha=plane["alpha"] < plane.attrs["exchange_exponent"])
    above = plane.sel(alpha=plane["alpha"] > plane.attrs["exchange_exponent"])
    both = below["critical_damping_tail"], below["critical_damping_double_root"]
    np.testing.assert_allclose(*both, rtol=1e-13)
    assert above["critical_damping_double_root"].isnull().all()
    assert (plane["critical_damping_overshoot"] <= plane["critical_damping_tail"]).all()


def test_fronts_are_stable(spectra):
    assert (spectra["translation_defect"].isel(beads_behind=-1) < 1.0e-3).all()
    assert (spectra["spectral_radius_without_translation"] < 1.0).all()
