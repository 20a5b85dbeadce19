"""Theorem D: the balance, its condition, and the multipliers that it speaks of, by other means."""

import numpy as np
import pytest
import scipy.linalg
from certificates import enclosed
from flint import arb

import granular_fronts as gf
from granular_fronts.fronts.linear.floquet import monodromy_matrix
from granular_fronts.fronts.shooting.solve import shoot_front
from granular_fronts.proofs.balls import in_balls
from granular_fronts.proofs.stability import _behind, stable
from projects import ROOT

ALPHA = 1.5


def stiffness(u):
    return ALPHA * u ** (ALPHA - 1)


# The balance.


def sums_ahead(f):
    return np.cumsum(f[::-1], axis=0)[::-1]


def falling(a):
    """q of fronts that fall."""
    return 0.5 / a


def growth(gamma, weight, beta=ALPHA):
    """The largest growth of Σ x² + 2 q j² in a bead-time, of kicks in the middle of a window."""
    front = shoot_front(ALPHA, gamma, beta)
    u, d = front.relative_displacement, front.strain_rate
    u, d = (np.pad(f, (40, 0), constant_values=end) for f, end in ((u, 1.0), (d, 0.0)))
    matrix = monodromy_matrix(u, d, ALPHA, gamma, beta)
    n = np.arange(u.size)
    kicked = n[40 : np.flatnonzero(u > 1e-2)[-1]]
    difference = np.eye(u.size) - np.eye(u.size, k=1)
    second = np.eye(u.size, k=1) - 2 * np.eye(u.size) + np.eye(u.size, k=-1)
    kicks = np.zeros((u.size, 2, 2, u.size))
    kicks[:, 0, 0], kicks[:, 1, 1] = difference, second
    kicks = kicks.reshape(2 * u.size, 2, u.size)[:, :, kicked].reshape(2 * u.size, -1)
    w, d = (matrix @ kicks).reshape(u.size, 2, -1).transpose(1, 0, 2)
    x, j = sums_ahead(w), sums_ahead(sums_ahead(d))[1:]
    scale = np.sqrt(2 * weight(stiffness(np.maximum(u, 1e-12))))
    moved = np.concatenate([x, scale[:-1, None] * j])
    return scipy.linalg.svdvals(moved / np.concatenate([np.ones(kicked.size), scale[kicked]]))[0]


@pytest.mark.parametrize(("gamma", "beta"), [(0.3, ALPHA), (1.0, 1.0)])
def test_computed_monodromy_lets_no_kick_grow(gamma, beta):
    """In the norm of Lemma 28, for which the window is nothing but long."""
    assert 0.99 < growth(gamma, falling, beta) < 1.0


@pytest.mark.parametrize(("gamma", "weight"), [(0.05, falling), (0.3, lambda a: 2.0 / a)])
def test_kicks_grow_in_a_norm_without_the_condition(gamma, weight):
    assert growth(gamma, weight) > 1.002


def test_computed_multipliers_are_those_of_the_page():
    """Inside the unit circle, as Theorem D says of the infinite chain."""
    page = (ROOT / "docs/proofs.md").read_text(encoding="utf-8")
    for beads in (40, 160):
        found = gf.front_multipliers(gf.solve_front(ALPHA, 0.3), beads_behind=beads)
        radius = found.attrs["spectral_radius_without_translation"]
        assert radius < 1.0
        assert f"{radius:.4f}" in page


# The condition.


def said(front):
    with in_balls():
        return list(stable(front))


@pytest.mark.parametrize("name", ["monotone", "dashpots"])
def test_nothing_is_said_of_what_is_not_shown(name):
    """No enclosure, no inverse, a dip behind, a front that rises, no damping, no fall."""
    front = enclosed(name)
    [statement] = said(front)
    assert "spectrally stable" in statement
    assert front.numbers == {"stable": 1.0}
    with in_balls():
        dip = [f - (arb("0.9") if 20 < j < 100 else 0) for j, f in enumerate(front.u)]
        lies = (
            {"r": arb(1)},
            {"rear_norms": (arb(1), arb(20), arb(1))},
            {"rear_norms": (arb(1), arb("1e9"), arb("0.9"))},
            {"u": dip},
            {"u": front.u[::-1]},
            {"gamma": arb("1e-6")},
            {"fall": front.fall + 100},
        )
    for lie in lies:
        assert said(enclosed(name, **lie)) == []


def test_strain_behind_the_cells_is_halved_as_stated():
    """Lemma 31, for a front computed to the last digit; q begins above 1/(2α)."""
    monotone = enclosed("monotone")
    distance = monotone.p + 1  # the least that the lemma gives
    front = gf.solve_front(ALPHA, 0.3)
    far, near = (abs(gf.evaluate_front(front, x) - 1) for x in (-6.0 - distance, -6.0))
    assert far < near / 2
    with in_balls():
        q = _behind(monotone)
        assert q > 1 / (2 * monotone.alpha)
        assert q < 1 / (2 * monotone.alpha) + monotone.outer_kappa[0] * monotone.r
