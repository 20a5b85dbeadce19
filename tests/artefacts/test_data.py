"""The data obey the laws they should, and say how wrong they can be."""

import json

import numpy as np
import pytest
from conftest import read_dataset

ACCURACY = 1.0e-12


@pytest.fixture
def data(results):
    """The data of a name."""
    return lambda name: read_dataset(results / f"data/{name}.nc", name.rpartition("/")[-1])


@pytest.fixture
def papers(data, as_in_the_paper):
    """The data of a name, where they have the paper's parameters."""

    def read(name):
        as_in_the_paper(name)
        return data(name)

    return read


def test_every_number_has_an_error(data, made):
    """Of fronts alone some datasets hold counts and spectra."""
    names = [name for name in made["datasets"] if not name.startswith("fronts/")]
    assert names
    for name in names:
        dataset = data(name)
        for variable, values in dataset.data_vars.items():
            if not variable.endswith("_error") and f"{variable}_error" not in dataset:
                assert values.attrs["error_method"], (name, variable)
                stated = values.attrs["error_estimate"]
                assert stated >= 0.0 or np.isnan(values).all(), (name, variable)


# Chains.

CHAINS = pytest.mark.parametrize("name", ["initiation_underdamped", "initiation_overdamped"])


@CHAINS
def test_momentum_and_energy_are_balanced(data, name):
    motion = data(f"chain/{name}")
    scene = json.loads(motion.attrs["config"])
    assert motion.attrs["momentum_drift"] < 1e-12
    assert motion.attrs["energy_drift"] < 1e3 * motion.attrs["relative_tolerance"]
    exact = scene["boundary"]["left"] ** scene["law"]["alpha"] * motion["t_grid"]
    np.testing.assert_allclose(motion["total_velocity"], exact, rtol=1e-12, atol=1e-13)


@CHAINS
def test_front_runs_at_the_predicted_speed(papers, name):
    motion = papers(f"chain/{name}")
    scene = json.loads(motion.attrs["config"])
    predicted = scene["boundary"]["left"] ** ((scene["law"]["alpha"] - 1.0) / 2.0)
    # The transient of the sudden start fades along the chain.
    assert float(motion["front_speed"]) == pytest.approx(predicted, rel=0.3 / scene["beads"])


def test_strong_damping_opens_no_gap(papers):
    motion = papers("chain/initiation_overdamped")
    assert np.isnan(motion["first_gap_time"])
    # Ahead of the wave the interpolation rounds to either side of zero.
    assert float(motion["relative_displacement_grid"].min()) > -1e-30


# Fronts of the logarithmic KdV–Burgers equation.


@pytest.mark.parametrize("name", ["front_profiles", "damping_sweep"])
def test_fronts_run_from_one_to_zero_through_a_half_and_from_the_transition_on_fall(data, name):
    survey = data(f"continuum/{name}")
    assert survey.attrs["converged"] == 1
    y = survey["rescaled_force"]
    assert y.attrs["error_estimate"] < 1e-13
    assert (y > 0.0).all()
    assert (y.sel(s=slice(0.5, None)) < 0.5).all()
    near = y.sel(s=0.0, method="nearest")
    assert (abs(near - 0.5) < 0.5 * abs(float(near["s"])) + ACCURACY).all()
    np.testing.assert_allclose(np.exp(survey["log_rescaled_force"]), y, rtol=1.0e-13)
    monotone = survey.sel(mu=survey["mu"] >= 2.0)
    assert (monotone["slope"] <= 0.0).all()
    assert (monotone["squared_slope_at_one"] < 1.0e-40).all()
    assert monotone["overshoot"].isnull().all()


def test_front_oscillates_for_weak_damping(papers):
    overshoot = papers("continuum/front_profiles")["overshoot"].sel(mu=0.3).dropna("turn")
    assert overshoot.size > 10
    assert float(overshoot[0]) == pytest.approx(0.392557, abs=1.0e-6)
    assert (np.sign(overshoot[1:].values) == -np.sign(overshoot[:-1].values)).all()


# Exact fronts of the lattice.


def exact_power(alpha):
    return (alpha - 1.0) / (2.0 * (alpha + 1.0))


@pytest.mark.parametrize(
    "name", ["underdamped", "overdamped", "weak_underdamped", "weak_overdamped"]
)
def test_two_methods_give_one_front_with_its_power_near_that_of_a_driven_chain(papers, name):
    front = papers(f"fronts/{name}")
    for field in ("relative_displacement", "velocity"):
        assert front[f"{field}_shooting"].attrs["distance"] < ACCURACY
        assert front[field].attrs["error_estimate"] < ACCURACY
    power = exact_power(front.attrs["alpha"])
    assert front.attrs["dissipated_power"] == pytest.approx(power, rel=ACCURACY)
    assert abs(front.attrs["speed_defect"]) < ACCURACY
    assert front["relative_displacement_driven"].attrs["distance"] < 0.02


def test_fronts_of_the_survey_are_exact_and_continuum_fronts_hold_where_they_should(papers):
    survey = papers("fronts/survey")
    assert (survey["converged"] == 1).all()
    assert (survey["error"] < ACCURACY).all()
    assert (abs(survey["speed_defect"]) < ACCURACY).all()
    assert (abs(survey["dissipated_power"] / exact_power(survey["alpha"]) - 1.0) < ACCURACY).all()
    strong = survey.isel(gamma=-1)
    assert (strong["distance_unlimited"] < strong["distance_logarithmic"]).all()
    weak = survey.isel(gamma=0).sel(alpha=survey["alpha"] <= 2.0)
    assert (weak["distance_heteroclinic"] < weak["distance_unlimited"]).all()


def test_meanings_of_critical_damping_are_in_order(papers):
    """Below alpha* the tail is a double root, near the long-wave formula; above it crosses."""
    plane = papers("fronts/critical_damping")
    below = plane.sel(alpha=plane["alpha"] < plane.attrs["exchange_exponent"])
    above = plane.sel(alpha=plane["alpha"] > plane.attrs["exchange_exponent"])
    both = below["critical_damping_tail"], below["critical_damping_double_root"]
    np.testing.assert_allclose(*both, rtol=1e-13)
    assert above["critical_damping_double_root"].isnull().all()
    assert (plane["critical_damping_overshoot"] <= plane["critical_damping_tail"]).all()


def test_fronts_are_stable(papers):
    spectra = papers("fronts/multipliers")
    assert (spectra["translation_defect"] < 1.0e-6).all()
    assert (spectra["spectral_radius_without_translation"] < 1.0).all()


def test_fronts_of_many_laws_agree_with_the_jump_conditions(papers):
    data = papers("laws/jump_conditions")
    assert data.sizes["law"] >= 8
    for quantity, how in (
        *(("speed", how) for how in ("exact", "travelling", "driven")),
        *(("power", how) for how in ("exact", "driven")),
        ("velocity_jump", "driven"),
    ):
        measured, expected = f"{quantity}_{how}", f"{quantity}_expected"
        errors = data[f"{measured}_error"] + data[f"{expected}_error"]
        assert (abs(data[measured] - data[expected]) <= errors).all(), measured
        assert how == "driven" or (data[f"{measured}_error"] < 1e-12).all(), measured
