"""Fronts of any potentials: exact, travelling and driven, against theory and against each other."""

import functools

import numpy as np
import pytest
from configurations import DEFAULT

import granular_fronts as gf
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.jump_conditions_measured import (
    _settling,
    measure_jumps,
    travelling_speed,
)

SCENE = load_configuration(DEFAULT)["laws"]["jump_conditions"]
CASES = SCENE["cases"]
QUANTITIES = {
    "speed": ("exact", "travelling", "driven"),
    "velocity_jump": ("driven",),
    "power": ("exact", "driven"),
}


def law_of(name):
    return gf.make_law(elastic=CASES[name]["elastic"], viscous=CASES[name]["dissipation"])


def theory_of(name):
    return gf.jump_conditions(law_of(name), *CASES[name]["states"])


@functools.cache
def exact_front(name):
    """The front of a case, in the chain where it runs to larger n."""
    states = CASES[name]["states"][:: theory_of(name).direction]
    return gf.solve_front(law=law_of(name), states=states)


@pytest.mark.parametrize("name", CASES)
def test_exact_front_travels_in_a_chain(name):
    speed = travelling_speed(law_of(name), exact_front(name))
    assert speed.error < 1e-12
    assert abs(speed.value - abs(theory_of(name).speed)) <= speed.error


def test_another_front_does_not_travel():
    """With the damping of another law the same shape is no front, and the speed is off."""
    speed = travelling_speed(law_of("toda").with_damping(1.2), exact_front("toda"))
    assert abs(speed.value - abs(theory_of("toda").speed)) > 1e3 * speed.error


def test_driven_fronts_are_within_their_errors():
    names = ("hertz_kuwabara_kono", "fpu_alpha_stretched", "hertz_dashpot")
    found = measure_jumps({name: CASES[name] for name in names}, SCENE["beads"], SCENE["tolerance"])
    assert found["direction"].values.tolist() == [1, -1, 1]
    for quantity, ways in QUANTITIES.items():
        for way in ways:
            name = f"{quantity}_{way}"
            errors = found[f"{name}_error"] + found[f"{quantity}_expected_error"]
            assert (np.abs(found[name] - found[f"{quantity}_expected"]) <= errors).all(), name
            assert (found[f"{name}_error"] < (1e-6 if way == "driven" else 1e-12)).all(), name


def test_a_change_that_vanishes_by_chance_is_not_the_error():
    """The inverse square of the way changes by 3 and then by 3/4."""
    assert _settling(4.0, 1.0, 0.25).error == pytest.approx(0.75)
    assert _settling(4.0, 1.0, 1.0).error == pytest.approx(0.75)


def test_a_slow_front_on_a_short_way_states_a_larger_error():
    case = {
        "elastic": {"kind": "fpu", "cubic": 1},
        "dissipation": {"kind": "fpu", "quartic": 0.5},
        "states": [0.6, 0.1],
    }
    found = measure_jumps({"slow": case}, 200, 1e-9).isel(law=0)
    for quantity in QUANTITIES:
        error = float(found[f"{quantity}_driven_error"])
        distance = abs(float(found[f"{quantity}_driven"] - found[f"{quantity}_expected"]))
        assert distance <= error, quantity
    assert float(found["speed_driven_error"]) > 1e-4
