"""Make the certificate of a front with linear dashpots: trusted for nothing."""

import numpy as np
from scipy.optimize import brentq

from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solve import evaluate_front
from granular_fronts.proofs import right_inverse
from granular_fronts.proofs.balls import MATRIX_UNIT
from granular_fronts.proofs.dashpots.existence import approximate_strain
from granular_fronts.proofs.dashpots.right_inverse import ahead_inverse, window_correction
from granular_fronts.proofs.stored import (
    beads,
    differences,
    fractions,
    integers,
    kernels,
    require_size,
)

LOST, NEAR_ONE, SMALL_STRAIN, SMALL_STIFFNESS = 1e-4, 1e-11, 1e-11, 2e-3
WIDEST_RATES = 0.2


def describe(front, alpha, interval, n, fine, drift):
    """The fields of the certificate of a computed front."""
    exponent, gamma = front.attrs["alpha"], front.attrs["gamma"]
    xi, u = front["xi"].values, np.maximum(front["relative_displacement"].values, 0.0)
    behind, ahead = beads(-xi[abs(u - 1) > NEAR_ONE][0]), beads(xi[u > SMALL_STRAIN][-1])
    c = beads(-xi[abs(u ** (exponent - 1) - 1) > drift][0])
    g, p, q = right_inverse.rear_inverse(exponent, gamma / exponent, 0.0, n * fine, LOST)
    g_ahead, p_ahead, q_ahead = ahead_inverse(gamma, n * fine, LOST)
    M = beads(xi[u ** (exponent - 1) > SMALL_STIFFNESS][-1]) + p_ahead

    rear = min(tail_roots(exponent, gamma, beta=1.0).real)
    longer = beads(6.5 / rear)
    first = -(c + q + 1) - longer
    require_size((M - first) * n)
    middles = (np.arange((M - first) * n) + 0.5) / n + first
    strain = np.maximum(evaluate_front(front, middles), 0.0)
    stiffness = exponent * strain ** (exponent - 1)
    correction = window_correction(stiffness, gamma, n, -first * n, longer * n)
    return {
        "alpha": fractions(alpha),
        "gamma": fractions(interval),
        "sizes": integers(behind, ahead, n, fine, p, q, c, M, p_ahead, q_ahead),
        "strain": approximate_strain(front, behind, ahead, n),
        "inverse_behind": kernels(g),
        "inverse_ahead": kernels(g_ahead),
        "correction": differences(correction, MATRIX_UNIT, np.int16),
        "weights": np.round([0.9 * rear, *_rates_ahead(exponent, gamma)], 4),
    }


def _rates_ahead(alpha, gamma):
    """ν₁ below and ν₂ above the rate μ of the tail ahead, ν₂ < α ν₁."""
    mu = brentq(lambda rate: 2 * gamma * (np.cosh(rate) - 1) - rate, 1e-9, 700.0)
    apart = min(WIDEST_RATES, (alpha - 1) / (2 * alpha))
    return (1 - apart) * mu, (1 + apart) * mu
