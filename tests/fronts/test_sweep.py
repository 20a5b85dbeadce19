"""Sweeps of exact fronts along the damping."""

import json

import numpy as np
import pytest
from potentials import cosh

import granular_fronts as gf
from granular_fronts.fronts import sweep as sweeps
from granular_fronts.numerics.extrapolation import (
    LARGEST_WEIGHT,
    REMEMBERED,
    extrapolation_weights,
    predict,
    remember,
)

HERTZ = gf.make_law(
    elastic={"kind": "hertz", "alpha": 1.5, "stiffness": 2.0},
    viscous={"kind": "power", "beta": 1.25, "gamma": 0.4},
)
LINEAR = {"kind": "linear", "gamma": 0.3}
CASES = {
    "hertz": {"alpha": 1.5},
    "two powers": {"alpha": 3.0, "beta": 4.0},
    "compressed": {"law": HERTZ, "states": (-0.5, -0.1)},
    "cosh": {"law": gf.make_law(elastic=cosh(), viscous=LINEAR), "states": (-2.0, -0.5)},
    "proportional": {
        "law": gf.make_law(
            elastic={"kind": "toda"}, viscous={"kind": "proportional", "gamma": 0.2}
        ),
        "states": (-1.5, 0.5),
    },
}


@pytest.mark.parametrize("name", CASES)
def test_sweep_agrees_with_single_fronts_in_any_order(name):
    case = CASES[name]
    by_law = "law" in case
    dampings = np.geomspace(0.5, 4.0, 12) if by_law else np.geomspace(0.08, 1.2, 25)
    shuffled = np.random.default_rng(3).permutation(dampings)
    axis = "factor" if by_law else "gamma"
    sweep = gf.sweep_fronts(**case, **{f"{axis}s": shuffled})
    np.testing.assert_array_equal(sweep[axis], shuffled)
    assert (sweep["converged"] == 1).all()
    if by_law:
        power = gf.jump_conditions(case["law"], *case["states"]).dissipated_power
        np.testing.assert_allclose(sweep["dissipated_power"], power, rtol=1e-12)
        assert json.loads(sweep.attrs["law"]) == case["law"].describe()
    else:
        power = (case["alpha"] - 1.0) / (2.0 * (case["alpha"] + 1.0))
        np.testing.assert_allclose(sweep["dissipated_power"], power, rtol=0, atol=1e-14)
        assert np.abs(sweep["speed_defect"]).max() <= 1e-14
        assert sweep["error_estimate"].max() <= 1e-12
    ordered = sweep.sortby(axis)
    assert (np.diff(ordered["width_10_90"]) > 0.0).all()
    assert (np.diff(ordered["overshoot"]) < 1e-14).all()
    assert min(sweep[f"{name}_error"].min() for name in ("width_10_90", "slope")) > 0.0
    # An error of the strain is one of the overshoot, and moves a level by it over the slope.
    error = sweep["error_estimate"] * (1.0 - 1e-12)
    assert (sweep["overshoot_error"] >= error).all()
    assert (sweep["width_10_90_error"] >= error / sweep["slope"]).all()
    for damping in shuffled[::5]:
        point = sweep.sel({axis: damping})
        if by_law:
            law = case["law"].with_damping(damping)
            front = gf.solve_front(law=law, states=case["states"])
        else:
            front = gf.solve_front(**case, gamma=damping)
            root = gf.tail_roots(**case, gamma=damping, count=1)[0]
            assert (point["tail_rate"], point["tail_frequency"]) == (root.real, root.imag)
        for measure in ("overshoot", "width_10_90", "slope", "dissipated_power"):
            allowed = 2.0 * (point[f"{measure}_error"] + front.attrs[f"{measure}_error"])
            allowed += 1e-14 * (1.0 + by_law * abs(front.attrs[measure]))
            assert abs(point[measure] - front.attrs[measure]) <= allowed


def test_repeated_dampings_have_one_front():
    once, twice = (gf.sweep_fronts(1.5, gammas) for gammas in ([0.3, 0.2], [0.3, 0.2, 0.3]))
    np.testing.assert_array_equal(twice["gamma"], [0.3, 0.2, 0.3])
    np.testing.assert_array_equal(twice["overshoot"], once["overshoot"].values[[0, 1, 0]])


@pytest.mark.parametrize("known", range(1, 8))
def test_prediction_is_exact_for_polynomials_of_the_place(known):
    """Cubic in ln γ from four fronts on, of windows whose middles move; rows are reused."""
    center, columns, degree = 30, 50, min(known, REMEMBERED) - 1
    places = np.linspace(0.0, -1.0, 11)
    xi = np.arange(columns) - center
    past = np.full((REMEMBERED, columns), np.nan)

    def front(place):
        return 0.5 - 0.01 * xi * (1.0 + 0.3 * place) ** degree

    for k in range(known):
        first = 3 + k % 3
        remember(front(places[k])[first:], first, 0.0, past[k % REMEMBERED])
    start = predict(past, known, places[:known], places[known], 6, 2)
    np.testing.assert_allclose(start, front(places[known])[6:], rtol=0, atol=1.0e-13)


def test_prediction_takes_fewer_fronts_for_a_long_step():
    places = np.array([0.0, -0.1, -0.2, -0.3])
    for size, step in ((4, 0.1), (3, 0.2), (2, 0.5), (1, 10.0)):
        weights = extrapolation_weights(places, -0.3 - step)
        assert weights.size == size
        assert weights.sum() == pytest.approx(1.0, abs=1.0e-14)
        assert np.abs(weights).sum() <= LARGEST_WEIGHT


@pytest.mark.parametrize(
    ("alpha", "gammas"), [(10.0, [0.5, 1e-3, 0.1]), (1.5, [1e300, 0.3, 1e-300])]
)
def test_points_that_fail_are_named_and_the_sweep_goes_on(alpha, gammas):
    """A window of 1e300 sites is allocated for no front."""
    sweep = gf.sweep_fronts(alpha, gammas)
    failed = sweep["converged"] == 0
    assert failed.values.tolist() == [gamma in (1e300, 1e-3, 1e-300) for gamma in gammas]
    assert ((sweep["reason"] != "") == failed).all()
    assert (np.isnan(sweep["overshoot"]) == failed).all()
    assert (np.diff(sweep["overshoot"][~failed]) > 0.0).all()


@pytest.mark.parametrize(
    ("found", "reason"),
    [(0, "fails a check on the grid of the sweep"), (1, "error of the front cannot be estimated")],
)
def test_a_front_without_values_has_not_converged(monkeypatch, found, reason):
    nothing = np.full((2, found, len(sweeps.COLUMNS)), np.nan)
    monkeypatch.setattr(sweeps, "follow", lambda *_: nothing)
    fronts = gf.sweep_fronts(1.5, [0.5])
    assert fronts["converged"].values.tolist() == [0]
    assert reason in str(fronts["reason"].values[0])
    assert np.isnan(fronts["width_10_90"]).all()


def test_no_number_of_an_inaccurate_front_is_kept(monkeypatch):
    monkeypatch.setattr(sweeps, "ACCEPTED_ERROR", 1e-30)
    fronts = gf.sweep_fronts(1.5, [0.5])
    assert "errs by about" in str(fronts["reason"].values[0])
    assert all(np.isnan(fronts[name]).all() for name in sweeps.MEASURES)


def test_a_front_that_is_solved_alone_is_kept_where_it_is_better(monkeypatch):
    gammas = np.geomspace(0.05, 1.5, 12)
    together = gf.sweep_fronts(1.5, gammas)["error_estimate"]
    monkeypatch.setattr(sweeps, "ACCEPTED_ERROR", 1e-30)
    kept = gf.sweep_fronts(1.5, gammas)["error_estimate"]
    assert (kept <= together).all()
    assert (kept < together).any()
