"""What cannot be computed, found or proved is said in a sentence: which value, and what to do."""

import importlib.util
import os

import numpy as np
import pytest
from configurations import SMOKE, refusal, set_value

import granular_fronts as gf
from granular_fronts.campaign.definition import check_campaign
from granular_fronts.errors import InputError, NoFrontError, SolveError
from granular_fronts.fronts import solitary_waves
from granular_fronts.fronts.linear import floquet
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.shooting import gauss_newton
from granular_fronts.fronts.solve import solve_front
from granular_fronts.model.scaling import Scaling
from granular_fronts.output import files, progress
from granular_fronts.proofs import __main__ as proofs
from granular_fronts.proofs import certificate, stored
from granular_fronts.studies import (
    front_survey,
    front_trends,
    fronts_compared,
    jump_conditions_measured,
)
from step import is_held, load_yaml_or_leaf

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}


def test_public_names_are_listed():
    assert set(gf.__all__) <= set(dir(gf))
    assert all(getattr(gf, name) for name in gf.__all__)


def test_a_collision_beyond_double_precision():
    with pytest.raises(InputError, match=r"damping of this collision lies beyond double precision"):
        gf.restitution(1e308, alpha=1.5, beta=1.0)


def test_scales_beyond_double_precision():
    with pytest.raises(InputError, match=r"A scale of this chain lies beyond .*: give values"):
        Scaling(mass=1e300, stiffness=1e-300, velocity=1e-300, damping=0.0)


def test_a_solitary_wave_whose_iteration_does_not_settle(monkeypatch):
    monkeypatch.setattr(solitary_waves, "ITERATIONS", 2)
    with pytest.raises(SolveError, match=r"alpha = 1\.5 is not found in 2 iterations: choose"):
        solitary_waves.solitary_wave(1.5)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"law": gf.make_law(**TODA), "states": (-1.0, 0.0)}, r"shooting takes the law \(28\)"),
        ({"alpha": 1.5, "gamma": 0.3, "right_state": 0.2}, "needs a chain at rest ahead"),
    ],
)
def test_shooting_names_the_method_for_other_fronts(arguments, words):
    with pytest.raises(InputError, match=rf'{words}.*use method "profile"'):
        solve_front(**arguments, method="shooting")


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
        ([1.0, 0.9, 0.5], 1e-12, "stable: beside translation all multipliers lie inside"),
        (
            [1.0, 1.2j, -1.1],
            1e-12,
            "unstable: 2 multipliers outside the unit circle, the largest",
        ),
        ([0.9, 0.5], 1e-12, "undecided: the multiplier of translation is 1.0e-01 away from 1"),
        ([1.0, 0.5], 1e-1, "undecided: flow and shift change the state by 1.0e-01"),
    ],
)
def test_multipliers_are_judged_in_words(values, residual, verdict):
    assert floquet._verdict(np.array(values), residual).startswith(verdict)


def without_front(*_, **__):
    """A front whose iteration has failed."""
    return type("Failed", (), {"attrs": {"converged": 0, "reason": "the residual is 1"}})


@pytest.mark.parametrize(
    ("study", "ask", "sentence"),
    [
        (
            front_survey,
            lambda: front_survey.solve_converged(1.5, 0.3),
            r"^alpha = 1\.5, gamma = 0\.3",
        ),
        (front_trends, lambda: front_trends.front_width(1.5, 0.3), r"^No front for alpha = 1\.5"),
        (
            fronts_compared,
            lambda: fronts_compared._solve(1.5, 0.3, "shooting", "mine"),
            r"^Scene mine: no front by shooting: ",
        ),
    ],
    ids=["survey", "trends", "comparison"],
)
def test_a_study_names_the_front_that_it_does_not_find(monkeypatch, study, ask, sentence):
    monkeypatch.setattr(study, "solve_front", without_front)
    with pytest.raises(NoFrontError, match=sentence + ".*the residual is 1"):
        ask()


def test_states_of_a_case_outside_its_law(default):
    laws = default["laws"]["jump_conditions"]["cases"]
    laws["mine"] = {
        "elastic": {"kind": "lennard_jones"},
        "dissipation": {"kind": "linear", "gamma": 0.3},
        "states": [-5.0, 0.0],
    }
    assert "states has -5" in refusal(default)
    assert "give states between" in refusal(default)


def test_a_scene_that_a_figure_needs(default):
    del default["scenes"]["chain"]["initiation_underdamped"]
    assert (
        "scenes.chain.initiation_underdamped is missing, but figure 1 needs it: give it as "
        "config/default.yaml does." in refusal(default)
    )


def test_a_list_that_is_too_long(default):
    changed = set_value(default, "laws.jump_conditions.cases.toda.states", [-1.0, -0.5, 0.0])
    assert "has 3 entries, above its limit 2: list 2 or less" in refusal(changed)


def test_a_configuration_file_that_is_not_there():
    with pytest.raises(Exception, match=r"There is no file nowhere\.yaml: name one that exists"):
        load_yaml_or_leaf("nowhere.yaml:scenes.chain")
    with pytest.raises(Exception, match=r"stops at nothing: choose one of results, scenes"):
        load_yaml_or_leaf(f"{SMOKE}:nothing")


def test_a_lock_is_free_when_nobody_holds_it(tmp_path):
    lock = tmp_path / ".lock"
    assert is_held(lock)
    lock.touch()
    assert not is_held(lock)


def test_a_process_of_another_user_runs(monkeypatch):
    def forbidden(process, signal):
        raise PermissionError

    monkeypatch.setattr(os, "kill", forbidden)
    assert files.is_running(1)


def test_widgets_are_looked_for(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert not progress._has_widgets()
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: name)
    assert progress._has_widgets()


def test_checker_asks_for_a_file(capsys):
    assert proofs.main([]) == 2
    assert "python -m granular_fronts.proofs FILE" in capsys.readouterr().out


def test_a_table_of_jump_conditions_names_the_lattice_without_a_front(monkeypatch):
    monkeypatch.setattr(jump_conditions_measured, "solve_front", without_front)
    case = {"elastic": TODA["elastic"], "dissipation": TODA["viscous"], "states": [-1.0, 0.0]}
    with pytest.raises(NoFrontError, match=r"^The front of mine is not found: the residual is 1"):
        jump_conditions_measured._measure("mine", case, 40, {"relative": 1e-6, "absolute": 1e-8})


def test_a_shot_that_does_not_settle_says_why(monkeypatch):
    monkeypatch.setattr(gauss_newton, "MOST_STEPS", 1)
    front = solve_front(1.5, 0.3, method="shooting")
    assert not front.attrs["converged"]
    assert "not settled after 1 Gauss-Newton steps" in front.attrs["reason"]


def test_a_certificate_needs_a_front(monkeypatch, tmp_path):
    monkeypatch.setattr(certificate, "solve_front", without_front)
    with pytest.raises(InputError, match=r"no front to prove: the residual is 1"):
        gf.prove_front("3/2", "0.3", tmp_path / "front.npz")


def test_a_fraction_with_too_many_digits():
    with pytest.raises(InputError, match=r"a fraction has more than 18 digits: round it"):
        stored.integers(2**63)


def test_a_campaign_may_give_beads_by_a_range():
    axes = {"beads": {"linspace": [40, 1e12, 3]}, "gamma": [0.1]}
    with pytest.raises(InputError, match=r"axes\.beads"):
        check_campaign(
            {"kind": "chain", "axes": axes, "fixed": {"alpha": 1.5, "delta": 0.1}}, "big"
        )
