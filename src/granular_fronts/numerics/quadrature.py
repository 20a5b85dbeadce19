r"""Weights of the front's convolutions on a uniform grid, exact for polynomials.

The profile equation (`profile`) needs, at each grid point ξ, the three integrals

.. math::

    \int_{-1}^{1} (1 - |s|)\, P(\xi - s)\,ds, \qquad
    \int_{-1}^{1} \operatorname{sgn}(s)\, Q(\xi - s)\,ds, \qquad
    \int_{0}^{1} P(\xi - s)\,ds .

On every cell of the grid the function is replaced by a polynomial. It goes through the `order`
points around the cell, half of them on each side.  Its product with the kernel, which is linear
there, is integrated exactly.  The weights are rational numbers, computed as such once per grid.
The rule is exact for polynomials of degree below `order`, with an error of the order h^order.  The
spacing h may be any rational number, above 1 too: then the kernel covers parts of two cells only.
"""

import functools
import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np


class Weights(NamedTuple):
    """Weights of the values at ξ − wh … ξ + wh, of the three integrals in their order."""

    hat: np.ndarray
    jump: np.ndarray
    site: np.ndarray


@functools.cache
def kernel_weights(spacing: Fraction, order: int) -> Weights:
    """Return the weights on a grid of spacing h, in sites.

    The order is the number of points of the local polynomial, even.
    """
    ahead, ramp = _one_sided(spacing, order)
    behind = ahead[::-1]
    return Weights(
        hat=(ahead - ramp + (ahead - ramp)[::-1]).astype(float),
        jump=(behind - ahead).astype(float),
        site=behind.astype(float),
    )


def _one_sided(spacing, order):
    """Return the exact weights of ∫_0^1 P(ξ + s) ds and ∫_0^1 s P(ξ + s) ds."""
    cells = math.ceil(1 / spacing)
    width = cells - 1 + order // 2
    moments = _moments(order, Fraction(1)), _moments(order, 1 / spacing - (cells - 1))
    # Whole numbers over one denominator add up much faster than fractions do.
    sums = np.zeros((2, 2, 2 * width + 1), dtype=object)
    for cell in range(cells):
        part = int(cell == cells - 1)
        (zeroth, first), _ = moments[part]
        nodes = slice(width + cell + 1 - order // 2, width + cell + 1 + order // 2)
        sums[part, 0, nodes] += zeroth
        sums[part, 1, nodes] += first + cell * zeroth
    plain, linear = sum(
        part * Fraction(1, denominator)
        for part, (_, denominator) in zip(sums, moments, strict=True)
    )
    return spacing * plain, spacing**2 * linear


@functools.cache
def _moments(order, end):
    """Return ∫_0^end L(t) dt and ∫_0^end t L(t) dt of cardinal polynomials, one denominator."""
    # The result is the array of numerators, shape (2, order), and the denominator.
    coefficients, denominator = _cardinals(order)
    integrals = [[end ** (k + i) / (k + i) for k in range(order)] for i in (1, 2)]
    common = math.lcm(*(integral.denominator for row in integrals for integral in row))
    powers = np.array([[int(common * integral) for integral in row] for row in integrals], object)
    return powers @ coefficients.T, common * denominator


@functools.cache
def _cardinals(order):
    """Return the polynomials that are 1 at one of the nodes 1 − p/2 … p/2 and 0 at the others."""
    nodes = range(1 - order // 2, order // 2 + 1)
    products = [math.prod(node - other for other in nodes if other != node) for node in nodes]
    denominator = math.lcm(*products)
    polynomials = []
    for node, product in zip(nodes, products, strict=True):
        polynomial = [denominator // product]
        for other in nodes:
            if other != node:
                shifted, scaled = [0, *polynomial], [*(other * c for c in polynomial), 0]
                polynomial = [a - b for a, b in zip(shifted, scaled, strict=True)]
        polynomials.append(polynomial)
    return np.array(polynomials, object), denominator
