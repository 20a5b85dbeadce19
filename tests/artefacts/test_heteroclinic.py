"""The numbers behind figure 8 and the sweep over the damping, against the paper's statements."""

import numpy as np
import pytest
from conftest import read_dataset

SCENES = ["front_profiles", "damping_sweep"]
ACCURACY = 1.0e-13


@pytest.fixture(params=SCENES)
def survey(request, results):
    return read_dataset(results / "data" / "continuum" / f"{request.param}.nc", request.param)


@pytest.fixture
def profiles(results):
    return read_dataset(results / "data" / "continuum" / "front_profiles.nc", "front_profiles")


def test_every_variable_says_how_wrong_it_can_be(survey):
    assert survey.attrs["converged"] == 1
    for name, variable in survey.data_vars.items():
        known = {"error_estimate", "error_method"} <= variable.attrs.keys()
        assert known or name.endswith("_error") or f"{name}_error" in survey, name
    assert survey["rescaled_force"].attrs["error_estimate"] < ACCURACY


def test_fronts_run_from_one_to_zero_through_a_half(survey):
    y = survey["rescaled_force"]
    assert (y > 0.0).all()
    assert (y.sel(s=slice(0.5, None)) < 0.5).all()
    np.testing.assert_allclose(np.exp(survey["log_rescaled_force"]), y, rtol=1.0e-13)
    near = y.sel(s=0.0, method="nearest")
    assert (abs(near - 0.5) < 0.5 * abs(float(near["s"])) + ACCURACY).all()


def test_front_is_monotone_from_the_transition_on(survey):
    monotone = survey.sel(mu=survey["mu"] >= 2.0)
    assert (monotone["slope"] <= 0.0).all()
    assert (monotone["squared_slope_at_one"] < 1.0e-40).all()
    assert monotone["overshoot"].isnull().all()


def test_front_oscillates_for_weak_damping(profiles, as_in_the_paper):
    as_in_the_paper("continuum/front_profiles")
    overshoot = profiles["overshoot"].sel(mu=0.3).dropna("turn")
    assert overshoot.size > 10
    assert float(overshoot[0]) == pytest.approx(0.392557, abs=1.0e-6)
    assert (np.sign(overshoot[1:].values) == -np.sign(overshoot[:-1].values)).all()


def test_equation_holds_between_the_points_of_the_profile(profiles):
    """Energy law of (57), Simpson's rule on the stored points."""
    for mu in profiles["mu"].values:
        front = profiles.sel(mu=mu)
        y, z = front["rescaled_force"], front["slope"]
        energy = (0.5 * z**2 + 0.5 * y**2 * (front["log_rescaled_force"] - 0.5)).values[::2]
        step = float(front["s"][1] - front["s"][0])
        fed = (
            mu
            * step
            / 3.0
            * (z.values[:-2:2] ** 2 + 4.0 * z.values[1::2] ** 2 + z.values[2::2] ** 2)
        )
        np.testing.assert_allclose(np.diff(energy), fed, rtol=0, atol=0.02 * step**5)


def test_potential_is_a_double_well(profiles, as_in_the_paper):
    as_in_the_paper("continuum/front_profiles")
    potential = profiles["potential"]
    assert float(abs(potential["y"][potential.values.argmin()])) == pytest.approx(1.0, abs=1.0e-9)
    assert float(potential.min()) == pytest.approx(-0.25, abs=1.0e-12)
    np.testing.assert_allclose(potential, potential[::-1], rtol=0, atol=1.0e-12)


def test_trajectories_of_the_portrait_gain_energy(profiles):
    y, z = profiles["rescaled_force_portrait"], profiles["slope_portrait"]
    safe = abs(y).where(y != 0.0, 1.0)
    energy = 0.5 * z**2 + 0.5 * y**2 * (np.log(safe) - 0.5)
    gains = energy.diff("s_portrait")
    assert gains.min() > -1.0e-9
    assert gains.notnull().any()
