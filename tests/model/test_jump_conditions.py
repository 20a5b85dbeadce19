"""Jump conditions against closed forms, 60 digits, an exact front's balance, and the theorems."""

import math

import mpmath as mp
import numpy as np
import pytest
from potentials import READY, hertz, morse, toda

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.model.jump_conditions import jump_conditions, signed_area

DIGITS = 60
DASHPOT = {"kind": "linear", "gamma": 0.3}


@pytest.mark.parametrize("alpha", [0.1, 0.9, 1.5, 3.0])
def test_hertz_gives_equations_21_to_23(alpha):
    k, m, delta = 1.4e10, 0.08, 2.0e-6
    front = jump_conditions(hertz(alpha, k), -delta, 0.0, mass=m)
    sign = 1 if alpha > 1 else -1
    speed = sign * math.sqrt(k / m) * delta ** ((alpha - 1) / 2)
    particle = sign * math.sqrt(k / m) * delta ** ((alpha + 1) / 2)
    from_particle = (k / m) ** (1 / (alpha + 1)) * abs(particle) ** ((alpha - 1) / (alpha + 1))
    assert front.direction == sign
    assert front.speed == pytest.approx(speed, rel=1e-15)
    assert front.velocity_minus == pytest.approx(particle, rel=1e-15)
    assert front.speed == pytest.approx(sign * from_particle, rel=1e-14)
    assert front.velocity_jump == pytest.approx(-particle, rel=1e-15)
    lost = k * delta ** (alpha + 1) * abs(alpha - 1) / (2 * (alpha + 1))
    # Rounding of the exponent, times ln δ, limits what the closed formula is worth.
    assert front.energy_per_bead == pytest.approx(lost, rel=1e-13)
    assert front.energy_error < 1e-13 * lost
    assert front.dissipated_power == pytest.approx(abs(speed) * lost, rel=1e-13)
    behind = front.velocity_minus if alpha > 1 else 0.0
    assert front.velocity_behind == behind
    assert front.velocity_ahead == front.velocity_minus + front.velocity_plus - behind


@pytest.mark.parametrize("case", ["hertz 3/2", "toda", "morse", "lennard-jones"])
@pytest.mark.parametrize(
    ("ahead", "jump"), [(-0.1, 1e-3), (0.0, 1e-6), (0.0, 0.05), (-1e-3, 1e-12)]
)
def test_close_states_keep_their_digits(case, ahead, jump):
    potential, energy = READY[case]
    behind = ahead - jump
    front = jump_conditions(potential, behind, ahead)
    with mp.workdps(DIGITS):
        states = mp.mpf(behind), mp.mpf(ahead)
        difference = states[1] - states[0]
        forces = [mp.diff(energy, r) for r in states]
        speed = mp.sqrt((forces[1] - forces[0]) / difference)
        lost = energy(states[1]) - energy(states[0]) - difference * sum(forces) / 2
        assert abs(front.speed - speed) <= front.speed_error < 2e-15 * speed
        assert abs(front.energy_per_bead - lost) <= front.energy_error < 1e-14 * lost
    assert front.sound_plus <= front.speed <= front.sound_minus


def test_random_states_obey_the_theorems():
    """Eqs. (12)–(17), Remark 1 and what follows (20), for a potential with V''' of one sign."""
    generator = np.random.default_rng(20210301)
    for rate, strength, R_minus, R_plus, m in generator.uniform(
        [0.2, 0.2, -2.0, -2.0, 0.2], [2.0, 2.0, 1.0, 1.0, 2.0], (200, 5)
    ):
        potential = toda(strength, rate)
        front = jump_conditions(potential, R_minus, R_plus, mass=m)
        force = potential.first(np.array([R_minus, R_plus]))
        assert m * front.speed**2 * (R_plus - R_minus) == pytest.approx(force[1] - force[0], 1e-11)
        assert front.direction == math.copysign(1, R_plus - R_minus)
        slow, fast = sorted([front.sound_minus, front.sound_plus])
        assert slow < abs(front.speed) < fast
        from_fast_side = front.sound_minus > front.sound_plus
        assert from_fast_side == (front.direction > 0)
        mirrored = jump_conditions(potential, R_plus, R_minus, mass=m)
        assert mirrored.speed == pytest.approx(-front.speed, rel=1e-14)
        assert mirrored.energy_per_bead == pytest.approx(front.energy_per_bead, rel=1e-13)


def test_a_law_that_holds_in_an_interval_is_asked_within_it():
    within = gf.Potential(
        np.square, lambda r: 2.0 * r, lambda r: 2.0 + 0.0 * r, interval=(-0.5, 0.5), name="W"
    )
    law = gf.make_law(elastic={"kind": "toda"}, viscous=within)
    assert gf.jump_conditions(law, -0.4, 0.0).direction == 1
    with pytest.raises(InputError, match="W is defined from"):
        gf.solve_front(law=law, states=(-1.0, 0.0))


def test_kink_in_the_middle_is_not_overlooked_and_spinodal_states_have_no_sound():
    """V'' of a linear contact jumps at r = 0, where V''' = 0 on both sides says nothing."""
    assert math.isnan(jump_conditions(morse(), 2.0, 0.0).sound_minus)
    contact = hertz(1.0)
    assert signed_area(contact, -1.0, 1.0).value == pytest.approx(0.5, rel=1e-14)
    front = jump_conditions(contact, -1.0, 1.0)
    assert front.speed == pytest.approx(math.sqrt(0.5), rel=1e-15)


def test_neither_the_third_derivative_nor_the_dissipation_decides():
    exact = toda()
    bare = gf.Potential(exact.value, exact.first, exact.second, interval=(-2.0, 1.0))
    front, without = (jump_conditions(potential, -1.0, 0.0) for potential in (exact, bare))
    assert without.speed == front.speed
    assert without.energy_per_bead == pytest.approx(front.energy_per_bead, rel=1e-14)
    for beta in (1.0, 1.5, 2.5):
        assert jump_conditions(exact, -1.0, 0.0, dissipation=hertz(beta, 0.3)) == front


@pytest.mark.parametrize(
    "law", [{"alpha": 1.5, "gamma": 0.3}, {"elastic": {"kind": "toda"}, "viscous": DASHPOT}]
)
def test_a_law_has_the_conditions_of_its_potentials(law):
    made = gf.make_law(law)
    front = gf.jump_conditions(made.elastic, -0.5, 0.0, dissipation=made.viscous)
    assert gf.jump_conditions(made, -0.5, 0.0) == gf.jump_conditions(law, -0.5, 0.0) == front
