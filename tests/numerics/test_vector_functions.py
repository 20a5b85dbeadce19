"""Power and exponential of the kernels, against many digits."""

import mpmath
import numpy as np
import pytest
from kernels import mapped
from potentials import hertz

from granular_fronts.model.passes import NEGLIGIBLE
from granular_fronts.numerics.vector_functions import (
    exponential,
    exponential_less_one,
    logarithm,
    power,
)

DIGITS = 50
RANGES = [(1.0e-3, 10.0), (0.99, 1.01), (NEGLIGIBLE, 1.0e-3), (10.0, 1.0e20)]


def compiled_powers(x, exponent):
    """The force of a Hertz potential."""
    return mapped(hertz(exponent), 1, x)


def units_of_last_place(computed, wanted):
    """Error of a computed number."""
    return abs(float((mpmath.mpf(float(computed)) - wanted) / np.spacing(abs(float(wanted)))))


@pytest.mark.parametrize("exponent", [1.0 / 3.0, 1.0, 1.01, 1.5, 2.5, 5.0])
@pytest.mark.parametrize(("smallest", "largest"), RANGES)
def test_power_is_right_to_the_last_places(exponent, smallest, largest):
    draw = np.random.default_rng(0).uniform(np.log(smallest), np.log(largest), 500)
    x = np.maximum(np.exp(draw), np.nextafter(smallest, np.inf))
    with mpmath.workdps(DIGITS):
        for value, computed in zip(x, compiled_powers(x, exponent), strict=True):
            wanted = mpmath.mpf(float(value)) ** mpmath.mpf(exponent)
            assert units_of_last_place(computed, wanted) < 1.5


@pytest.mark.parametrize("exponent", [1.2, 1.5, 3.0])
def test_open_and_negligible_contacts_exert_no_force(exponent):
    x = np.array([-1.0, -NEGLIGIBLE, -0.0, 0.0, 1.0e-310, NEGLIGIBLE, np.nan])
    np.testing.assert_array_equal(compiled_powers(x, exponent), 0.0)


@pytest.mark.parametrize("exponent", [1.2, 3.0])
def test_power_rises_across_the_edges_of_the_reduction(exponent):
    """Where the power of two split off x, or off the result, changes."""
    edges = [2.0**k * root for k in range(-6, 7) for root in (1.0, 0.5**0.5)]
    edges += [2.0 ** ((k + 0.5) / exponent) for k in range(-6, 7)]
    for edge in edges:
        around = edge * (1.0 + 1.0e-15 * np.arange(-20, 21))
        relative = compiled_powers(around, exponent) / around**exponent - 1.0
        assert np.abs(relative).max() < 4.0e-16


@pytest.mark.parametrize(
    ("least", "largest"),
    [(-40, 40), (-1e-3, 1e-3), (-1e-12, 1e-12), (-1e-300, 1e-300), (-700, 700)],
)
@pytest.mark.parametrize(
    ("computed", "exact"), [(exponential, mpmath.exp), (exponential_less_one, mpmath.expm1)]
)
def test_exponential_is_right_to_the_last_places(computed, exact, least, largest):
    with mpmath.workdps(DIGITS):
        for x in np.random.default_rng(1).uniform(least, largest, 500):
            assert units_of_last_place(computed(x), exact(mpmath.mpf(x))) < 2.0


def test_logarithm_is_that_of_the_library():
    x = np.concatenate([np.geomspace(3e-308, 1e300, 4001), np.linspace(0.7, 1.42, 4001)])
    result = np.array([logarithm(number) for number in x])
    exact = np.log(x)
    assert np.all(np.abs(result - exact) <= np.spacing(np.abs(exact)) + 1e-320)


def test_powers_and_exponentials_that_no_double_holds():
    assert power(1.0e200, 2.5) == np.inf
    assert power(1.0e100, 2.5) == pytest.approx(1.0e250, rel=1.0e-15)
    assert (exponential(800.0), exponential_less_one(800.0)) == (np.inf, np.inf)
    assert exponential(-1e10) == pytest.approx(0.0, abs=1e-100)
    assert exponential_less_one(-1e10) == -1.0
    assert exponential_less_one(0.0) == 0.0
    assert np.isnan([exponential(np.nan), exponential_less_one(np.nan)]).all()
