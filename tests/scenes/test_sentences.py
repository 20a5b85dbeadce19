"""What cannot be computed, found or proved is said in a sentence: which value, and what to do."""

import os

import numpy as np
import pytest
from rings import scene_with

import granular_fronts as gf
from granular_fronts.campaign.definition import check_campaign
from granular_fronts.continuum.evolution import evolve_unlimited
from granular_fronts.errors import InputError, NoFrontError, SolveError
from granular_fronts.fronts import solitary_waves
from granular_fronts.fronts.linear import floquet
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.shooting import equations
from granular_fronts.fronts.solve import solve_front
from granular_fronts.model.scaling import Scaling
from granular_fronts.output import files
from granular_fronts.proofs import __main__ as proofs
from granular_fronts.proofs import certificate, stored
from granular_fronts.studies import (
    front_survey,
    front_trends,
    fronts_compared,
    jump_conditions_measured,
)

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
MANY_BEADS = {
    "kind": "chain",
    "axes": {"beads": {"linspace": [40, 1e12, 3]}, "gamma": [0.1]},
    "fixed": {"alpha": 1.5, "delta": 0.1},
}


@pytest.mark.parametrize(
    ("ask", "words"),
    [
        (lambda: gf.restitution(1e308, alpha=1.5, beta=1.0), "collision lies beyond double"),
        (lambda: Scaling(1e300, 1e-300, 0.0, 1e-300), "A scale of this chain lies beyond double"),
        (
            lambda: solve_front(law=gf.make_law(**TODA), states=(-1.0, 0.0), method="shooting"),
            r'law \(28\).*use method "profile"',
        ),
        (
            lambda: solve_front(1.5, 0.3, right_state=0.2, method="shooting"),
            'at rest ahead.*use method "profile"',
        ),
        (lambda: stored.integers(2**63), "more than 18 digits"),
        (lambda: check_campaign(MANY_BEADS, "big"), r"beads \(entry 2\) is 500000000020"),
    ],
)
def test_what_cannot_be_is_refused(ask, words):
    with pytest.raises(InputError, match=words):
        ask()


@pytest.mark.parametrize("equation", ["logarithmic", "unlimited", "dispersive"])
def test_an_equation_that_a_scene_does_not_name_is_not_solved(equation):
    scene = scene_with()
    del scene["equations"]["upwind"], scene["equations"][equation]
    solve = {
        "logarithmic": gf.evolve_log_burgers,
        "unlimited": evolve_unlimited,
        "dispersive": gf.evolve_log_kdv_burgers,
    }[equation]
    with pytest.raises(InputError, match=rf"^Scene mine: equations\.{equation} is missing"):
        solve(scene, "mine")


def test_critical_damping_by_overshoot_is_met_from_both_sides():
    """At the γ that is found the overshoot is the cut, above and below what the tail gives."""
    tail = critical_damping(1.5)
    gammas = [critical_damping(1.5, definition="overshoot", cut=cut) for cut in (1e-2, 1e-4)]
    assert gammas[0] < gammas[1] < tail
    overshoots = [solve_front(1.5, gamma).attrs["overshoot"] for gamma in gammas]
    assert overshoots == pytest.approx([1e-2, 1e-4], rel=1e-6)


@pytest.mark.parametrize(
    ("values", "residual", "verdict"),
    [
        ([1.0, 0.9, 0.5], 1e-12, "no unstable multiplier found: "),
        ([1.0, 1.2j, -1.1], 1e-12, "unstable: 2 multipliers"),
        ([0.9, 0.5], 1e-12, "undecided: the multiplier of translation is 1.0e-01 away"),
        ([1.0, 0.5], 1e-1, "undecided: flow and shift change the state by 1.0e-01"),
    ],
)
def test_multipliers_are_judged_in_words(values, residual, verdict):
    assert floquet._verdict(np.array(values), residual).startswith(verdict)


def without_front(*_, **__):
    """A front whose iteration has failed."""
    return type("Failed", (), {"attrs": {"converged": 0, "reason": "the residual is 1"}})


LATTICE = {"elastic": TODA["elastic"], "dissipation": TODA["viscous"], "states": [-1.0, 0.0]}


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
            lambda: jump_conditions_measured._measure(
                "mine", LATTICE, 40, {"relative": 1e-6, "absolute": 1e-8}
            ),
            "The front of mine",
        ),
        (certificate, lambda: gf.prove_front("3/2", "0.3", "front.npz"), "no front to prove"),
    ],
)
def test_a_front_that_is_not_found_is_named(monkeypatch, tmp_path, study, ask, words):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(study, "solve_front", without_front)
    with pytest.raises((NoFrontError, InputError), match=words + ".*the residual is 1"):
        ask()


def test_an_iteration_that_does_not_settle_says_so(monkeypatch):
    monkeypatch.setattr(solitary_waves, "ITERATIONS", 2)
    with pytest.raises(SolveError, match=r"alpha = 1\.5 is not found in 2 iterations"):
        solitary_waves.solitary_wave(1.5)
    monkeypatch.setattr(equations, "MOST_STEPS", 1)
    front = solve_front(1.5, 0.3, method="shooting")
    assert not front.attrs["converged"]
    assert "not settled after 1 Gauss-Newton steps" in front.attrs["reason"]


def test_a_process_of_another_user_runs(monkeypatch):
    def forbidden(process, signal):
        raise PermissionError

    monkeypatch.setattr(os, "kill", forbidden)
    assert files.is_running(1)


def test_checker_asks_for_a_file(capsys):
    assert proofs.main([]) == 2
    assert "python -m granular_fronts.proofs FILE" in capsys.readouterr().out
