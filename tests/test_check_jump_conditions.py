"""Fronts of any potentials: exact, travelling and driven, against theory and against each other."""

import functools
import math
from pathlib import Path

import numpy as np
import pytest
import yaml
from potentials import fpu, hertz, toda

import granular_fronts as gf
from granular_fronts.chain.any_law import compile_law, make_chain, run_chain
from granular_fronts.errors import InputError, SolveError
from granular_fronts.fronts.profile.any_law import (
    FIRST_SPACING,
    ORDER,
    refine,
    solve_any_front,
    solve_on_grid,
)
from granular_fronts.fronts.profile.lattice import choose_window, long_wave_front, make_lattice
from granular_fronts.model.named_potentials import make_slope
from granular_fronts.model.potentials import make_potential
from granular_fronts.scenes.configuration import check_configuration
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.jump_conditions_measured import measure_jumps, travelling_speed

FILE = Path(__file__).parents[1] / "config" / "default.yaml"
SCENE = load_configuration(FILE)["laws"]["jump_conditions"]
CASES = SCENE["cases"]
QUANTITIES = {
    "speed": ("exact", "travelling", "driven"),
    "velocity_jump": ("driven",),
    "power": ("exact", "driven"),
}
by_case = pytest.mark.parametrize("name", CASES)
TODA = CASES["toda_nonlinear"]


def lattice_of(case):
    potentials = (make_potential(**case[key]) for key in ("elastic", "dissipation"))
    return make_lattice(*potentials, *map(float, case["states"]))


@functools.cache
def exact_front(name):
    return solve_any_front(lattice_of(CASES[name]))


@functools.cache
def compiled(name):
    return compile_law(*(make_slope(CASES[name][key]) for key in ("elastic", "dissipation")))


def theory_of(case):
    return gf.jump_conditions(make_potential(**case["elastic"]), *case["states"])


@by_case
def test_slopes_are_the_derivatives_of_the_potentials(name):
    for key in ("elastic", "dissipation"):
        slope, potential = make_slope(CASES[name][key]), make_potential(**CASES[name][key])
        r = np.linspace(min(CASES[name]["states"]), 0.4, 37)
        expected = potential.first(r)
        np.testing.assert_allclose([slope(one) for one in r], expected, rtol=1e-14, atol=1e-16)


@by_case
def test_exact_front_obeys_the_jump_conditions(name):
    """The speed is an unknown and the power an integral; neither knows of the theory."""
    front, theory = exact_front(name), theory_of(CASES[name])
    assert not front.reason
    assert front.speed == pytest.approx(abs(theory.speed), rel=1e-14)
    assert front.dissipated_power() == pytest.approx(theory.dissipated_power, rel=1e-14)


@by_case
def test_exact_front_does_not_depend_on_grid_order_and_window(name):
    front = exact_front(name)
    refined = refine(front)
    assert refined.spacing < front.spacing
    assert refined.u.size > front.u.size
    assert np.abs(refined.evaluate(front.xi) - front.u).max() < 2e-14


@by_case
def test_exact_front_travels_in_a_chain(name):
    speed = travelling_speed(compiled(name), exact_front(name))
    assert speed.error < 1e-12
    assert abs(speed.value - abs(theory_of(CASES[name]).speed)) <= speed.error


@pytest.mark.parametrize(("beta", "gamma"), [(1.5, 0.2), (1.0, 0.4), (2.5, 0.6)])
def test_hertz_front_is_that_of_the_profile_equation(beta, gamma):
    found = solve_any_front(make_lattice(hertz(1.5), hertz(beta, gamma), -1.0, 0.0))
    known = gf.solve_front(1.5, gamma, beta)
    xi = np.linspace(-20.0, 10.0, 301)
    np.testing.assert_allclose(found.evaluate(xi), gf.evaluate_front(known, xi), atol=1e-13)


def test_weak_damping_is_reached_from_strong_damping():
    """Where the long-wave start alone does not lead to the front."""
    lattice = make_lattice(toda(), fpu(0.1), -2.0, 0.0)._replace(factor=0.5)
    start = long_wave_front(lattice)
    direct = solve_on_grid(lattice, choose_window(lattice), FIRST_SPACING, ORDER, start)
    assert direct.reason
    front, theory = solve_any_front(lattice), gf.jump_conditions(toda(), -2.0, 0.0)
    assert not front.reason
    assert front.u.max() > 1.25
    assert front.dissipated_power() == pytest.approx(theory.dissipated_power, rel=1e-12)


@pytest.mark.parametrize(
    ("potential", "states", "sentence"),
    [
        (hertz(0.5), (-1.0, 0.0), "V'' is inf, W'' is 1"),
        (fpu(1.0, 0.0, 1.0), (-1.0, 0.9), "choose states between which V''' has one sign"),
    ],
)
def test_fronts_that_are_not_sought_are_refused(potential, states, sentence):
    """A softening contact that just touches, and a front as fast as sound on neither side."""
    with pytest.raises(ValueError, match=sentence):
        make_lattice(potential, fpu(1.0), *states)


def test_a_front_too_sharp_for_the_grid_is_no_front():
    lattice = make_lattice(hertz(300.0), hertz(300.0, 0.3), -1.0, 0.0)
    assert solve_any_front(lattice).reason


def test_direction_follows_the_reflection():
    """The same potentials with the states swapped make the mirrored front."""
    there, back = (make_potential(**TODA[key]) for key in ("elastic", "dissipation"))
    right = solve_any_front(make_lattice(there, back, -2.0, 0.0))
    left = solve_any_front(make_lattice(there, back, 0.0, -2.0))
    np.testing.assert_array_equal(right.u, left.u)
    assert gf.jump_conditions(there, -2.0, 0.0).direction == 1
    assert gf.jump_conditions(there, 0.0, -2.0).direction == -1


def start_pulse(contacts, law):
    """A chain with one compressed place, at rest at both ends."""
    sites = np.arange(contacts + 2.0)
    strain = np.where(sites == 0.0, 0.0, -0.8 * np.exp(-(((sites - 60.0) / 4.0) ** 2)))
    return make_chain(law, strain, 0.1 * strain, 0.05)


@by_case
def test_momentum_is_kept_to_rounding(name):
    """Σ n d_n grows by V'(r_0) − V'(r_(N+1)) per time while the ends are at rest."""
    contacts, front = 240, exact_front(name)
    lattice = front.lattice
    sites = np.arange(contacts + 2.0) - 120.0
    strain = lattice.strain(front.evaluate(sites))
    strain[0], strain[-1] = lattice.behind, lattice.ahead
    jump = lattice.behind - lattice.ahead
    rate = -front.speed * jump * front.evaluate_slope(sites)
    chain = make_chain(compiled(name), strain, rate, 0.05)
    n = np.arange(1, contacts + 1)
    before, time = n @ chain.state.d[1 : contacts + 1], 20.0
    run_chain(chain, time, 1e-9)
    grown = n @ chain.state.d[1 : contacts + 1] - before
    pushed = lattice.potential.first(np.array([lattice.behind, lattice.ahead]))
    assert grown == pytest.approx(time * (pushed[0] - pushed[1]), rel=1e-11)


def test_energy_is_dissipated_as_the_balance_says():
    """Energy lost in a short time is the integral of Σ W''(r) ṙ² by Gauss quadrature (6)."""
    chain = start_pulse(120, compiled("toda_nonlinear"))
    potential, dissipation = (make_potential(**TODA[key]) for key in ("elastic", "dissipation"))

    def energy():
        velocities = np.concatenate([[0.0], np.cumsum(chain.strain_rate)])
        velocities -= velocities.mean()
        return 0.5 * (velocities**2).sum() + potential.value(chain.strain).sum()

    run_chain(chain, 2.0, 1e-13)
    before, lost = energy(), 0.0
    nodes, weights = np.polynomial.legendre.leggauss(12)
    for node, weight in zip(nodes, weights, strict=True):
        run_chain(chain, 2.5 + 0.5 * node, 1e-13)
        power = (dissipation.second(chain.strain) * chain.strain_rate**2).sum()
        lost += 0.5 * weight * power
    run_chain(chain, 3.0, 1e-13)
    assert lost > 1e-3
    assert before - energy() == pytest.approx(lost, rel=1e-10)


def test_the_chain_is_that_of_the_specialised_engine():
    """Kuwabara-Kono beads pressed at one end, by both engines."""
    beads, delta, end = 40, 0.1, 60.0
    law = compile_law(
        lambda r: -((-r) ** 1.5) if r < 0.0 else 0.0, lambda r: -0.3 * (-r) ** 1.5 if r < 0 else 0.0
    )
    strain = np.zeros(beads + 1)
    strain[0] = -delta
    # The bead next to the pressed end is at rest, ẋ_1 = 0.
    chain = make_chain(law, strain, np.zeros(beads + 1), 0.01)
    run_chain(chain, end, 1e-14)
    motion = gf.simulate_chain(
        {
            "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.3},
            "beads": beads,
            "boundary": {"kind": "pressure", "left": delta, "right": 0.0},
            "start": {"kind": "rest"},
            "end_time": end,
            "tolerance": {"relative": 1e-13, "absolute": 1e-15},
            "record": {"snapshots": [end]},
        }
    )
    u = motion["relative_displacement"].values[0, : beads - 1]
    np.testing.assert_allclose(-chain.strain[1:beads], u, atol=1e-11)


@pytest.mark.parametrize("origin", [4, 31])
@by_case
def test_contacts_ahead_of_the_wave_need_no_visit(name, origin):
    """The same steps, strains and times of passage where the window is the whole chain.

    The jump stands within a block and at the end of one; the first step is long.
    """
    contacts = 300
    behind, ahead = map(float, CASES[name]["states"])
    sites, middle = np.arange(contacts + 2), 0.5 * (behind + ahead)
    strain = np.where(sites < origin, behind, np.where(sites == origin, middle, ahead))
    rate = np.where(sites == origin, behind - ahead, 0.0)
    chain, whole = (make_chain(compiled(name), strain, rate, 0.2) for _ in range(2))
    whole.reach[0] = contacts
    times, all_times = np.full((2, contacts + 2), math.nan)
    run_chain(chain, 30.0, 1e-10, middle, times)
    run_chain(whole, 30.0, 1e-10, middle, all_times)
    assert 32 < chain.reach[0] < whole.reach[0]
    np.testing.assert_array_equal(chain.counts, whole.counts)
    # Loops of another length are rounded differently at their end, by a unit in every step.
    rounding = {"rtol": 0.0, "atol": 4.0 * np.finfo(float).eps * whole.counts.sum()}
    np.testing.assert_allclose(chain.strain, whole.strain, **rounding)
    np.testing.assert_allclose(chain.strain_rate, whole.strain_rate, **rounding)
    np.testing.assert_allclose(times, all_times, rtol=1e-14, atol=0.0)


def test_the_window_ends_ahead_of_every_disturbance():
    """Of the strain or of its rate, and at most at the last contact."""
    strain = np.zeros(202)
    strain[150] = -1e-12
    assert make_chain(compiled("toda"), strain, np.zeros(202), 0.1).reach[0] == 192
    strain[190] = -1e-12
    assert make_chain(compiled("toda"), strain, np.zeros(202), 0.1).reach[0] == 200
    assert make_chain(compiled("toda"), np.zeros(202), strain, 0.1).reach[0] == 200


@pytest.mark.parametrize("exponent", [0.5, 1.0, 1.5, 2.5, 1.3])
def test_a_compiled_power_is_good_to_round_off(exponent):
    """As V' and, halved, as W'; exponents of which it makes square roots, and one of which not."""
    law = compile_law(lambda r: r**exponent, lambda r: 0.5 * r**exponent)
    strain = np.geomspace(1e-9, 10.0, 203)
    chain = make_chain(law, strain, np.zeros(203), 0.1)
    expected = strain**exponent
    np.testing.assert_allclose(chain.state.force[: strain.size], expected, rtol=1e-15)
    np.testing.assert_allclose(chain.state.damping[: strain.size], 0.5 * expected, rtol=1e-15)


def test_steps_that_collapse_are_refused():
    law = compile_law(lambda r: r / (1.0 - r) if r < 1.0 else math.nan, lambda r: 0.0 * r)
    strain = np.array([0.0, 0.5, 0.0, 0.0])
    chain = make_chain(law, strain, np.array([0.0, 1e12, 0.0, 0.0]), 0.1)
    with pytest.raises(SolveError, match="The steps collapse at t = "):
        run_chain(chain, 10.0, 1e-12)


def test_driven_fronts_are_within_their_errors():
    names = ("hertz_kuwabara_kono", "fpu_alpha_stretched")
    found = measure_jumps({name: CASES[name] for name in names}, SCENE["beads"], SCENE["tolerance"])
    assert found["direction"].values.tolist() == [1, -1]
    for quantity, ways in QUANTITIES.items():
        for way in ways:
            name = f"{quantity}_{way}"
            errors = found[f"{name}_error"] + found[f"{quantity}_expected_error"]
            assert (np.abs(found[name] - found[f"{quantity}_expected"]) <= errors).all(), name
            assert (found[f"{name}_error"] < (1e-6 if way == "driven" else 1e-12)).all(), name


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


def test_a_state_pair_without_a_front_is_refused_with_theory():
    harmonic = {"elastic": {"kind": "fpu"}, "dissipation": {"kind": "fpu"}, "states": [0, 1]}
    with pytest.raises(ValueError, match="Remark 3"):
        measure_jumps({"harmonic": harmonic}, 64, 1e-6)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"beads": 10}, "beads is 10, below its limit 64"),
        ({"tolerance": 0}, "tolerance is 0, below its limit 1e-14"),
        (
            {"cases": {"toda": {"elastic": {"alpha": 1.5}}}},
            "alpha is no key of the schema: the keys here are kind, strength, rate",
        ),
        (
            {"cases": {"toda": {"elastic": {"kind": "spring"}}}},
            "unknown: choose hertz or toda or fpu",
        ),
    ],
)
def test_impossible_configuration_is_refused(tmp_path, change, sentence):
    above = tmp_path / "above.yaml"
    above.write_text(yaml.safe_dump({"laws": {"jump_conditions": change}}))
    with pytest.raises(InputError, match=sentence):
        check_configuration(load_configuration(FILE, above))
