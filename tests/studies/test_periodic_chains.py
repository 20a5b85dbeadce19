"""Pulses in cells of spheres: the theory of dimers against dispersion, limits and chains."""

import doctest
import math

import numpy as np
import pytest

from granular_fronts.model.materials import body_of
from granular_fronts.studies import periodic_chains
from granular_fronts.studies.periodic_chains import (
    _pulse,
    number,
    speed_of_pulse,
    stretch_of_dimer,
    stretch_over_theory,
    strike_dimers,
    strike_spheres,
)

TOLERANCE = {"relative": 1e-9, "absolute": 1e-11}


@pytest.mark.parametrize("ratio", [0.05, 0.3428, 0.8])
def test_the_stretch_is_that_of_the_dispersion_of_a_linear_dimer(ratio):
    """An independent way to the coefficient: the acoustic branch of the diatomic chain, α = 1."""
    q, sum_, product = 1e-2, 1.0 + 1.0 / ratio, 1.0 / ratio
    square = sum_ - math.sqrt(sum_**2 - 4.0 * product * math.sin(q) ** 2)
    # ω² = q²(1 − b² q²)/m̄ with b² = (1 + 3θ²)/12, q per bead.
    coefficient = (1.0 - square * 0.5 * (1.0 + ratio) / q**2) / q**2
    assert 12.0 * coefficient == pytest.approx(stretch_of_dimer(1.0, ratio) ** 2, rel=1e-3)
    found = doctest.testmod(periodic_chains)
    assert found.failed == 0 < found.attempted


def test_a_cell_of_a_massless_sphere_is_one_sphere_with_contacts_in_series():
    """Two contacts of stiffness k in series have k 2^(−3/2); a cell has two beads."""
    cell = speed_of_pulse([1.0], [2.0**-1.5], 1.0)
    assert speed_of_pulse([1.0, 0.0], [1.0, 1.0], 1.0) == pytest.approx(2.0 * cell, rel=1e-14)
    assert speed_of_pulse([1.0], [1.0], 64.0) == pytest.approx(
        2.0 * speed_of_pulse([1.0], [1.0], 1)
    )


def test_a_pulse_of_known_shape_is_read():
    times = np.linspace(0.0, 20.0, 2001)
    turn, largest, width = _pulse(times, 3.0 / np.cosh(times - 8.003) ** 2)
    assert (turn, largest) == pytest.approx((8.003, 3.0), rel=1e-7)
    # ∫ sech² from −∞ to where it is 0.01 of its largest value.
    assert width == pytest.approx(1.0 + math.sqrt(0.99), rel=1e-6)


@pytest.mark.slow
def test_dimers_approach_the_theory_at_both_ends_and_nowhere_else():
    found = strike_dimers([0.02, 0.04, 0.3428, 0.95, 1.0], 120, TOLERANCE)
    near, twice, between, alike, equal = (
        stretch_over_theory(found, ratio=ratio).value - 1.0 for ratio in found["ratio"].values
    )
    assert twice / near == pytest.approx(2.0, rel=0.1)
    assert between > 0.2
    assert 0.0 < alike < 0.02
    assert equal == pytest.approx(0.0, abs=1e-5)
    assert abs(found["speed"].values - 1.0).max() < 0.01
    assert number(found, "speed", ratio=1.0).value == pytest.approx(1.0, abs=1e-6)


@pytest.mark.slow
def test_speeds_of_equal_spheres_are_those_of_their_material():
    """In SI units, and a dimer of one material and one size is no dimer."""
    words = "glass 8 mm"
    found = strike_spheres({"one": [words], "two": [words, words]}, 80, TOLERANCE)
    body = body_of(words)
    stiffness = 2.0 / 3.0 * 70.0e9 / (1.0 - 0.22**2) * math.sqrt(0.5 * body.radius)
    unit = 2.0 * body.radius * stiffness ** (1.0 / 3.0) / math.sqrt(body.mass)
    expected = unit * 1.4873593743**-0.25 * 10.0 ** (1.0 / 6.0)
    assert found["speed_at_10_newtons"].values == pytest.approx([expected, expected], rel=1e-5)
