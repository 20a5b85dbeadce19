"""Tails of the exact fronts: roots, their number, critical damping; mpmath as the judge."""

import itertools
import math

import mpmath
import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.fronts.linear.critical_damping import meaning_changes_at

# Long waves, the change of meaning at 1.188, Hertz and steep; from weak to strong damping.
LAWS = list(itertools.product((1.001, 1.18, 1.5, 25.0, 50.0), (1e-3, 0.19, 3.0, 50.0)))
by_law = pytest.mark.parametrize(("alpha", "gamma"), LAWS)


def relation(x, alpha, gamma):
    return alpha * (1 - gamma * x) * (mpmath.sinh(x / 2) / (x / 2)) ** 2 - 1


def winding(alpha, gamma, right, top):
    """Roots of the relation in 0 < Re < right, |Im| < top, by the argument of its values."""
    path = np.array([complex(0, -top), complex(right, -top), complex(right, top), complex(0, top)])
    path = np.concatenate([path, [1e-12j, -1e-12j, path[0]]])
    while True:
        values = alpha * (1 - gamma * path) * (np.sinh(path / 2) / (path / 2)) ** 2 - 1
        turns = np.angle(values[1:] / values[:-1])
        # A turn is trusted if it is small over a short piece of the path.
        coarse = np.nonzero((np.abs(turns) > 0.3) | (np.abs(np.diff(path)) > 0.2))[0]
        if coarse.size == 0:
            return round(turns.sum() / (2.0 * math.pi))
        path = np.insert(path, coarse + 1, 0.5 * (path[coarse] + path[coarse + 1]))


@by_law
def test_roots_are_those_of_high_precision_however_many_are_sought(alpha, gamma):
    many = gf.tail_roots(alpha, gamma, count=60)
    for count in (1, 3, 13):
        np.testing.assert_array_equal(gf.tail_roots(alpha, gamma, count=count), many[:count])
    with mpmath.workdps(40):
        for root in many[:8]:
            exact = mpmath.findroot(
                lambda x: relation(x, mpmath.mpf(alpha), mpmath.mpf(gamma)), mpmath.mpc(root)
            )
            assert abs(exact - root) <= 1e-14 * abs(exact)
            assert abs(exact.real - root.real) <= 1e-14 * exact.real


@by_law
def test_no_root_is_missing(alpha, gamma):
    """The argument principle counts the listed roots, up to the real part of the last but one."""
    roots = gf.tail_roots(alpha, gamma, count=8)
    roots = roots[roots.real < 20.0]
    right = 0.5 * (roots[-2].real + roots[-1].real)
    inside = roots[roots.real < right]
    # Beyond this height all real parts exceed `right`; the path keeps clear of the zeros of sinh.
    bound = 4.0 * math.cosh(right / 2.0) ** 2 * alpha
    height = 2.0 * math.pi * math.ceil((bound * gamma + math.sqrt(bound)) / (2.0 * math.pi) + 0.1)
    expected = sum(1 if root.imag == 0.0 else 2 for root in inside)
    assert winding(alpha, gamma, right, height) == expected


def test_roots_and_critical_damping_depend_on_beta_gamma_over_alpha_only():
    np.testing.assert_allclose(
        gf.tail_roots(1.5, 0.4, beta=1.0), gf.tail_roots(1.5, 0.4 / 1.5), rtol=1e-13
    )
    for definition in ("tail", "double-root", "long-wave"):
        scaled = 1.1 * gf.critical_damping(1.1, definition=definition)
        found = gf.critical_damping(1.1, beta=1.0, definition=definition)
        assert found == pytest.approx(scaled, rel=1e-15)


def test_critical_damping_is_a_double_root_and_tends_to_the_long_wave_formula():
    ratios = []
    for alpha in (1.001, 1.05, 1.18):
        gamma = gf.critical_damping(alpha, definition="double-root")
        assert gf.critical_damping(alpha) == gamma
        with mpmath.workdps(40):
            a, start = mpmath.mpf(alpha), gf.tail_roots(alpha, gamma * (1 - 1e-7))[0].real
            _, exact = mpmath.findroot(
                lambda x, g, a=a: (
                    relation(x, a, g),
                    mpmath.diff(lambda z: relation(z, a, g), x),
                ),
                (start, gamma),
            )
            assert abs(gamma / exact - 1) <= 1e-14
        ratios.append(gamma / gf.critical_damping(alpha, definition="long-wave"))
    near = 1.0 + 2.0**-33
    exact = math.sqrt(2.0**-33 / near / 3.0)
    assert gf.critical_damping(near, definition="long-wave") == pytest.approx(exact, rel=1e-15)
    assert ratios[0] == pytest.approx(1.0, abs=1e-3)
    assert ratios == sorted(ratios, reverse=True)


@pytest.mark.parametrize("alpha", [1.1878, 1.2, 1.5, 2.0, 5.0, 10.0])
def test_critical_damping_is_a_crossing_of_real_parts(alpha):
    gamma = gf.critical_damping(alpha)
    pair, real = sorted(gf.tail_roots(alpha, gamma, count=2), key=lambda root: -root.imag)
    with mpmath.workdps(40):
        a = mpmath.mpf(alpha)

        def crossing(x, y, g):
            value = relation(mpmath.mpc(x, y), a, g)
            return relation(x, a, g), value.real, value.imag

        *_, exact = mpmath.findroot(crossing, (real.real, pair.imag, gamma))
        assert abs(gamma / exact - 1) <= 1e-14
    assert gf.tail_roots(alpha, 0.99 * gamma)[0].imag > 0.0
    assert gf.tail_roots(alpha, 1.01 * gamma)[0].imag == 0.0


def test_meanings_change_at_a_triple_root():
    with mpmath.workdps(40):

        def bell(x):
            return (x / 2 / mpmath.sinh(x / 2)) ** 2

        bend = mpmath.findroot(lambda x: mpmath.diff(bell, x, 2), 2.3)
        exact = bell(bend) - bend * mpmath.diff(bell, bend)
        assert abs(meaning_changes_at() / exact - 1) <= 1e-15
    below, above = (
        gf.critical_damping(meaning_changes_at() * factor) for factor in (1 - 1e-9, 1 + 1e-9)
    )
    assert above == pytest.approx(below, rel=1e-8)


def test_critical_damping_of_a_stiff_law_keeps_its_digits():
    """γ → α/π (β = α); what is left falls like 1/α down to the last digit."""
    for alpha in (1e3, 1e50):
        excess = math.pi * gf.critical_damping(alpha) / alpha - 1.0
        assert abs(excess + 0.5 / alpha) < 2.0 / alpha**2 + 1e-14


def test_roots_of_extreme_laws_are_found():
    """(α − 1)/(αg) in the limit of strong damping; a strip far up may hold no root."""
    root = gf.tail_roots(1.5, 1e12, count=1)[0]
    assert root.real == pytest.approx(0.5 / 1.5e12, rel=1e-9)
    roots = gf.tail_roots(23.369647796819336, 0.0011717651288848771, count=2)
    assert np.isfinite(roots).all()
    assert roots[0].real < roots[1].real
