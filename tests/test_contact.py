"""Potentials: their derivatives against 40 digits, and the user's potentials that are refused."""

import mpmath as mp
import numpy as np
import pytest

from granular_fronts.model.potentials import (
    NO_DISSIPATION,
    fpu,
    generalised_hertz,
    lennard_jones,
    morse,
    potential_from_expression,
    potential_from_functions,
    toda,
)

DIGITS = 40
READY = {
    "hertz 3/2": (generalised_hertz(1.5, 2.0), lambda r: 2 * (-r) ** 2.5 / 2.5 if r < 0 else 0),
    "hertz 1/2": (generalised_hertz(0.5), lambda r: (-r) ** 1.5 / 1.5 if r < 0 else 0),
    "hertz 1": (generalised_hertz(1.0), lambda r: r**2 / 2 if r < 0 else 0),
    "fpu": (fpu(0.5, -2.0, 3.0), lambda r: r**2 / 4 - 2 * r**3 / 3 + 3 * r**4 / 4),
    "toda": (toda(2.0, 3.0), lambda r: mp.mpf(2) / 3 * (mp.exp(-3 * r) + 3 * r - 1)),
    "morse": (morse(2.0, 1.5), lambda r: 2 * (1 - mp.exp(-1.5 * r)) ** 2),
    "lennard-jones": (
        lennard_jones(0.5, 2.0),
        lambda r: mp.mpf(0.5) * ((1 + r / 2) ** -12 - 2 * (1 + r / 2) ** -6 + 1),
    ),
}


@pytest.mark.parametrize("case", READY)
def test_derivatives_agree_with_forty_digits(case):
    potential, exact = READY[case]
    points = np.array([-0.7, -0.1, -1.0e-3, 0.02, 0.5])
    functions = (potential.value, potential.first, potential.second, potential.third)
    with mp.workdps(DIGITS):
        for order, function in enumerate(functions):
            expected = [float(mp.diff(exact, mp.mpf(r), order)) for r in points]
            scale = np.abs(expected).max() + 1.0
            np.testing.assert_allclose(function(points), expected, rtol=2e-14, atol=2e-16 * scale)


@pytest.mark.parametrize("case", READY)
def test_ready_potentials_pass_the_check_of_the_users(case):
    potential, _ = READY[case]
    checked = potential_from_functions(*potential[1:5], interval=(-0.9, -0.1))
    assert checked.domain == (-0.9, -0.1)


def test_stiffness_of_a_softening_contact_is_infinite_where_it_closes():
    softening = generalised_hertz(0.5)
    np.testing.assert_array_equal(softening.second(np.array([0.0, 1.0])), [np.inf, 0.0])
    assert softening.first(np.array([0.0]))[0] == 0.0


def test_conservative_chain_has_no_dissipation():
    assert not NO_DISSIPATION.second(np.linspace(-1.0, 1.0, 5)).any()


def test_expression_is_differentiated():
    sympy = pytest.importorskip("sympy", reason="SymPy comes with the optional extra symbolic")
    r = sympy.Symbol("r")
    expected = toda()
    found = potential_from_expression(sympy.exp(-r) + r - 1, r, interval=(-2.0, 1.0))
    points = np.linspace(-1.5, 0.9, 7)
    for name in ("value", "first", "second", "third"):
        np.testing.assert_allclose(
            getattr(found, name)(points), getattr(expected, name)(points), rtol=1e-14, atol=1e-15
        )
    harmonic = potential_from_expression(r**2 / 2, r, interval=(-1.0, 1.0))
    np.testing.assert_array_equal(harmonic.second(points), np.ones(7))
    with pytest.raises(ValueError, match=r"depends on k besides r"):
        potential_from_expression(sympy.Symbol("k") * r**2, r, interval=(-1.0, 1.0))


def make(interval=(-1.0, 1.0), **replaced):
    functions = {
        "value": lambda r: r**4 / 4.0,
        "first": lambda r: r**3,
        "second": lambda r: 3.0 * r**2,
        "third": lambda r: 6.0 * r,
    } | replaced
    return potential_from_functions(**functions, interval=interval, name="mine")


@pytest.mark.parametrize(
    ("replaced", "sentence"),
    [
        ({"value": lambda r: r**4 / 4.0 if r > 0 else 0.0}, "V of mine is not vectorised: given"),
        ({"second": lambda r: 3.0}, r"V'' of mine is not vectorised: .* shape \(\)"),
        ({"first": lambda r: np.where(r < 0.5, r**3, np.inf)}, "V' of mine is inf at r = 0.587"),
        ({"value": lambda r: np.log(r)}, "V of mine is nan at r = -0.9"),
        ({"first": lambda r: -(r**3)}, "V' of mine is .*, but the finite difference there is"),
        ({"second": lambda r: 3.000_02 * r**2}, "V'' of mine is .*, but the finite difference"),
        ({"third": lambda r: np.zeros_like(r)}, "V''' of mine is 0 at"),
        ({"interval": (1.0, -1.0)}, "interval is .* must grow"),
    ],
)
def test_wrong_potential_is_named(replaced, sentence):
    with pytest.raises(ValueError, match=sentence):
        make(**replaced)


def test_right_potential_passes_without_its_third_derivative():
    assert make(third=None).third is None


@pytest.mark.parametrize("width", [1.0e-3, 1.0e-6])
def test_short_interval_does_not_raise_a_false_alarm(width):
    exact = toda()
    potential_from_functions(*exact[1:5], interval=(-0.1 - width, -0.1))


@pytest.mark.parametrize(
    ("make_it", "sentence"),
    [
        (lambda: generalised_hertz(0.0), "alpha is 0.0, but must be a finite number, above 0"),
        (lambda: generalised_hertz(1.5, -1.0), "stiffness is -1.0"),
        (lambda: toda(rate=0.0), "rate is 0.0"),
        (lambda: morse(depth=np.nan), "depth is nan"),
        (lambda: lennard_jones(distance=np.inf), "distance is inf"),
    ],
)
def test_impossible_parameters_are_refused(make_it, sentence):
    with pytest.raises(ValueError, match=sentence):
        make_it()
