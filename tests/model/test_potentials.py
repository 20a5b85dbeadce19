"""Potentials: derivatives against 40 digits, factors, and a user's potentials that are wrong."""

import sys

import mpmath as mp
import numpy as np
import pytest
from potentials import NO_DISSIPATION, READY, fpu, hertz, lennard_jones, toda

from granular_fronts.errors import InputError
from granular_fronts.model.passes import row_map
from granular_fronts.model.potentials import Potential, make_potential

DIGITS = 40


def functions_of(potential):
    return potential.value, potential.first, potential.second, potential.third


@pytest.mark.parametrize("case", READY)
def test_derivatives_agree_with_forty_digits(case):
    potential, exact = READY[case]
    points = np.array([-0.7, -0.1, -1.0e-3, 0.02, 0.5])
    with mp.workdps(DIGITS):
        for order, function in enumerate(functions_of(potential)):
            expected = [float(mp.diff(exact, mp.mpf(r), order)) for r in points]
            scale = np.abs(expected).max() + 1.0
            np.testing.assert_allclose(function(points), expected, rtol=2e-14, atol=2e-16 * scale)


@pytest.mark.parametrize("case", READY)
def test_ready_potentials_pass_the_check_of_the_users(case):
    """Where an interval is short, too."""
    potential, _ = READY[case]
    for interval in ((-0.9, -0.1), (-0.1 - 1.0e-3, -0.1), (-0.1 - 1.0e-8, -0.1)):
        assert Potential(*functions_of(potential), interval=interval).domain == interval


def test_stiffness_of_a_softening_contact_is_infinite_where_it_closes():
    softening = hertz(0.5)
    np.testing.assert_array_equal(softening.second(np.array([0.0, 1.0])), [np.inf, 0.0])
    assert softening.first(np.array([0.0]))[0] == 0.0


@pytest.fixture
def sympy():
    return pytest.importorskip("sympy", reason="SymPy comes with the optional extra symbolic")


def test_expression_is_differentiated(sympy):
    r, points = sympy.Symbol("r"), np.linspace(-1.5, 0.9, 7)
    contact = sympy.Max(-r, 0) ** sympy.Rational(5, 2) / sympy.Rational(5, 2)
    for expression, expected, kinks in (
        (sympy.exp(-r) + r - 1, toda(), ()),
        (contact, hertz(1.5), (0.0,)),
        (r**2 / 2, fpu(), ()),
    ):
        found = Potential.from_expression(expression, r, interval=(-2.0, 1.0), kinks=kinks)
        for mine, ready in zip(functions_of(found), functions_of(expected), strict=True):
            np.testing.assert_allclose(mine(points), ready(points), rtol=1e-14, atol=1e-15)
    modulus = Potential.from_expression(sympy.Abs(r) ** 3, r, interval=(-2.0, 2.0))
    np.testing.assert_array_equal(modulus.first([-1.0, 0.5]), [-3.0, 0.75])


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (lambda s, r: ("__import__('pathlib').Path('run').touch()", r), "must be an Expr: make"),
        (lambda s, r: (r**2 > 0, r), "expression is .* but must be an Expr"),
        (lambda s, r: (r**2, "r"), "symbol is 'r', but must be a Symbol"),
        (lambda s, r: (s.Symbol("k") * r**2, r), "depends on k besides r"),
        (lambda s, r: (s.DiracDelta(r), r), r"DiracDelta\(r\) or a derivative"),
        (lambda s, r: (s.zeta(r), r), r"zeta\(r\) or a derivative .* write it with Piecewise"),
    ],
)
def test_what_is_no_expression_is_refused_and_no_text_is_run(
    sympy, arguments, sentence, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=sentence):
        Potential.from_expression(*arguments(sympy, sympy.Symbol("r")), interval=(-1.0, 1.0))
    assert not list(tmp_path.iterdir())


def test_missing_sympy_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "sympy", None)
    with pytest.raises(ModuleNotFoundError, match=r"need SymPy: pip install .*\[symbolic\]"):
        Potential.from_expression(None, None, interval=(-1.0, 1.0))


def test_polynomial_of_numpy_makes_a_potential():
    """It has no hash of its own; numba does not compile it, and a sentence says so."""
    quartic = np.polynomial.Polynomial([0.0, 0.0, 0.5, 0.1, 0.2])
    found = Potential(
        quartic, quartic.deriv(), quartic.deriv(2), interval=(-1.0, 1.0), name="the quartic"
    )
    assert len({found, found.scaled(2.0)}) == 2
    np.testing.assert_array_equal(found.first([-0.5]), quartic.deriv()(np.array([-0.5])))
    with pytest.raises(InputError, match="V' of the quartic cannot be compiled for chains"):
        row_map(found, 1)


def make(interval=(-1.0, 1.0), **replaced):
    functions = {
        "value": lambda r: r**4 / 4.0,
        "first": lambda r: r**3,
        "second": lambda r: 3.0 * r**2,
        "third": lambda r: 6.0 * r,
    } | replaced
    return Potential(**functions, interval=interval, name="mine")


@pytest.mark.parametrize(
    ("replaced", "sentence"),
    [
        ({"value": lambda r: r**4 / 4.0 if r > 0 else 0.0}, "V of mine is not vectorised: given"),
        ({"second": lambda r: 3.0}, r"V'' of mine is not vectorised: .* shape \(\)"),
        ({"first": lambda r: np.where(r < 0.5, r**3, np.inf)}, "V' of mine is inf at r = 0.587"),
        ({"value": lambda r: np.log(r)}, "V of mine is nan at r = -0.9"),
        ({"first": lambda r: -(r**3)}, "V' of mine is .*, but the finite difference there is"),
        ({"third": lambda r: np.zeros_like(r)}, "V''' of mine is 0 at"),
        ({"value": lambda r: 1 / 0}, "V of mine .* fails with 'division by zero'"),
        ({"second": lambda r: 3.0 * r**2 + 1e-3j}, "V'' of mine has complex values"),
        ({"interval": (1.0, -1.0)}, "interval is .* must increase"),
    ],
)
def test_wrong_potential_is_named(replaced, sentence):
    with pytest.raises(ValueError, match=sentence):
        make(**replaced)


@pytest.mark.parametrize("case", READY)
def test_potential_is_described_as_it_is_made(case):
    potential, _ = READY[case]
    again = make_potential(**potential.describe())
    assert again == potential
    assert hash(again) == hash(potential)
    assert again != potential.scaled(2.0)


def test_potentials_know_their_ratio():
    assert toda(3.0, 2.0).ratio_to(toda(1.5, 2.0)) == 2.0
    assert toda(3.0, 2.0).ratio_to(toda(1.5, 1.0)) is None
    assert make_potential("power", beta=1.5, gamma=0.2).ratio_to(hertz(1.5, 0.4)) == 0.5
    assert NO_DISSIPATION.ratio_to(toda()) == 0.0
    mine = make()
    assert mine.scaled(0.3).ratio_to(mine) == 0.3
    assert make().ratio_to(mine) is None
    assert make() != mine


def test_lennard_jones_keeps_its_digits_at_rest_and_is_infinite_outside():
    potential, r = lennard_jones(), 1.0e-9
    with mp.workdps(DIGITS):
        exact = float(mp.diff(lambda x: ((1 + x) ** -6 - 1) ** 2, mp.mpf(r)))
    assert potential.first(r) == pytest.approx(exact, rel=1e-15)
    assert potential.domain == (-1.0, np.inf)
    assert lennard_jones(1.0, 2.0).domain == (-2.0, np.inf)
    np.testing.assert_array_equal(potential.value([-1.0, -2.0]), [np.inf, np.inf])


def test_kinks_are_declared():
    assert hertz(1.5).kinks == (0.0,)
    assert toda().kinks == ()
    assert make(kinks=[-0.5, 0.5]).kinks == (-0.5, 0.5)
    with pytest.raises(ValueError, match="kinks holds nan"):
        make(kinks=[np.nan])
