"""The hard cases: their references are right, their criteria can fail, the methods pass them."""

import math

import numpy as np
import pytest

from granular_fronts.reference_methods.extended import reference_state
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.chain_scenes import pressed_chain
from granular_fronts.studies.hard_cases import (
    HardCase,
    chain_cases,
    contact_cases,
    event_orders,
    registry,
)
from measure_hard_cases import measure_case
from projects import ROOT

QUICK = ["delta_1e_8", "delta_1e8", "free_flight", "elastic_collision", "dashpot_collision"]
QUICK += ["front_triple_root", "front_crossing", "front_dashpot"]
QUICK += ["colliding_fronts", "mu_below_2", "mu_above_2"]
QUICK += ["energy_of_openings"]
SLOW = sorted(set(registry.CASES) - set(QUICK))

NOTHING = {"snapshots": []}


def assert_passes(name):
    case, seconds, refusal = registry.run_case(name)
    assert not refusal
    assert case.passed, f"{case.criterion}: {case.error} is above {case.limit}"
    assert math.isfinite(case.measured)
    assert seconds > 0.0


@pytest.mark.parametrize("name", QUICK)
def test_case_passes(name):
    assert_passes(name)


@pytest.mark.slow
@pytest.mark.parametrize("name", SLOW)
def test_slow_case_passes(name):
    assert_passes(name)


def test_error_that_is_no_number_does_not_pass():
    case = HardCase("", "", "", "", 0.0, math.nan, 1.0)
    assert not case.passed
    assert case._replace(error=1.0).passed
    assert not case._replace(error=np.nextafter(1.0, 2.0)).passed


@pytest.mark.slow
def test_criteria_fail_where_the_solver_is_loose(monkeypatch):
    monkeypatch.setattr(chain_cases, "TOLERANCE", (1.0e-6, 1.0e-8))
    for name in ("delta_1e8", "elastic_collision", "alpha_1_001", "colliding_fronts"):
        case, _, _ = registry.run_case(name)
        assert not case.passed, name


def test_every_default_case_exists():
    cases = load_configuration(ROOT / "config" / "default.yaml")["hard_cases"]
    assert cases == list(registry.CASES)


def test_unknown_case_is_refused_in_a_sentence():
    with pytest.raises(ValueError, match="gamma_7 is no hard case: choose one of gamma_zero,"):
        registry.run_case("gamma_7")


def test_refusal_of_a_solver_stands_in_the_row(monkeypatch):
    def refuse():
        raise ValueError("The step size collapsed.")

    monkeypatch.setitem(registry.CASES, "gamma_zero", refuse)
    row = measure_case("gamma_zero")
    assert row["passed"] == 0
    assert row["message"] == "The step size collapsed."
    assert math.isnan(row["error"])


def test_extended_reference_of_two_beads_pressed_from_both_sides_is_the_closed_form():
    gamma, end = 0.1, 3.0
    law = {"alpha": 1.0, "beta": 1.0, "gamma": gamma}
    start = [0.5], [0.0, 0.0]
    state = reference_state(
        pressed_chain(law, 2, end, (1e-9, 1e-9), NOTHING, right=1.0, start=start)
    )
    frequency = math.sqrt(2.0 - gamma**2)
    swing = math.cos(frequency * end) + gamma / frequency * math.sin(frequency * end)
    exact = 1.0 - 0.5 * math.exp(-gamma * end) * swing
    assert state.relative_displacement[0] == pytest.approx(exact, rel=0, abs=1e-15)


@pytest.mark.slow
def test_location_keeps_the_order_that_blind_steps_lose():
    orders = {
        name: event_orders.fitted_order(*curve)
        for name, curve in event_orders.measure_orders().items()
    }
    assert orders["strain_form"] > 8.0
    assert orders["positions_and_w"] == pytest.approx(2.5, abs=0.3)
    assert orders["positions_and_velocities"] == pytest.approx(1.5, abs=0.3)


def test_chaotic_motion_cannot_be_predicted():
    case = contact_cases.bouncing_bead()
    assert case.measured > 1.0e-4
