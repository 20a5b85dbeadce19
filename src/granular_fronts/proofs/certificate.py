"""Make the certificate of a front: floating-point arithmetic, trusted for nothing."""

import math
from fractions import Fraction
from pathlib import Path

import numpy as np

from granular_fronts.errors import InputError
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.proofs import right_inverse
from granular_fronts.proofs.balls import INVERSE_UNIT, MATRIX_UNIT
from granular_fronts.proofs.checker import EXPANSION, check_certificate
from granular_fronts.proofs.existence import approximate

LOST, LOST_BEHIND = 1e-4, 0.01
SMALL_STIFFNESS, SMALL_FORCE = 1e-3, 1e-11
NEAR_ONE = 1e-11
DRIFT = 6e-4
FINE = 40
COARSE = 20
WIDEST = 1e-8
START = 1.5e-5


def prove_front(alpha, gamma, path, cells=20, fine=FINE, drift=DRIFT):
    """Prove that a front exists, near the computed one, and what it looks like.

    Parameters
    ----------
    alpha : int, str or Fraction
        Exponent of the force, above 1: 2, "3/2" or "1.5".
    gamma : int, str, Fraction or pair of them
        Damping, above 0 (β = α); a pair is an interval, for every point of which the proof holds.
    path : str or path
        The certificate is written here.
    cells : int, optional
        Cells of the window per bead.
    fine : int, optional
        Cells of the inverse behind per cell of the window.
    drift : float, optional
        Largest |a(u)/α − 1| behind the window.

    Returns
    -------
    dict
        See `check_certificate`.

    Raises
    ------
    InputError
        If the front is not found, or the numbers do not fit into a certificate.
    """
    alpha, interval = rational(alpha), _interval(gamma)
    middle = float(sum(interval) / 2)
    front = solve_front(float(alpha), middle)
    if not front.attrs["converged"]:
        raise InputError(f"no front to prove: {front.attrs['reason']}")
    fields = describe(front, alpha, interval, cells, fine, drift)
    record = _write_and_check(path, fields)
    if not record["proved"] and "roots" in fields:  # Perhaps without the expansion behind.
        fields = {name: values for name, values in fields.items() if name not in EXPANSION}
        record = _write_and_check(path, fields | {"weights": fields["weights"][:1]})
    return record


def _write_and_check(path, fields):
    with Path(path).open("wb") as file:
        np.savez_compressed(file, **fields)
    return check_certificate(path)


def describe(front, alpha, interval, n, fine, drift):
    """The fields of the certificate of a computed front."""
    exponent, gamma = float(alpha), front.attrs["gamma"]
    xi, u = front["xi"].values, np.maximum(front["relative_displacement"].values, 0.0)
    behind = _beads(-xi[abs(u - 1) > NEAR_ONE][0])
    ahead = _beads(xi[(u ** (exponent - 1) > SMALL_STIFFNESS) | (u**exponent > SMALL_FORCE)][-1])
    c = _beads(-xi[abs(u ** (exponent - 1) - 1) > drift][0])
    g, p, q = right_inverse.rear_inverse(exponent, gamma, 0.0, n * fine, LOST)

    roots = sorted(tail_roots(exponent, gamma), key=lambda root: root.real)
    longer = _beads(6.5 / roots[0].real) * n
    first, last = -(c + q + 2) - longer // n, ahead + 1
    middles = (np.arange((last - first) * n) + 0.5) / n + first
    strain = np.maximum(evaluate_front(front, middles), 0.0)
    stiffness = exponent * strain ** (exponent - 1)
    correction = right_inverse.window_correction(stiffness, gamma, n, -first * n, longer)
    fields = {
        "alpha": _integers(alpha.numerator, alpha.denominator),
        "gamma": _integers(*(k for end in interval for k in (end.numerator, end.denominator))),
        "sizes": _integers(behind, ahead, n, p, q, c, fine),
        "profile": approximate(front, behind, ahead, n),
        "inverse": _differences(g, INVERSE_UNIT, np.int32),
        "correction": _differences(correction, MATRIX_UNIT, np.int16),
        "weights": np.array([round(0.9 * roots[0].real, 4)]),
    }
    narrow = interval[1] - interval[0] < WIDEST
    if narrow and roots[0].imag == 0 and front.attrs["overshoot"] < 1e-9:
        radius = 1e-9 + 20 * float(interval[1] - interval[0])
        fields |= _expansion(exponent, gamma, n * fine, roots, radius, xi, u)
    return fields


def _expansion(alpha, gamma, n, roots, radius, xi, u):
    """What Lemma 8 needs: weights θ and η away from all roots, their inverses, roots and x₀."""
    slow, fast = _weights(alpha, gamma, np.array([root.real for root in roots]))
    g = [right_inverse.rear_inverse(alpha, gamma, w, n, LOST_BEHIND) for w in (slow, fast)]
    x0 = math.floor(xi[(abs(u - 1) > START) & (xi < 0)][0])
    found = [(root.real, root.imag, radius) for root in roots if root.real < fast]
    return {
        "weights": np.array([slow, fast]),
        "roots": np.array(found),
        "starts": _integers(x0, *(-p * n for _, p, _ in g)),
        "slow_inverse": _differences(g[0][0], INVERSE_UNIT, np.int32),
        "fast_inverse": _differences(g[1][0], INVERSE_UNIT, np.int32),
    }


def _weights(alpha, gamma, roots):
    """θ and η of Lemma 8: the remainder, about Γ_η e^((η − λ₁)t), small four beads behind x₀."""

    def norm(w):
        return abs(right_inverse.rear_inverse(alpha, gamma, w, COARSE, 0.1)[0]).sum() / COARSE

    def merit(weights):
        slow, fast = weights
        return np.log(1 + norm(fast)) - 4 * fast + 0.1 * np.log(1 + norm(slow))

    choices = [
        (slow, fast)
        for slow in np.round(roots[0] * np.linspace(0.84, 0.94, 6), 4)
        for fast in np.round(slow * np.linspace(1.72, 1.96, 9), 4)
        if (roots < fast).sum() <= 2 and abs(roots - fast).min() > 0.02 * fast
    ]
    return min(choices, key=merit)


def rational(number):
    """A fraction; a float stands for the decimal number that it is written as."""
    try:
        return Fraction(repr(number) if isinstance(number, float) else number)
    except (TypeError, ValueError) as problem:
        raise InputError(f"{number!r} is no number: write a fraction as '3/10'.") from problem


def _interval(gamma):
    low, high = map(rational, gamma if isinstance(gamma, (tuple, list)) else (gamma, gamma))
    if low > high:
        raise InputError(
            f"the interval of gamma runs from {low} down to {high}: exchange its ends."
        )
    return low, high


def _beads(length):
    return max(1, math.ceil(length))


def _integers(*numbers):
    if max(map(abs, numbers)) >= 2**63:
        raise InputError("a fraction has more than 18 digits: round it.")
    return np.array(numbers, dtype=np.int64)


def _differences(values, unit, kind):
    """Second differences in integers, once along each axis of a matrix."""
    found = np.rint(values / unit).astype(np.int64)
    for axis in (0, -1):
        found = np.diff(found, axis=axis, prepend=0)
    if abs(found).max() > np.iinfo(kind).max:
        raise InputError("the window's matrix is too rough for a certificate: use more cells.")
    return found.astype(kind)
