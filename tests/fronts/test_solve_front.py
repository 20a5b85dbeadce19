"""Exact fronts: identities, limits, tails, and the chain itself as the judge."""

import math
import re
import time

import numpy as np
import pytest
import xarray as xr

import granular_fronts as gf
from granular_fronts.errors import InputError, NoFrontError, SolveError
from granular_fronts.fronts import solitary_waves, solve
from granular_fronts.fronts.shooting import equations
from granular_fronts.studies import (
    front_survey,
    front_trends,
    fronts_compared,
    jump_conditions_measured,
)
from projects import ROOT


def test_critical_damping_by_overshoot_is_met_from_both_sides():
    """At the γ that is found the overshoot is the cut, above and below what the tail gives."""
    cuts = (1e-2, 1e-3, 1e-4)
    gammas = [gf.critical_damping(1.5, definition="overshoot", cut=cut) for cut in cuts]
    assert gammas == sorted(gammas)
    assert gammas[-1] < gf.critical_damping(1.5)
    overshoots = [gf.solve_front(1.5, gamma).attrs["overshoot"] for gamma in gammas]
    assert overshoots == pytest.approx(cuts, rel=1e-6)
    assert overshoots[1] == pytest.approx(1e-3, rel=1e-10)


NOT_AS_SOLVED = [
    (lambda front: front.isel(xi=slice(None, None, 2)), "thin, crop or shift the values"),
    (lambda front: front.isel(xi=slice(None, -40)), "thin, crop or shift the values"),
    (lambda front: front.sel(xi=abs(front["strain"] + 1.0) > 5e-11), "thin, crop or shift"),
    (lambda front: front.isel(xi=[]), "thin, crop or shift the values"),
    (lambda front: front.expand_dims("case"), "thin, crop or shift the values"),
    (lambda front: front.assign_coords(xi=front["xi"] + 1.0), "thin, crop or shift the values"),
    (lambda front: front.assign(strain=front["strain"].astype("float32")), "single precision"),
]


@pytest.mark.parametrize(("change", "words"), NOT_AS_SOLVED)
def test_a_front_that_is_not_as_it_was_solved_is_refused(change, words):
    """Local polynomials would go through points that are not where they seem to be."""
    front = gf.solve_front(1.5, 0.3)
    assert gf.evaluate_front(front.copy(), -1.0) == front["relative_displacement"].sel(xi=-1.0)
    with pytest.raises(InputError, match=words):
        gf.evaluate_front(change(front), -1.0)


def test_multipliers_are_known_for_two_powers_from_rest_only():
    plain, words = gf.solve_front(1.5, 0.3), "known only for two powers from compression 1"
    for front, reason in (
        (gf.solve_front(**TODA), words),
        (gf.solve_front(1.5, 0.3, right_state=0.2), words),
        (plain.assign_coords(xi=plain["xi"] + 0.1), "whole number of points"),
        (plain.drop_sel(xi=-3.0), "whole number of points"),
    ):
        with pytest.raises(InputError, match=reason):
            gf.front_multipliers(front)


def toda(viscous, states):
    return {"law": {"elastic": {"kind": "toda"}, "viscous": viscous}, "states": states}


LINEAR = {"kind": "linear", "gamma": 0.3}
POWERS, TODA = {"alpha": 1.5, "gamma": 0.2}, toda(LINEAR, (-2.0, 0.0))
NOT_FOUND = [
    ({"alpha": 5.0, "gamma": 1e-3}, "."),
    (POWERS | {"gamma": 1e8}, r"1.1e\+10 sites"),
    (POWERS | {"gamma": 1e-300}, "sites"),
    (POWERS | {"gamma": 1e8, "method": "shooting"}, "explicit steps"),
    (POWERS | {"gamma": 1e-5, "method": "shooting"}, "beads"),
    (TODA | {"states": (-1.0, -1.0 + 1e-9)}, "sites"),
    (toda(LINEAR | {"kind": "power", "beta": 1.0}, (-1.0, 0.5)), "128 points .* kink between"),
]


@pytest.mark.parametrize(("arguments", "words"), NOT_FOUND)
def test_what_cannot_be_found_is_a_record_at_once(arguments, words):
    begun = time.monotonic()
    front = gf.solve_front(**arguments)
    assert time.monotonic() - begun < 5.0
    assert front.attrs["converged"] == 0
    assert re.search(words, front.attrs["reason"])
    assert math.isnan(front.attrs["overshoot"])
    assert np.isnan(front["strain"].values).all()
    with pytest.raises(InputError, match="has not converged"):
        gf.evaluate_front(front, 0.0)


def test_a_front_is_kept_where_its_error_is_accepted_alone(monkeypatch):
    error = gf.solve_front(1.5, 0.3).attrs["error_estimate"]
    for accepted, converged in ((0.5 * error, 0), (2.0 * error, 1)):
        monkeypatch.setattr(solve, "ACCEPTED_ERROR", accepted)
        front = gf.solve_front(1.5, 0.3)
        assert front.attrs["converged"] == converged
        assert ("errs by" in front.attrs["reason"]) == (not converged)


def without_front(*_, **__):
    """A front whose iteration has failed."""
    return type("Failed", (), {"attrs": {"converged": 0, "reason": "the residual is 1"}})


LATTICE = {"elastic": {"kind": "toda"}, "dissipation": LINEAR, "states": [-1.0, 0.0]}
TOLERANCE = {"relative": 1e-6, "absolute": 1e-8}


@pytest.mark.parametrize(
    ("study", "ask", "words"),
    [
        (front_survey, lambda: front_survey.solve_converged(1.5, 0.3), r"^alpha = 1\.5, gamma"),
        (front_survey, lambda: front_trends.front_width(1.5, 0.3), r"^alpha = 1\.5, gamma"),
        (
            fronts_compared,
            lambda: fronts_compared._solve(1.5, 0.3, "shooting", "mine"),
            "^Scene mine: no front by shooting",
        ),
        (
            jump_conditions_measured,
            lambda: jump_conditions_measured._measure("mine", LATTICE, 40, TOLERANCE),
            "The front of mine",
        ),
    ],
)
def test_a_front_that_is_not_found_is_named(monkeypatch, study, ask, words):
    monkeypatch.setattr(study, "solve_front", without_front)
    with pytest.raises((NoFrontError, InputError), match=words + ".*the residual is 1"):
        ask()


def test_an_iteration_that_does_not_settle_says_so(monkeypatch):
    monkeypatch.setattr(solitary_waves, "ITERATIONS", 2)
    with pytest.raises(SolveError, match=r"alpha = 1\.5 is not found in 2 iterations"):
        solitary_waves.solitary_wave(1.5)
    monkeypatch.setattr(equations, "MOST_STEPS", 1)
    front = gf.solve_front(1.5, 0.3, method="shooting")
    assert not front.attrs["converged"]
    assert "not settled after 1 Gauss-Newton steps" in front.attrs["reason"]


@pytest.mark.parametrize("gamma", [0.1, 0.65])
@pytest.mark.parametrize("method", ["profile", "shooting"])
def test_front_is_that_of_extended_precision_within_its_error(gamma, method):
    states = xr.load_dataset(ROOT / "tests" / "references" / "fronts_reference.nc")
    front = gf.solve_front(1.5, gamma, method=method)
    for name in ("relative_displacement", "velocity"):
        [expected] = states[name].values[states["gamma"] == gamma]
        error = np.abs(gf.evaluate_front(front, states["bead"], name) - expected).max()
        assert error < min(5e-14, 2.0 * front[name].attrs["error_estimate"])
