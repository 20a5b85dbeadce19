"""Bounds of 1 − L A and of A with dashpots, named and derived in `right_inverse`."""

import numpy as np
from flint import arb

from granular_fronts.proofs.balls import (
    array,
    convolve,
    defect,
    inverse_defect,
    kernel,
    largest,
    slope_kernel,
    tops,
    unit_plus,
)


def bound_inverse(front):
    """Return Z₁, and bounds ρ of y ↦ (A y)(ξ) on all cells, behind and ahead of them."""
    n, alpha, sizes = front.n, front.alpha, front.sizes
    first, W = (front.left - front.b) * n, (front.b + sizes["M"]) * n
    last = first + W
    low, mid, high = (array(map(front.a, u)) for u in (front.u_low, front.u_mid, front.u_high))
    far = (front.left - sizes["c"]) * n
    drift = largest(abs(a / alpha - 1) for a in (*low[:far], *high[:far]))
    force_ahead = largest([*high[last - sizes["p_ahead"] * n :], arb(0)])
    (g, e), (g_ahead, e_ahead) = _convolutions(front)
    front.rear_norms = 1 + (front.gamma / alpha) ** 2, g[0], e

    low, mid, a = low[first:last], mid[first:last], high[first:last]
    v, rest = _matrix(front, mid)
    w = v + 1
    inner = _variation(front, w, low, mid, a)
    entering, leaving = (
        (front.gamma + largest(a[bead]) / 2) * largest(w[bead])
        for bead in (slice(n), slice(-n, None))
    )
    gain, gain_ahead = largest([1 + entering, *rest[:n]]), 1 + leaving
    Z1 = (
        largest([*inner[:n], *(inner + rest)[n:]])
        + gain * (e + alpha * drift * (1 + g[0]))
        + gain_ahead * (e_ahead + (1 + g_ahead[0]) * force_ahead)
    )

    fine, cells = sizes["fine"], np.arange(W)
    start = (cells - n + sizes["p"] * n) * fine
    end = (cells + 1 - W + sizes["p_ahead"] * n) * fine
    rho = w + gain * g[np.minimum(start, len(g) - 1)]
    rho += gain_ahead * (g_ahead[0] - g_ahead[np.maximum(end, 0)])
    rho[:n] += rest[:n]
    behind, ahead = gain * (1 + g[0]), gain_ahead * (1 + g_ahead[0])
    rho = tops([behind] * first + [*rho] + [ahead] * (len(high) - last))
    return Z1.upper(), rho, behind.upper(), ahead.upper()


def _convolutions(front):
    """Return ∫|g| from each cell on, and ‖e‖₁, behind and ahead."""
    alpha, gamma, sizes, ng = front.alpha, front.gamma, front.sizes, front.n * front.sizes["fine"]
    rows = front.data["inverse_behind"], front.data["inverse_ahead"]
    behind = inverse_defect(alpha, [gamma / alpha], arb(0), ng, rows[0], -sizes["p"] * ng)
    sign = [gamma * f for f in slope_kernel(arb(0), ng)]
    ahead = defect([sign], (arb(0), 4 * gamma), ng, rows[1], -sizes["p_ahead"] * ng)
    front.require("‖e‖ behind", behind[1], arb(1))
    front.require("‖e‖ ahead", ahead[1], arb(1))
    return behind, ahead


def _matrix(front, a):
    """Return the norms of v, and rest, on the cells of the window."""
    n, W, h, gamma = front.n, len(a), arb(1) / front.n, front.gamma
    tent_middles, tent, _ = kernel(arb(0), arb(0), n)
    sign_middles, sign = slope_kernel(arb(0), n)
    sources = 2 * gamma + convolve(tent, a)[n:-n]
    halves = convolve(array([1, *[2] * (2 * n - 1), 1]), a)[n:-n]
    H, correction = unit_plus(front.data["correction"])
    rest, v = array([0] * W), array([0] * W)
    for j in range(W):  # columns of 1 − L_h H
        smooth = (convolve(tent, a * H[:, j]) + gamma * convolve(sign, H[:, j]))[n:-n]
        rest += np.abs(smooth - correction[:, j]) * sources[j]
    for i in range(W):  # Φ_i at the edges of cells
        jumps, tents = (
            convolve(f[::-1], H[i])[n - 1 : n + W] for f in (gamma * sign_middles, tent_middles)
        )
        edges = (jumps[k : k + W] + a * tents[k : k + W] for k in (0, 1))
        v[i] = (
            h / 2 * sum(np.abs(f).sum() for f in edges) + h * h / 8 * (np.abs(H[i]) * halves).sum()
        )
    return tops(v), tops(rest)


def _variation(front, w, low, mid, high):
    """Return inner_i, from bounds w of the functions and bounds of ā on the cells."""
    n, h = front.n, arb(1) / front.n
    jumps = array([0] * (2 * n + 1))
    jumps[[0, n, -1]] = array([1, 2, 1])
    slopes = array([1] * (2 * n + 1))
    tent = kernel(arb(0), arb(0), n)[1]
    oscillation = array(largest(pair) for pair in zip(high - mid, mid - low, strict=True))
    return (
        front.gamma * h / 2 * np.convolve(w, jumps)
        + h * h / 2 * np.convolve(w * high, slopes)
        + np.convolve(w * oscillation, tent)
    )[n:-n]
