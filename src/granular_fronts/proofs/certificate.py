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
from granular_fronts.fronts.solve import solve_front
from granular_fronts.proofs import right_inverse, stored
from granular_fronts.proofs.checker import EXPANSION, check_certificate
from granular_fronts.proofs.dashpots.certificate import describe as describe_dashpots
from granular_fronts.proofs.existence import approximate, chebyshev_nodes

# What a user may choose, and what is tried one after another where nothing is chosen.
CELLS = 20  # of the window per bead
FINE = 40  # cells of the inverse behind per cell of the window
DRIFT = 6e-4  # largest |a(u)/α − 1| behind the window
USUAL = CELLS, FINE, DRIFT
COARSE_REASON = "Z1 < 1"  # what fails where the cells are too wide
FINER = (30, 60, 3e-4), (44, 80, 2e-4)

# The approximate front.
SMALL_STIFFNESS, SMALL_FORCE = 1e-3, 1e-11  # P̄ is 0 ahead of all larger a(u)/α and u^α
WIDEST = 1e-8  # width of an interval of γ on which P̄ need not depend on γ
DEGREE_IN_GAMMA = 4  # of P̄ on a wider one
LOST_IN_CURVATURE = 1e-5  # |u − 1| per squared half width: a wide interval has a larger Y₀ anyway

# The expansion behind, Lemma 14.
SMALL_OVERSHOOT = 1e-6  # fronts that overshoot by less may be monotone or oscillate behind
START = 1.5e-5  # |u − 1| at x₀: small enough to be nearly linear, far above the errors of u
LOST_BEHIND = 0.01  # ∫|g| cut off: these inverses enter bounds of Γ_w alone
PART = 2.5e-4  # half width of a part of the interval of γ per distance of λ₁ and Re λ₂,
SMALLEST_PART, LARGEST_PART = 2e-5, 2e-4  # but between these
LEAST_RADIUS = 1e-9  # of the square in which a root is looked for
WAYS = 3  # its radius in units of how far the root moves over the half width of a part

# The choice of θ and η there.
SLOW = np.linspace(0.84, 0.94, 6)  # candidates of θ in units of the slowest rate, below 1
FAST = np.linspace(1.72, 1.96, 9)  # candidates of η in units of θ, below 2
APART = 0.02  # least distance of η from all real parts, in units of η
COARSE, LOST_COARSE = 20, 0.1  # cells per bead and ∫|g| cut off where candidates are ranked
PLACE = 4  # beads behind x₀, where the remainder is to be small
WEIGHT_OF_SLOW = 0.1  # of Γ_θ, which enters only the small c, relative to Γ_η

Rational = float | str | Fraction  # a number as `rational` reads it


def prove_front(
    alpha: Rational | tuple[Rational, Rational],
    gamma: Rational | tuple[Rational, Rational],
    path: str | Path,
    cells: int | None = None,
    fine: int | None = None,
    drift: float | None = None,
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
        Cells of the window per bead, from 8 to 200; 20, and if all three are left out and Z₁ is not
        below 1, up to 44.
    fine : int, optional
        Cells of the inverse behind per cell of the window, from 1 to 1000; 40.
    drift : float, optional
        Largest absolute value of a(u)/α − 1 behind the window, between 0 and 1; 6e-4.
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

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import mkdtemp
    >>> record = gf.prove_front("3/2", "3/10", Path(mkdtemp()) / "front.npz")
    >>> record["proved"], record["statements"][-1]
    (True, "u*' < 0 on the whole line: the front is monotone.")
    """
    exponents, interval = interval_of(alpha, "alpha", above=1), interval_of(gamma, "gamma")
    path = arguments.new_file("path", path)
    meshes = _meshes(cells, fine, drift)
    if beta is not None and arguments.scalar("beta", beta) != 1.0:
        raise InputError(
            f"beta is {beta}, but fronts are proved for β = 1 and β = α: leave it out."
        )
    front = solve_front(float(sum(exponents) / 2), float(sum(interval) / 2), beta)
    if not front.attrs["converged"]:
        raise InputError(f"no front to prove: {front.attrs['reason']}.")
    described = describe_dashpots if beta == 1 else describe
    for mesh in meshes:
        fields = described(front, exponents, interval, *mesh)
        record = _write_and_check(path, fields)
        if record["proved"] or COARSE_REASON not in record["reason"]:
            break
    if not record["proved"] and "roots" in fields:  # Perhaps without the expansion behind.
        fields = {name: values for name, values in fields.items() if name not in EXPANSION}
        record = _write_and_check(path, fields | {"weights": fields["weights"][:1]})
    return record


def _meshes(cells, fine, drift):
    """Return the choices to try: one where something is given."""
    checks = (
        lambda given: arguments.count("cells", given, least=8, most=200),
        lambda given: arguments.count("fine", given, most=1000),
        lambda given: arguments.scalar("drift", given, above=0.0, below=1.0),
    )
    given = [
        None if value is None else check(value)
        for check, value in zip(checks, (cells, fine, drift), strict=True)
    ]
    if given == [None, None, None]:
        return USUAL, *FINER
    return ([own if value is None else value for own, value in zip(USUAL, given, strict=True)],)


def _write_and_check(path, fields):
    stored.write(path, fields)
    return check_certificate(path)


def describe(front, alpha, interval, n, fine, drift):
    """Return the fields of the certificate of a computed front."""
    exponent, gamma = front.attrs["alpha"], front.attrs["gamma"]
    xi, u = front["xi"].values, np.maximum(front["relative_displacement"].values, 0.0)
    half = float(interval[1] - interval[0]) / 2
    nodes = chebyshev_nodes(1 if 2 * half < WIDEST else DEGREE_IN_GAMMA + 1)
    # The given front belongs to the node in the middle.
    fronts = [solve_front(exponent, gamma + s * half) if abs(s) > 0.1 else front for s in nodes]
    near_one = max(stored.NEAR_ONE, LOST_IN_CURVATURE * half**2)
    behind = stored.beads(-xi[abs(u - 1) > near_one][0])
    pressed = (u ** (exponent - 1) > SMALL_STIFFNESS) | (u**exponent > SMALL_FORCE)
    ahead = stored.beads(xi[pressed][-1])
    c = stored.beads(-xi[abs(u ** (exponent - 1) - 1) > drift][0])
    g, p, q = right_inverse.rear_inverse(exponent, gamma, 0.0, n * fine, stored.LOST, half)

    slowest = min(tail_roots(exponent, gamma).real)
    longer = stored.beads(stored.DECAYS / slowest)
    first = -(c + q + 2) - longer
    stiffness = stored.window_stiffness(front, first, ahead + 1, n)
    correction = right_inverse.window_correction(stiffness, gamma, n, -first * n, longer * n)
    fields = {
        "alpha": stored.fractions(alpha),
        "gamma": stored.fractions(interval),
        "sizes": stored.integers(behind, ahead, n, p, q, c, fine),
        "profile": approximate(fronts, behind, ahead, n),
        "inverse": stored.kernels(g),
        "correction": stored.matrix(correction),
        "weights": np.round([stored.BELOW_SLOWEST * slowest], stored.DIGITS_OF_WEIGHTS),
    }
    if alpha[0] == alpha[1] and front.attrs["overshoot"] < SMALL_OVERSHOOT:
        fields |= _expansion(exponent, gamma, half, n * fine, xi, u)
    return fields


def _expansion(alpha, gamma, half, n, xi, u):
    """Return for Lemma 14: weights θ and η away from all roots, their inverses, roots and x₀."""
    # Nothing where there are more slow roots than a real one and a pair.
    roots, moved = (_slowest_first(tail_roots(alpha, gamma + step)) for step in (0, half))
    slow, fast = _weights(alpha, gamma, roots)
    if not slow:
        return {}
    g = [right_inverse.rear_inverse(alpha, gamma, w, n, LOST_BEHIND, half) for w in (slow, fast)]
    x0 = math.floor(xi[(abs(u - 1) > START) & (xi < 0)][0])
    lead = abs(roots.real[roots.imag > 0][0] - roots.real[0])
    parts = 1 + math.ceil(half / np.clip(PART * lead, SMALLEST_PART, LARGEST_PART))
    radius = LEAST_RADIUS + WAYS / parts * abs(roots - moved)
    found = [(root.real, root.imag, r) for root, r in zip(roots, radius, strict=True)]
    return {
        "weights": np.array([slow, fast]),
        "roots": np.array([row for row in found if row[0] < fast]),
        "starts": stored.integers(x0, *(-p * n for _, p, _ in g), parts),
        "slow_inverse": stored.kernels(g[0][0]),
        "fast_inverse": stored.kernels(g[1][0]),
    }


def _slowest_first(roots):
    return np.array(sorted(roots, key=lambda root: (root.imag != 0, root.real)))


def _weights(alpha, gamma, roots):
    """Return θ and η of Lemma 14: the remainder, about Γ_η e^((η − λ₁)t), small at t = −PLACE."""

    def norm(w):
        g = right_inverse.rear_inverse(alpha, gamma, w, COARSE, LOST_COARSE)[0]
        return abs(g).sum() / COARSE

    def merit(weights):
        slow, fast = weights
        return np.log(1 + norm(fast)) - PLACE * fast + WEIGHT_OF_SLOW * np.log(1 + norm(slow))

    def fits(fast):
        below = roots[roots.real < fast]
        few = (below.imag == 0).sum() <= 1 and (below.imag > 0).sum() <= 1
        return few and abs(roots.real - fast).min() > APART * fast

    choices = [
        (slow, fast)
        for slow in np.round(roots.real.min() * SLOW, stored.DIGITS_OF_WEIGHTS)
        for fast in np.round(slow * FAST, stored.DIGITS_OF_WEIGHTS)
        if fits(fast)
    ]
    return min(choices, key=merit, default=(0.0, 0.0))


def rational(number, name="number", above=0):
    """Return a fraction of at most 18 digits; a float means the decimal it is written as."""
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
    """Return what a fraction is made from; numbers of thousands of digits are not expanded."""
    if isinstance(number, bool) or re.search(r"[eE][+-]?[\d_]{3}", str(number)):
        raise ValueError
    return repr(float(number)) if isinstance(number, float) else number


def interval_of(numbers, name, above=0):
    """Return both ends of an interval, which are one number for a single one."""
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
