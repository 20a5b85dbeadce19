"""Make the certificate of a front: floating-point arithmetic, trusted for nothing."""

import math
import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from granular_fronts import arguments
from granular_fronts.errors import InputError
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.output.files import complete_file
from granular_fronts.proofs import right_inverse
from granular_fronts.proofs.balls import MATRIX_UNIT
from granular_fronts.proofs.checker import EXPANSION, check_certificate
from granular_fronts.proofs.dashpots.certificate import describe as describe_dashpots
from granular_fronts.proofs.existence import approximate, chebyshev_nodes
from granular_fronts.proofs.stored import (
    beads,
    differences,
    fractions,
    integers,
    kernels,
    require_size,
)

LOST, LOST_BEHIND = 1e-4, 0.01
SMALL_STIFFNESS, SMALL_FORCE = 1e-3, 1e-11
NEAR_ONE, LOST_IN_CURVATURE = 1e-11, 1e-5
DEGREE_IN_GAMMA = 4
DRIFT = 6e-4
FINE = 40
COARSE = 20
WIDEST = 1e-8
START = 1.5e-5
SMALL_OVERSHOOT = 1e-6
PART, LARGEST_PART, SMALLEST_PART = 2.5e-4, 2e-4, 2e-5

Rational = float | str | Fraction
"""A number as `rational` reads it."""


def prove_front(
    alpha: Rational | tuple[Rational, Rational],
    gamma: Rational | tuple[Rational, Rational],
    path: str | Path,
    cells: int = 20,
    fine: int = FINE,
    drift: float = DRIFT,
    beta: int | None = None,
) -> dict[str, Any]:
    """Prove that a front exists, near the computed one, and what it looks like.

    Parameters
    ----------
    alpha : int, float, str, Fraction or pair of them
        Exponent of the force, above 1: 2, "3/2" or "1.5"; a pair is an interval.
    gamma : int, float, str, Fraction or pair of them
        Damping, above 0.  The proof holds for every point of both intervals.
    path : str or path
        The certificate is written here, in a folder that exists.
    cells : int, optional
        Cells of the window per bead, from 8 to 200.
    fine : int, optional
        Cells of the inverse behind per cell of the window, from 1 to 1000.
    drift : float, optional
        Largest absolute value of a(u)/α − 1 behind the window, between 0 and 1.
    beta : 1, optional
        Exponent of the damping: α by default, or 1, linear dashpots, whose intervals must be
        narrow, as the approximate front does not depend on γ.

    Returns
    -------
    dict
        See `check_certificate`.

    Raises
    ------
    InputError
        If an argument is impossible, the front is not found, or the numbers do not fit into a
        certificate.
    """
    exponents, interval = interval_of(alpha, "alpha", above=1), interval_of(gamma, "gamma")
    path = arguments.new_file("path", path)
    cells = arguments.count("cells", cells, least=8, most=200)
    fine = arguments.count("fine", fine, most=1000)
    drift = arguments.scalar("drift", drift, above=0.0, below=1.0)
    if beta is not None and arguments.scalar("beta", beta) != 1.0:
        raise InputError(
            f"beta is {beta}, but fronts are proved for β = 1 and β = α: leave it out."
        )
    front = solve_front(float(sum(exponents) / 2), float(sum(interval) / 2), beta)
    if not front.attrs["converged"]:
        raise InputError(f"no front to prove: {front.attrs['reason']}.")
    described = describe_dashpots if beta == 1 else describe
    fields = described(front, exponents, interval, cells, fine, drift)
    record = _write_and_check(path, fields)
    if not record["proved"] and "roots" in fields:  # Perhaps without the expansion behind.
        fields = {name: values for name, values in fields.items() if name not in EXPANSION}
        record = _write_and_check(path, fields | {"weights": fields["weights"][:1]})
    return record


def _write_and_check(path, fields):
    with complete_file(path) as unfinished, unfinished.open("wb") as file:
        np.savez_compressed(file, **fields)
    return check_certificate(path)


def describe(front, alpha, interval, n, fine, drift):
    """The fields of the certificate of a computed front."""
    exponent, gamma = front.attrs["alpha"], front.attrs["gamma"]
    xi, u = front["xi"].values, np.maximum(front["relative_displacement"].values, 0.0)
    half = float(interval[1] - interval[0]) / 2
    nodes = chebyshev_nodes(1 if 2 * half < WIDEST else DEGREE_IN_GAMMA + 1)
    fronts = [solve_front(exponent, gamma + s * half) if abs(s) > 0.1 else front for s in nodes]
    behind = beads(-xi[abs(u - 1) > max(NEAR_ONE, LOST_IN_CURVATURE * half**2)][0])
    ahead = beads(xi[(u ** (exponent - 1) > SMALL_STIFFNESS) | (u**exponent > SMALL_FORCE)][-1])
    c = beads(-xi[abs(u ** (exponent - 1) - 1) > drift][0])
    g, p, q = right_inverse.rear_inverse(exponent, gamma, 0.0, n * fine, LOST, half)

    roots = sorted(tail_roots(exponent, gamma), key=lambda root: root.real)
    longer = beads(6.5 / roots[0].real) * n
    first, last = -(c + q + 2) - longer // n, ahead + 1
    require_size((last - first) * n)
    middles = (np.arange((last - first) * n) + 0.5) / n + first
    strain = np.maximum(evaluate_front(front, middles), 0.0)
    stiffness = exponent * strain ** (exponent - 1)
    correction = right_inverse.window_correction(stiffness, gamma, n, -first * n, longer)
    fields = {
        "alpha": fractions(alpha),
        "gamma": fractions(interval),
        "sizes": integers(behind, ahead, n, p, q, c, fine),
        "profile": approximate(fronts, behind, ahead, n),
        "inverse": kernels(g),
        "correction": differences(correction, MATRIX_UNIT, np.int16),
        "weights": np.array([round(0.9 * roots[0].real, 4)]),
    }
    if alpha[0] == alpha[1] and front.attrs["overshoot"] < SMALL_OVERSHOOT:
        fields |= _expansion(exponent, gamma, half, n * fine, xi, u)
    return fields


def _expansion(alpha, gamma, half, n, xi, u):
    """What Lemma 8 needs: weights θ and η away from all roots, their inverses, roots and x₀.

    Nothing where there are more slow roots than a real one and a pair.
    """
    roots, moved = (slowest_first(tail_roots(alpha, gamma + step)) for step in (0, half))
    slow, fast = _weights(alpha, gamma, roots)
    if not slow:
        return {}
    g = [right_inverse.rear_inverse(alpha, gamma, w, n, LOST_BEHIND, half) for w in (slow, fast)]
    x0 = math.floor(xi[(abs(u - 1) > START) & (xi < 0)][0])
    lead = abs(roots.real[roots.imag > 0][0] - roots.real[0])
    parts = 1 + math.ceil(half / np.clip(PART * lead, SMALLEST_PART, LARGEST_PART))
    radius = 1e-9 + 3 / parts * abs(roots - moved)
    found = [(root.real, root.imag, r) for root, r in zip(roots, radius, strict=True)]
    return {
        "weights": np.array([slow, fast]),
        "roots": np.array([row for row in found if row[0] < fast]),
        "starts": integers(x0, *(-p * n for _, p, _ in g), parts),
        "slow_inverse": kernels(g[0][0]),
        "fast_inverse": kernels(g[1][0]),
    }


def slowest_first(roots):
    """Real roots first, and the slowest first among those."""
    return np.array(sorted(roots, key=lambda root: (root.imag != 0, root.real)))


def _weights(alpha, gamma, roots):
    """θ and η of Lemma 8: the remainder, about Γ_η e^((η − λ₁)t), small four beads behind x₀."""

    def norm(w):
        return abs(right_inverse.rear_inverse(alpha, gamma, w, COARSE, 0.1)[0]).sum() / COARSE

    def merit(weights):
        slow, fast = weights
        return np.log(1 + norm(fast)) - 4 * fast + 0.1 * np.log(1 + norm(slow))

    def fits(fast):
        below = roots[roots.real < fast]
        few = (below.imag == 0).sum() <= 1 and (below.imag > 0).sum() <= 1
        return few and abs(roots.real - fast).min() > 0.02 * fast

    choices = [
        (slow, fast)
        for slow in np.round(roots.real.min() * np.linspace(0.84, 0.94, 6), 4)
        for fast in np.round(slow * np.linspace(1.72, 1.96, 9), 4)
        if fits(fast)
    ]
    return min(choices, key=merit, default=(0.0, 0.0))


def rational(number, name="number", above=0):
    """A fraction of at most 18 digits; a float stands for the decimal it is written as."""
    try:
        found = Fraction(_written(number))
        if found > above and max(found.numerator, found.denominator) < 10**18:
            return found
    except (TypeError, ValueError, ArithmeticError):
        pass
    raise InputError(
        f"{name} is {arguments.shown(number)}, but must be a number above {above} of at most 18"
        " digits: write a fraction as '3/10'."
    )


def _written(number):
    """What a fraction is made from; numbers of thousands of digits are not expanded."""
    if isinstance(number, bool) or re.search(r"[eE][+-]?[\d_]{3}", str(number)):
        raise ValueError
    return repr(float(number)) if isinstance(number, float) else number


def interval_of(numbers, name, above=0):
    """Both ends of an interval, which are one number for a single one."""
    ends = numbers if isinstance(numbers, (tuple, list)) else (numbers, numbers)
    if len(ends) != 2:
        raise InputError(
            f"{name} is {arguments.shown(numbers)}, but must be a number or two: give it."
        )
    low, high = (rational(end, name, above) for end in ends)
    if low > high:
        raise InputError(
            f"the interval of {name} runs from {low} down to {high}: exchange its ends."
        )
    return low, high
