"""Exact fronts beside what approximates them: one frame, one phase, known limits."""

import numpy as np
import pytest

from granular_fronts.errors import InputError
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.scenes.validation import check_scene
from granular_fronts.studies.continuum_fronts import continuum_fronts
from granular_fronts.studies.damping_map import map_critical_damping
from granular_fronts.studies.front_survey import distances, survey_fronts
from granular_fronts.studies.fronts_compared import (
    compare_front,
    drive_front,
    normalised_damping,
)

XI = np.linspace(-40.0, 40.0, 2001)
SCENE = {
    "law": {"alpha": 1.5, "gamma": 0.65},
    "displacement": 0.1,
    "window": {"start": -10.0, "stop": 5.0, "step": 0.1},
    "driven_bead": 60,
}


def test_damping_of_a_front_is_that_of_its_frame():
    """γc, James (2021), eq. (30), with c of eq. (21)."""
    assert normalised_damping(SCENE) == pytest.approx(0.65 * 0.1**0.25, rel=1e-15)


@pytest.mark.parametrize(("alpha", "gamma"), [(1.1, 0.06), (1.5, 0.3), (3.0, 2.0)])
def test_continuum_fronts_share_phase_and_ends(alpha, gamma):
    for u, velocity in continuum_fronts(alpha, gamma, XI).values():
        assert u[XI.size // 2] == pytest.approx(0.5, abs=1e-15)
        assert u[-1] == pytest.approx(0.0, abs=1e-3)
        assert velocity[0] == pytest.approx(u[0] ** alpha, abs=0.2)
    far = continuum_fronts(alpha, gamma, np.array([-1e4]))
    for u, velocity in far.values():
        assert u[0] == velocity[0] == pytest.approx(1.0, abs=1e-13)


def test_unlimited_front_becomes_exact_for_strong_damping():
    """The error of (46) falls like γ⁻² (derived fact 5); that of (45) stays."""
    gammas = np.array([2.0, 4.0, 8.0])
    found = [distances(solve_front(1.2, gamma)) for gamma in gammas]
    errors = [each["distance_unlimited"] for each in found]
    slopes = np.diff(np.log(errors)) / np.diff(np.log(gammas))
    np.testing.assert_allclose(slopes, -2.0, atol=0.1)
    kept = [each["distance_logarithmic"] for each in found]
    assert kept[-1] > 0.9 * kept[0]


def test_heteroclinic_front_becomes_exact_in_its_limit():
    """α → 1 with μ fixed: the error falls in proportion to α − 1."""
    mu = 0.8
    alphas = np.array([1.04, 1.02, 1.01])
    gammas = mu * np.sqrt(1.0 - 1.0 / alphas) / (2.0 * np.sqrt(3.0))
    errors = [
        distances(solve_front(alpha, gamma))["distance_heteroclinic"]
        for alpha, gamma in zip(alphas, gammas, strict=True)
    ]
    ratios = np.array(errors[:-1]) / errors[1:]
    np.testing.assert_allclose(ratios, 2.0, rtol=0.15)


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
    compared = compare_front(SCENE)
    assert float(compared["relative_displacement_shooting"].attrs["distance"]) < 1e-12
    assert np.abs(compared["velocity_difference"]).max() < 1e-12
    for method in ("driven", "logarithmic", "unlimited", "heteroclinic"):
        assert compared[f"relative_displacement_{method}"].attrs["distance"] > 1e-9
    assert compared["residual_history_profile"].values[-1] < 1e-14


def test_window_is_kept_at_the_step_asked_for():
    """A step that does not divide the window ends before its stop, and is not stretched."""
    window = {"start": -10.0, "stop": 5.0, "step": 0.4}
    xi = compare_front(SCENE | {"window": window})["xi"].values
    np.testing.assert_allclose(np.diff(xi), 0.4, rtol=1e-13)
    assert xi[0] == -10.0
    assert 4.6 < xi[-1] <= 5.0


def test_survey_and_map_agree_with_single_fronts():
    survey = survey_fronts([1.3], [0.1, 1e-12, 0.5])
    plane = map_critical_damping(np.array([1.3]), np.array([0.1, 0.5]), 1e-3)
    lost = survey.isel(gamma=1, alpha=0)
    assert lost["converged"] == 0
    assert "sites" in str(lost["reason"].values)
    assert np.isnan(lost["overshoot"])
    for gamma in (0.1, 0.5):
        point = survey.sel(alpha=1.3, gamma=gamma)
        alone = solve_front(1.3, gamma)
        assert point["converged"] == 1
        assert float(point["overshoot"]) == alone.attrs["overshoot"]
        swept = float(plane["overshoot"].sel(alpha=1.3, gamma=gamma))
        error = plane["overshoot"].attrs["error_estimate"] + alone.attrs["error_estimate"]
        assert swept == pytest.approx(alone.attrs["overshoot"], abs=error)
        assert error < 1e-12


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"law": {"alpha": 1.0, "gamma": 0.1}}, "alpha"),
        ({"law": {"alpha": 1.5, "gamma": 0.0}}, "gamma"),
        ({"displacement": 0.0}, "displacement"),
        ({"driven_bead": 2}, "driven_bead"),
    ],
)
def test_impossible_scenes_are_refused(change, sentence):
    with pytest.raises(InputError, match=sentence):
        check_scene("front", SCENE | change, "mine")
