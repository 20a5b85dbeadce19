"""Hard cases of exact fronts: where tails are degenerate, long, or sharp.

Each front is solved by the profile equation and by shooting, which share no code.  At critical
damping two roots of the tail are one, or a pair and a real root decay alike.  Then no sum of modes
is well conditioned.  For weak damping the tail is hundreds of beads long, and for strong damping
the front itself.  A large exponent makes it sharp, and an exponent near 1 magnifies rounding.
"""

import functools
import math

import numpy as np

from granular_fronts.fronts.linear.critical_damping import critical_damping, meaning_changes_at
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.studies.hard_cases import HardCase

LIMIT = 1.0e-12


def _exact_front(where, alpha, gamma, beta=None):
    """One front by both methods."""
    front, shot = (solve_front(alpha, gamma, beta, method) for method in ("profile", "shooting"))
    error = math.nan
    if front.attrs["converged"] and shot.attrs["converged"]:
        other = evaluate_front(front, shot["xi"].values)
        error = float(np.abs(shot["relative_displacement"].values - other).max())
    damping = "" if beta is None else f", β = {beta:g}"
    return HardCase(
        problem=f"exact front {where}, α = {alpha:.6g}{damping}, γ = {gamma:.6g}",
        expected="one front by the profile equation and by shooting",
        criterion="distance of u between the two methods; both converge",
        quantity="overshoot max u − 1",
        measured=front.attrs["overshoot"],
        error=error,
        limit=LIMIT,
    )


def _at_critical_damping(where, alpha):
    """The front whose tail changes from oscillating to monotone."""
    return _exact_front(where, alpha, critical_damping(alpha))


def _at_triple_root():
    """The front at α*, where the three slowest roots are one."""
    return _at_critical_damping("at a triple root of the tail", meaning_changes_at())


CASES = {
    "front_double_root": functools.partial(_at_critical_damping, "at a double root", 1.1),
    "front_triple_root": _at_triple_root,
    "front_crossing": functools.partial(_at_critical_damping, "where real parts cross", 1.5),
    "front_gamma_0_01": functools.partial(_exact_front, "weakly damped", 1.5, 0.01),
    "front_gamma_20": functools.partial(_exact_front, "strongly damped", 1.5, 20.0),
    "front_alpha_1_02": functools.partial(_exact_front, "near the linear chain", 1.02, 0.05),
    "front_alpha_5": functools.partial(_exact_front, "with a sharp foot", 5.0, 0.1),
    "front_dashpot": functools.partial(_exact_front, "with a dashpot", 1.5, 0.3, 1.0),
}
