"""Physical scales: the equations of section 3.1, round trips."""

import math

import numpy as np
import pytest
from potentials import hertz

import granular_fronts as gf
from granular_fronts.model.collision import damping_for_restitution
from granular_fronts.model.scaling import (
    damping_from_restitution,
    sphere_mass,
    sphere_stiffness,
    velocity_of_compression,
    velocity_of_force,
)

STEEL = {"mass": 0.147, "stiffness": 1.4e10, "damping": 1.0e-6, "velocity": 0.5}
QUANTITIES = ["displacement", "velocity", "acceleration", "time", "force", "energy"]


def random_scalings(count):
    generator = np.random.default_rng(29)
    for mass, stiffness, damping, velocity in 10.0 ** generator.uniform(
        [-6.0, 2.0, -9.0, -3.0], [1.0, 11.0, -2.0, 2.0], (count, 4)
    ):
        alpha, beta = generator.uniform([0.3, 1.0], [4.0, 5.0])
        yield gf.Scaling(mass, stiffness, damping, velocity, alpha, beta)


def test_scales_are_those_of_equation_27():
    for scaling in random_scalings(50):
        a, ratio = scaling.alpha + 1.0, scaling.mass / scaling.stiffness
        length = ratio ** (1.0 / a) * scaling.velocity ** (2.0 / a)
        assert scaling.length == pytest.approx(length, rel=1e-14)
        assert scaling.force == pytest.approx(scaling.stiffness * length**scaling.alpha, rel=1e-12)
        assert scaling.to_physical(1.0, "force") == scaling.force
        assert scaling.front_speed * scaling.time == pytest.approx(math.copysign(1.0, a - 2.0))
        energy, acceleration = (scaling.to_physical(1.0, q) for q in ("energy", "acceleration"))
        assert energy == pytest.approx(scaling.force * length, rel=1e-14)
        assert acceleration == pytest.approx(scaling.force / scaling.mass, rel=1e-14)
        for quantity in QUANTITIES:
            there = scaling.to_physical(0.7, quantity)
            assert scaling.to_dimensionless(there, quantity) == pytest.approx(0.7, rel=2.3e-16)


def test_parameters_come_back_from_the_scales():
    """k, γ₀ and v_c follow from m, T₀, δ₀ and γ."""
    for scaling in random_scalings(50):
        a, b, m = scaling.alpha, scaling.beta, scaling.mass
        stiffness = m * scaling.length ** (1.0 - a) / scaling.time**2
        assert stiffness == pytest.approx(scaling.stiffness, rel=1e-12)
        # A force γ₀k d(u^β)/dt is γF₀ in the scales.
        damping = scaling.gamma * scaling.force * scaling.time / (stiffness * scaling.length**b)
        assert damping == pytest.approx(scaling.damping, rel=1e-12)
        moved = gf.Scaling(m, scaling.stiffness, scaling.damping, scaling.critical_velocity, a, b)
        # A small exponent in (29) makes v_c large or small, and multiplies its rounding.
        assert moved.gamma == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize("alpha", [1.5, 2.2])
def test_front_has_unit_scales(alpha):
    """With v₀ = v_p the scales are those of the front, eqs. (22), (23) and (30)."""
    m, k, delta, damping = 0.05, 2.0e9, 3.0e-6, 1.0e-6
    front = gf.jump_conditions(hertz(alpha, k), -delta, 0.0, mass=m)
    v_p = velocity_of_compression(delta, m, k, alpha)
    assert v_p == pytest.approx(front.velocity_behind, rel=1e-13)
    assert velocity_of_force(k * delta**alpha, m, k, alpha) == pytest.approx(v_p, rel=1e-13)
    scaling = gf.Scaling(m, k, damping, v_p, alpha)
    assert scaling.length == pytest.approx(delta, rel=1e-13)
    assert scaling.front_speed == pytest.approx(front.speed, rel=1e-13)
    assert scaling.gamma == pytest.approx(damping * front.speed, rel=1e-13)


@pytest.mark.parametrize(
    ("alpha", "beta", "where"),
    [
        (1.5, 2.5, "small velocities"),
        (1.5, 1.0, "large velocities"),
        (1.5, 1.25, "no velocity"),
    ],
)
def test_weak_damping_is_where_section_3_1_says(alpha, beta, where):
    slow, fast = (
        gf.Scaling(**STEEL | {"velocity": v}, alpha=alpha, beta=beta) for v in (1e-3, 1e3)
    )
    assert slow.weak_damping == where
    assert (slow.gamma < fast.gamma) == (where == "small velocities")
    assert (slow.gamma > fast.gamma) == (where == "large velocities")


@pytest.mark.parametrize("exponents", [(), (2.2,), (2.2, 1.3)])
def test_damping_follows_from_restitution(exponents):
    mass, stiffness = sphere_mass(0.0165, 7800.0), sphere_stiffness(0.0165, 2.0e11, 0.3)
    damping = damping_from_restitution(0.9, 0.5, mass, stiffness, *exponents)
    gamma = gf.Scaling(mass, stiffness, damping, 0.5, *exponents).gamma
    assert gamma == pytest.approx(damping_for_restitution(0.9, *exponents), rel=1e-14)
    assert gf.restitution(gamma, *exponents) == pytest.approx(0.9, rel=1e-12)
