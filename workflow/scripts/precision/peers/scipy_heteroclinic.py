r"""SciPy on the heteroclinic orbit of James (2021), section 5.2.

`solve_ivp` traces the orbit of (57), y' = z, z' = μz - y ln|y|, backwards from its tail, where

    z = -v y,   v ≈ (p + ½ + μ²/4)^{1/2} - μ/2,   p = -ln y,

is exact for μ = 0 and its error dies out like e^{-2p} on the way. The orbit is stopped at y = ½,
where s = 0, and goes on from there. Absolute tolerances would hide the tail, so that next to none
is asked for there. The same in (p, v), p' = v and v' = v² + μv - p, needs no logarithm.

`solve_bvp` takes the parts left and right of s = 0 as four unknowns on one interval; the right one
ends on the manifold at p ≈ 40.
"""

from functools import partial

import numpy as np
from scipy.integrate import solve_bvp, solve_ivp

from peers.runs import Run, Stopwatch

RTOL_FLOOR = 100 * np.finfo(float).eps
ABSOLUTE_OVER_RELATIVE = 1e-2
TAIL_MARGIN = 25.0
BVP_END = 40.0
FIRST_NODES, MOST_NODES = 201, 200_000


def planar(_, state, mu):
    """Return the right-hand side of (57)."""
    y, z = state
    return np.array([z, mu * z - y * np.log(np.maximum(np.abs(y), 1e-300))])


def logarithmic(_, state, mu):
    """Return the same in p = -ln y and v = p'."""
    p, v = state
    return np.array([v, v * v + mu * v - p])


def _tail_slope(p, mu):
    """Return the v of the stable manifold at a large p."""
    return np.sqrt(p + 0.5 + 0.25 * mu**2) - 0.5 * mu


def _run_traced(mu, s, tolerance, method):
    """Trace (57) with one method of solve_ivp."""
    p = tail_start(mu, s)
    y = np.exp(-p)
    return _trace(
        partial(planar, mu=mu),
        (y, -_tail_slope(p, mu) * y),
        lambda _, state: state[0] - 0.5,
        lambda state: dict(zip(("rescaled_force", "slope"), state, strict=True)),
        s,
        {"method": method, "rtol": max(tolerance, RTOL_FLOOR)},
        tail_atol=1e-3 * tolerance * y,
        front_atol=ABSOLUTE_OVER_RELATIVE * tolerance,
    )


def _run_traced_logarithmic(mu, s, tolerance):
    """Trace the orbit in (p, v) with DOP853."""
    p = tail_start(mu, s)

    def fields(state):
        y = np.exp(-state[0])
        return {"rescaled_force": y, "slope": -state[1] * y}

    return _trace(
        partial(logarithmic, mu=mu),
        (p, _tail_slope(p, mu)),
        lambda _, state: state[0] - np.log(2.0),
        fields,
        s,
        {"method": "DOP853", "rtol": max(tolerance, RTOL_FLOOR)},
        tail_atol=ABSOLUTE_OVER_RELATIVE * tolerance,
        front_atol=ABSOLUTE_OVER_RELATIVE * tolerance,
    )


def tail_start(mu, s):
    """Return a p ahead of all s, from the steeper tail of the orbit without damping."""
    return 0.25 * (s[-1] + 3.0) ** 2 + TAIL_MARGIN / (1.0 + 0.01 * mu**2)


def _trace(right_hand_side, start, half, fields, s, options, tail_atol, front_atol):
    """Follow an orbit from its tail to y = ½, shift s, and follow it to the first s."""
    half.terminal = True
    ahead, behind = s[s >= 0.0], s[s < 0.0]
    with Stopwatch() as watch:
        tail = solve_ivp(
            right_hand_side,
            (0.0, -1e4),
            start,
            events=half,
            dense_output=True,
            atol=tail_atol,
            **options,
        )
        met = tail.t_events[0].size if tail.success else 0
        if met:
            at_half, state = tail.t_events[0][0], tail.y_events[0][0]
            front = solve_ivp(
                right_hand_side,
                (0.0, behind[0]),
                state,
                t_eval=behind[::-1],
                atol=front_atol,
                **options,
            )
            states = np.hstack([front.y[:, ::-1], tail.sol(at_half + ahead)])
    if not met:
        return Run(message=f"solve_ivp did not reach y = 1/2: {tail.message}")
    if not front.success:
        return Run(message=f"solve_ivp stopped: {front.message}")
    work = {"right_hand_sides": tail.nfev + front.nfev}
    return Run(fields(states), **watch.times, **work)


def _run_bvp(mu, s, tolerance):
    """Solve by collocation of fourth order on both sides of y(0) = ½."""
    p = np.linspace(np.log(2.0), BVP_END, FIRST_NODES)
    length = np.trapezoid(1.0 / _tail_slope(p, mu), p)
    lengths = np.array([s[0], max(s[-1], length)])

    def right_hand_side(_, unknowns):
        halves = unknowns.reshape(2, 2, -1)
        rates = [
            length * planar(0.0, half, mu) for length, half in zip(lengths, halves, strict=True)
        ]
        return np.concatenate(rates)

    def conditions(at_zero, at_end):
        y, z = at_end[2:]
        p = -np.log(max(y, 1e-300))
        return np.array(
            [
                at_zero[0] - 0.5,
                at_zero[2] - 0.5,
                at_zero[1] - at_zero[3],
                z + _tail_slope(max(p, 0.0), mu) * y,
            ]
        )

    x = np.linspace(0.0, 1.0, FIRST_NODES)
    rate = 1.0 / (1.0 + mu)
    guesses = [0.5 * (1.0 - np.tanh(rate * length * x)) for length in lengths]
    slopes = [-2.0 * rate * y * (1.0 - y) for y in guesses]
    guess = np.array([guesses[0], slopes[0], guesses[1], slopes[1]])
    with Stopwatch() as watch:
        answer = solve_bvp(
            right_hand_side, conditions, x, guess, tol=tolerance, max_nodes=MOST_NODES
        )
        left = answer.sol(s[s < 0.0] / lengths[0])[:2]
        right = answer.sol(s[s >= 0.0] / lengths[1])[2:]
    if not answer.success:
        return Run(message=f"solve_bvp stopped: {answer.message}")
    y, slope = np.hstack([left, right])
    return Run({"rescaled_force": y, "slope": slope}, **watch.times, steps=float(answer.x.size))


METHODS = {
    "scipy_dop853": partial(_run_traced, method="DOP853"),
    "scipy_radau": partial(_run_traced, method="Radau"),
    "scipy_lsoda": partial(_run_traced, method="LSODA"),
    "scipy_dop853_logarithmic": _run_traced_logarithmic,
    "scipy_solve_bvp": _run_bvp,
}
