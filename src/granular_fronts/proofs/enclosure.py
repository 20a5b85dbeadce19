"""A proved front for a picture: ū, its error bounds, the residual, and bounds of both tails.

Lemma 7 of `consequences` holds ahead of x₁ with s = S(x₁)^(α−1) and k = ‖K‖₁.  There the proof of
Lemma 8 bounds u from one bead to the next: for x > x₁ + 1, as u decreases on [x − 1, ∞),

    c κ u(x − 1 + κ)^α ≤ u(x) ≤ k u(x − 1)^α,      c = γ − γ² (1 + γ) s/(2 (1 − k s)),

for 0 < κ < 1.  Each bound is used where it is better than the bound of the enclosure.  What is
evaluated here in doubles, from bounds that are proved, is for the eye.
"""

import numpy as np
import xarray as xr

from granular_fronts.proofs.balls import in_balls
from granular_fronts.proofs.families import prove

BEADS_AHEAD = 8  # of the window, to which both bounds of the tail are continued


def enclosure_dataset(path):
    """Return what a certificate proves of its front; NotProvedError if that is nothing.

    In the middles of the cells, on `xi`: `approximation` ū, bounds of the `error` of u and of the
    `residual`.  On `xi_ahead`, from x₁ on, bounds `decay_low` and `decay_high` of −ln u, the latter
    infinite where u has no bound from below.  Attributes: all numbers of the certificate.
    """
    front = prove(path)
    with in_balls():
        residual = [float(front.residual(j).upper()) for j in range(len(front.u))]
        low, high = (
            np.array([float(bound.mid()) for bound in bounds])
            for bounds in (front.u_low - front.u_error, front.u_high + front.u_error)
        )
    xi = (np.arange(len(front.u)) + 0.5) / front.n - front.left
    ahead, decay = _tail_ahead(front, xi, low, high)
    return xr.Dataset(
        {
            "approximation": ("xi", [float(u[0].mid()) for u in front.u]),
            "error": ("xi", [float(error.upper()) for error in front.u_error]),
            "residual": ("xi", residual),
            "decay_low": ("xi_ahead", decay[0]),
            "decay_high": ("xi_ahead", decay[1]),
        },
        {"xi": xi, "xi_ahead": ahead},
        {
            "error_bound": front.error,
            "alpha": float(front.alpha),
            "gamma": float(front.gamma),
            **{name: float(value) for name, value in front.numbers.items()},
        },
    )


def _tail_ahead(front, xi, low, high):
    alpha, gamma, n = float(front.alpha), float(front.gamma), front.n
    [small] = [one for one in front.inequalities if one["name"] == "decrease ahead"]
    s, k = small["left"] / ((1 + 2 * gamma) * (1 + gamma)), float(front.nK)
    c = gamma - gamma**2 * (1 + gamma) * s / (2 * (1 - k * s))
    start = np.flatnonzero(high ** (alpha - 1) > s)[-1] + 1
    ahead = xi[start] + np.arange(len(xi) - start + BEADS_AHEAD * n) / n
    with np.errstate(divide="ignore"):
        lows, highs = np.full(len(ahead), -np.inf), np.full(len(ahead), np.inf)
        known = len(xi) - start
        lows[:known] = np.log(np.maximum(low[start:], 0.0))
        highs[:known] = np.log(high[start:])
    near = max(1, n // 10)  # κ in cells
    for j in range(n + 1, len(ahead)):
        highs[j] = min(highs[j], np.log(k) + alpha * highs[j - n])
        lows[j] = max(lows[j], np.log(c * near / n) + alpha * lows[j - n + near])
    return ahead, (-highs, -lows)
