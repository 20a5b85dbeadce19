r"""Weights of the front's convolutions on a uniform grid, exact for polynomials.

The profile equation (`profile`) needs, at each grid point ξ, the three integrals

.. math::

    \int_{-1}^{1} (1 - |s|)\, P(\xi - s)\,ds, \qquad
    \int_{-1}^{1} \operatorname{sgn}(s)\, Q(\xi - s)\,ds, \qquad
    \int_{0}^{1} P(\xi - s)\,ds .

On every cell of the grid the function is replaced by the polynomial through the `order` points
around it, half of them on each side, and the product with the kernel, which is linear there, is
integrated exactly.  The weights are rational numbers, computed as such once per grid.  The rule is
exact for polynomials of degree below `order`, with an error of the order h^order.  The spacing h
may be any rational number, above 1 too: then the kernel covers parts of two cells only.
"""

import functools
import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np


class Weights(NamedTuple):
    """Weights of the values at ξ − wh … ξ + wh.

    Attributes
    ----------
    hat, jump, site : ndarray, shape (2w + 1,)
        Of the three integrals, in this order.
    """

    hat: np.ndarray
    jump: np.ndarray
    site: np.ndarray


@functools.cache
def kernel_weights(spacing, order):
    """Weights on a grid.

    Parameters
    ----------
    spacing : Fraction
        Distance h of neighbouring points, in sites.
    order : int
        Number of points of the local polynomial, even.

    Returns
    -------
    Weights
    """
    plain, linear = _one_sided(spacing, order)
    ahead, ramp = np.array(plain), np.array(linear)
    behind = ahead[::-1]
    return Weights(
        hat=_floats(ahead - ramp + (ahead - ramp)[::-1]),
        jump=_floats(behind - ahead),
        site=_floats(behind),
    )


def _one_sided(spacing, order):
    """Exact weights of ∫_0^1 P(ξ + s) ds and ∫_0^1 s P(ξ + s) ds."""
    cells = math.ceil(1 / spacing)
    half = order // 2
    width = cells - 1 + half
    plain = [Fraction(0)] * (2 * width + 1)
    linear = list(plain)
    for cell in range(cells):
        end = min(Fraction(1), 1 / spacing - cell)
        for node in range(1 - half, half + 1):
            zeroth, first = _moments(node, order, end)
            plain[width + cell + node] += spacing * zeroth
            linear[width + cell + node] += spacing**2 * (first + cell * zeroth)
    return plain, linear


@functools.cache
def _moments(node, order, end):
    """∫_0^end L(t) dt and ∫_0^end t L(t) dt of the cardinal polynomial L of a node."""
    coefficients = _cardinal(node, order)
    zeroth = sum(c * end ** (k + 1) / (k + 1) for k, c in enumerate(coefficients))
    first = sum(c * end ** (k + 2) / (k + 2) for k, c in enumerate(coefficients))
    return zeroth, first


@functools.cache
def _cardinal(node, order):
    """Coefficients of the polynomial that is 1 at a node, 0 at the others of 1 − p/2 … p/2."""
    coefficients = [Fraction(1)]
    for other in range(1 - order // 2, order // 2 + 1):
        if other != node:
            shifted = [Fraction(0), *coefficients]
            scaled = [other * c for c in coefficients] + [Fraction(0)]
            coefficients = [(a - b) / (node - other) for a, b in zip(shifted, scaled, strict=True)]
    return coefficients


def _floats(values):
    return np.array([float(value) for value in values])
