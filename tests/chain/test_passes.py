"""Row maps: the numbers of the potentials themselves, in vector code, cached, for any function."""

import math

import numpy as np
import pytest
from kernels import call_map, fastest, mapped
from potentials import cosh, hertz, toda

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.model.kinds import KINDS
from granular_fronts.model.passes import NEGLIGIBLE, row_map, row_parameters
from granular_fronts.model.potentials import make_potential

EPSILON = float(np.finfo(float).eps)
PARAMETERS = {
    "hertz": {"alpha": 1.5, "stiffness": 1.7},
    "power": {"beta": 1.3, "gamma": 0.4},
    "linear": {"gamma": 0.3},
    "toda": {"strength": 0.7, "rate": 1.3},
    "fpu": {"quadratic": 0.5, "cubic": -0.2, "quartic": 0.1},
    "morse": {"depth": 2.0, "rate": 0.8},
    "lennard_jones": {"depth": 0.5, "distance": 3.0},
}
FASTEST_SCALAR_CODE = 4.0
"""Over the time of a square root by numpy; the maps take 0.2 to 3 times as long in vector code."""


@pytest.mark.parametrize("kind", KINDS)
def test_row_maps_are_the_derivatives(kind):
    """The j-th derivative of V(−u) with respect to u, to a few units of the last place.

    That of Lennard-Jones is infinite from u = 3 on.
    """
    potential = make_potential(kind, **PARAMETERS[kind])
    u = np.append(np.linspace(-0.5, 2.0, 999), [3.0, 4.0][: 2 * (kind == "lennard_jones")])
    for order in range(4):
        expected = (-1.0) ** order * potential.derivative(-u, order)
        scale = np.abs(expected).max(where=np.isfinite(expected), initial=0.0)
        found = mapped(potential, order, u)
        np.testing.assert_allclose(found, expected, rtol=8 * EPSILON, atol=2 * EPSILON * scale)


@pytest.mark.parametrize("alpha", [0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 7.3])
def test_every_exponent_gives_its_power(alpha):
    """With a special form or without; a gap gives nothing, nor does a negligible compression."""
    u = np.concatenate([[-1.0, 0.0, 0.5 * NEGLIGIBLE], np.geomspace(1e-12, 1e3, 200)])
    force = mapped(hertz(alpha, 0.3), 1, u)
    np.testing.assert_allclose(force[3:], 0.3 * u[3:] ** alpha, rtol=4 * EPSILON)
    np.testing.assert_array_equal(force[:3], 0.0)


def test_only_the_contacts_asked_for_are_written():
    u, result = np.linspace(0.0, 1.0, 9), np.full(9, np.nan)
    law = toda()
    for last in (6, 1):
        call_map(row_map(law, 1), u, result, 2, last, row_parameters(law, 1), 1)
        np.testing.assert_array_equal(np.flatnonzero(~np.isnan(result)), range(2, 7))


# It measures processor time, and wants the machine for itself.
@pytest.mark.nightly
@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("kind", KINDS)
def test_row_maps_are_vector_code(kind, order):
    """Scalar code, with its calls of pow and exp, would take 10 to 50 times as long."""
    potential = make_potential(kind, **PARAMETERS[kind])
    u, result, repeats = np.linspace(0.1, 1.2, 4000), np.empty(4000), 50
    arguments = row_map(potential, order), u, result, 0, u.size - 1
    parameters = row_parameters(potential, order)
    call_map(*arguments, parameters, 1)
    mapping = fastest(lambda: call_map(*arguments, parameters, repeats))
    root = fastest(lambda: [np.sqrt(u, out=result) for _ in range(repeats)])
    assert mapping < FASTEST_SCALAR_CODE * root


def by_sympy():
    sympy = pytest.importorskip("sympy", reason="SymPy comes with the optional extra symbolic")
    r = sympy.Symbol("r")
    pieces = sympy.Piecewise((sympy.cosh(r) - 1, r < 0), (0, True))
    return gf.Potential.from_expression(pieces, r, interval=(-3, 3), kinks=[0.0])


@pytest.mark.parametrize("make", [cosh, by_sympy])
def test_a_users_functions_are_compiled_and_give_no_number_outside_their_interval(make):
    potential, u = make().scaled(0.7), np.linspace(-2.0, 2.0, 101)
    for order in (1, 2):
        expected = (-1.0) ** order * potential.derivative(-u, order)
        found = mapped(potential, order, np.append(u, [-3.5, -2.5, 2.5, 3.5]))
        np.testing.assert_allclose(found[:101], expected, rtol=8 * EPSILON, atol=1e-15)
        np.testing.assert_array_equal(np.isnan(found[101:]), [True, False, False, True])


def test_a_constant_that_changes_after_compilation_is_noticed():
    """Where it matters between two kinks alone, too."""
    depth = 1.0

    def force(r):
        return r + np.where((r > 0.0) & (r < 1e-3), depth * r * (1e-3 - r), 0.0)

    def slope(r):
        return 1.0 + np.where((r > 0.0) & (r < 1e-3), depth * (1e-3 - 2.0 * r), 0.0)

    def value(r):
        x = np.minimum(np.maximum(r, 0.0), 1e-3)
        return 0.5 * r * r + depth * (5e-4 * x * x - x * x * x / 3.0)

    kinks = {"interval": (-1, 1), "kinks": (0.0, 1e-3), "name": "a spring"}
    potential = gf.Potential(value, force, slope, **kinks)
    address = row_map(potential, 1)
    assert row_map(potential.scaled(0.5), 1) == address
    depth = 2.0
    with pytest.raises(InputError, match=r"of a spring is .* but .* in compiled code"):
        row_map(potential, 1)
    depth = 1.0
    assert row_map(potential, 1) == address


def test_a_function_that_compiles_to_other_numbers_or_not_at_all_is_named():
    """Integers of Python have no limit, those of compiled code have 64 bits."""
    digits, own = 20, np.vectorize(lambda r: math.exp(r))
    other = gf.Potential(
        np.cosh, np.sinh, lambda r: np.cosh(r) * (1e-20 * 10**digits), interval=(-1, 1)
    )
    unknown = gf.Potential(own, own, np.exp, interval=(-1, 1), name="mine")
    assert row_map(other, 1)
    with pytest.raises(InputError, match=r"V'' of the potential is .* in compiled code"):
        row_map(other, 2)
    with pytest.raises(InputError, match="V' of mine cannot be compiled for chains"):
        row_map(unknown, 1)
