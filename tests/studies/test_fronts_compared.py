"""Exact fronts beside what approximates them: one frame, one phase, known limits."""

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.fronts.linear.floquet import compressed_chain_multipliers
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.scenes.front import Front
from granular_fronts.studies.continuum_fronts import continuum_fronts
from granular_fronts.studies.damping_map import map_plane
from granular_fronts.studies.front_survey import distances, survey_fronts
from granular_fronts.studies.fronts_compared import (
    compare_front,
    drive_front,
)
from granular_fronts.studies.log_burgers_fronts import evaluate_fronts
from granular_fronts.studies.multipliers import compute_multipliers

XI = np.linspace(-40.0, 40.0, 2001)
SCENE = {
    "law": {"alpha": 1.5, "gamma": 0.65},
    "displacement": 0.1,
    "window": {"start": -10.0, "stop": 5.0, "step": 0.1},
    "driven_bead": 60,
}


def test_damping_of_a_front_is_that_of_its_frame():
    """γc, James (2021), eq. (30), with c of eq. (21)."""
    assert Front.read(SCENE).normalised_damping == pytest.approx(0.65 * 0.1**0.25, rel=1e-15)


@pytest.mark.parametrize(("alpha", "gamma"), [(1.1, 0.06), (1.5, 0.3), (3.0, 2.0)])
def test_continuum_fronts_share_phase_and_ends(alpha, gamma):
    for u, velocity in continuum_fronts(alpha, gamma, XI).values():
        assert u[XI.size // 2] == pytest.approx(0.5, abs=1e-15)
        assert u[-1] == pytest.approx(0.0, abs=1e-3)
        assert velocity[0] == pytest.approx(u[0] ** alpha, abs=0.2)
    # That of the orbit is (43), here with differences of second order.
    u, velocity = continuum_fronts(alpha, gamma, XI)["heteroclinic"]
    expected = u**alpha - (gamma + 0.5) * np.gradient(u**alpha, XI)
    np.testing.assert_allclose(velocity, expected, rtol=0, atol=2e-3)
    far = continuum_fronts(alpha, gamma, np.array([-1e4]))
    for u, velocity in far.values():
        assert u[0] == velocity[0] == pytest.approx(1.0, abs=1e-13)


def test_continuum_fronts_become_exact_in_their_limits():
    """Strong damping: (46) errs by γ⁻² and (45) does not improve; α → 1 at fixed μ: by α − 1."""
    gammas, alphas = np.array([2.0, 4.0, 8.0]), np.array([1.04, 1.02, 1.01])
    strong = [distances(solve_front(1.2, gamma)) for gamma in gammas]
    errors = [each["distance_unlimited"] for each in strong]
    np.testing.assert_allclose(np.diff(np.log2(errors)), -2.0, rtol=0, atol=0.1)
    assert strong[-1]["distance_logarithmic"] > 0.9 * strong[0]["distance_logarithmic"]
    dampings = 0.8 * np.sqrt((1.0 - 1.0 / alphas) / 12.0)
    near = [distances(solve_front(*law)) for law in zip(alphas, dampings, strict=True)]
    errors = np.array([each["distance_heteroclinic"] for each in near])
    np.testing.assert_allclose(errors[:-1] / errors[1:], 2.0, rtol=0.15)


def test_a_driven_front_comes_closer_the_farther_it_has_run():
    front = solve_front(1.5, 0.3655)
    errors = []
    for bead in (50, 100, 200):
        driven = drive_front(1.5, 0.3655, bead)
        exact = evaluate_front(front, driven["xi"].values)
        near = np.abs(driven["xi"].values) < 20
        errors.append(np.abs(driven["relative_displacement"].values - exact)[near].max())
    assert errors[0] > 2.0 * errors[1] > 4.0 * errors[2]


def test_comparison_holds_every_method():
    # A step that does not divide the window ends before its stop, and is not stretched.
    compared = compare_front(SCENE | {"window": {"start": -10.0, "stop": 5.0, "step": 0.4}})
    np.testing.assert_allclose(compared["xi"], np.arange(-10.0, 5.0, 0.4), rtol=0, atol=1e-12)
    assert float(compared["relative_displacement_shooting"].attrs["distance"]) < 1e-12
    assert np.abs(compared["velocity_difference"]).max() < 1e-12
    for method in ("driven", "logarithmic", "unlimited", "heteroclinic"):
        assert compared[f"relative_displacement_{method}"].attrs["distance"] > 1e-9
    assert compared["residual_history_profile"].values[-1] < 1e-14


def test_survey_and_map_agree_with_single_fronts():
    survey = survey_fronts([1.3], [0.1, 1e-12, 0.5])
    dampings = {"start": 0.03, "stop": 2.0, "num": 24}
    plane = map_plane({"start": 1.3, "stop": 2.5, "num": 2}, dampings, 1e-3, [0.1, 1e-2])
    first = plane.isel(alpha=0)
    for name in ("tail", "long-wave"):
        curve = float(first[f"critical_damping_{name.replace('-', '_')}"])
        assert curve == gf.critical_damping(1.3, definition=name)
    # Only up to α* has the tail a double root.
    assert np.isnan(plane["critical_damping_double_root"]).all()
    for level, curve in zip(plane["level"].values, first["overshoot_level"].values, strict=True):
        exact = gf.critical_damping(1.3, definition="overshoot", cut=level)
        assert curve == pytest.approx(exact, rel=1e-11)
    last = plane.isel(alpha=1)
    for name, peak in (("second_peak_leads", "largest_peak"), ("first_peak_stays_below", None)):
        front = solve_front(2.5, float(last[name]))
        other = front.attrs[peak] if peak else 0.0
        assert front.attrs["first_peak"] == pytest.approx(other, abs=1e-13)
        # A little further on both have parted.
        beyond = solve_front(2.5, 1.001 * float(last[name]))
        assert beyond.attrs["first_peak"] < (beyond.attrs[peak] if peak else 0.0) - 1e-5
    lost = survey.isel(gamma=1, alpha=0)
    assert lost["converged"] == 0
    assert "sites" in str(lost["reason"].values)
    assert np.isnan(lost["overshoot"])
    for gamma in (0.1, 0.5):
        point = survey.sel(alpha=1.3, gamma=gamma)
        alone = solve_front(1.3, gamma)
        assert point["converged"] == 1
        assert float(point["overshoot"]) == alone.attrs["overshoot"]


def test_tabulated_fronts_are_46_in_closed_form():
    found = evaluate_fronts([1.2, 1.5])
    alpha, xi = found["alpha"], found["xi"]
    base = 1.0 - (1.0 - 2.0 ** (1.0 - alpha)) * np.exp(xi)
    exact = np.maximum(base, 0.0) ** (1.0 / (alpha - 1.0))
    np.testing.assert_allclose(found["front"], exact, rtol=0, atol=1e-14)


def test_essential_multipliers_are_those_of_the_compressed_chain_with_equal_exponents():
    found = compute_multipliers({"one": {"alpha": 1.5, "gamma": 0.5}}, [20]).isel(scene=0)
    exact = compressed_chain_multipliers(1.5, 0.5, 1.5, found["wavenumber"].values)
    np.testing.assert_array_equal(found["essential_multiplier_real"], exact.real)
    np.testing.assert_array_equal(found["essential_multiplier_imaginary"], exact.imag)
