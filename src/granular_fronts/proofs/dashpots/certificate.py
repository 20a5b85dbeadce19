"""Make the certificate of a front with linear dashpots: trusted for nothing."""

import numpy as np

from granular_fronts.fronts.linear.tails import rate_of_tail_ahead, tail_roots
from granular_fronts.proofs import right_inverse, stored
from granular_fronts.proofs.dashpots.existence import approximate_strain
from granular_fronts.proofs.dashpots.right_inverse import ahead_inverse, window_correction

SMALL_STRAIN = 1e-11  # ū is 0 ahead of the last place where u is larger
SMALL_STIFFNESS = 2e-3  # the inverse ahead begins where a(u)/α is smaller
WIDEST_RATES = 0.2  # largest distance of ν₁ and ν₂ from μ, in units of μ


def describe(front, alpha, interval, n, fine, drift):
    """Return the fields of the certificate of a computed front."""
    exponent, gamma = front.attrs["alpha"], front.attrs["gamma"]
    xi, u = front["xi"].values, np.maximum(front["relative_displacement"].values, 0.0)
    behind = stored.beads(-xi[abs(u - 1) > stored.NEAR_ONE][0])
    ahead = stored.beads(xi[u > SMALL_STRAIN][-1])
    c = stored.beads(-xi[abs(u ** (exponent - 1) - 1) > drift][0])
    ng = n * fine
    g, p, q = right_inverse.rear_inverse(exponent, gamma / exponent, 0.0, ng, stored.LOST)
    g_ahead, p_ahead, q_ahead = ahead_inverse(gamma, ng, stored.LOST)
    M = stored.beads(xi[u ** (exponent - 1) > SMALL_STIFFNESS][-1]) + p_ahead

    rear = min(tail_roots(exponent, gamma, beta=1.0).real)
    longer = stored.beads(stored.DECAYS / rear)
    first = -(c + q + 1) - longer
    stiffness = stored.window_stiffness(front, first, M, n)
    correction = window_correction(stiffness, gamma, n, -first * n, longer * n)
    rates = stored.BELOW_SLOWEST * rear, *_rates_ahead(exponent, gamma)
    return {
        "alpha": stored.fractions(alpha),
        "gamma": stored.fractions(interval),
        "sizes": stored.integers(behind, ahead, n, fine, p, q, c, M, p_ahead, q_ahead),
        "strain": approximate_strain(front, behind, ahead, n),
        "inverse_behind": stored.kernels(g),
        "inverse_ahead": stored.kernels(g_ahead),
        "correction": stored.matrix(correction),
        "weights": np.round(rates, stored.DIGITS_OF_WEIGHTS),
    }


def _rates_ahead(alpha, gamma):
    """Return ν₁ below and ν₂ above the rate μ of the tail ahead, ν₂ < α ν₁."""
    mu = rate_of_tail_ahead(0.0, gamma, 1.0)
    apart = min(WIDEST_RATES, (alpha - 1) / (2 * alpha))
    return (1 - apart) * mu, (1 + apart) * mu
