r"""The heteroclinic orbit of the logarithmic KdV–Burgers equation, James (2021), section 5.2.

The front y_h(s) of (56) runs from 1 at :math:`s \to -\infty` to 0 at :math:`s \to +\infty`, with
y_h(0) = ½.  For μ < 12 it is traced by Taylor series (`traced_orbit`), for μ ≥ 12 it is known in
closed form (`slow_manifold`).  Both give :math:`p = -\ln y` and :math:`v = p'`, hence y and
:math:`y' = -vy`, with relative accuracy of p down the super-exponential tail to the last double
above zero.  For μ = 0 the orbit is the homoclinic Gaussian of Remark 8, and y falls to 0 on both
sides.

Turning points.  For 0 < μ < 2 the front oscillates about 1.  Each extremum is a zero of v, located
on the series.  Its deviation y − 1 is known with relative accuracy, so that turns are resolved down
to one unit of the last digit of 1.

Accuracy.  The same orbit is computed again, by series of another order with other steps, or with
fewer terms of the expansion.  The largest difference is the error estimate of each variable; where
it vanishes, the last digit replaces it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.accuracy import EPSILON, error_attributes, with_refinement
from granular_fronts.arguments import sequence
from granular_fronts.continuum.log_kdv_burgers.equation import (
    CRITICAL_DAMPING,
    check_mu,
    linear_rates,
)
from granular_fronts.continuum.log_kdv_burgers.slow_manifold import (
    FEWER_TERMS,
    STIFF_DAMPING,
    TERMS,
    slow_orbit,
)
from granular_fronts.continuum.log_kdv_burgers.taylor import REST
from granular_fronts.continuum.log_kdv_burgers.traced_orbit import (
    FINER_STEPS,
    USUAL_STEPS,
    Accuracy,
    trace_orbit,
)
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import name_variables

if TYPE_CHECKING:
    import numpy.typing as npt

UNDERFLOW_P = 1074.0 * math.log(2.0)
"""−ln of the smallest double above zero: the end of the tail."""

ACCEPTED_ERROR = 1e-12
"""Error estimate of y up to which the orbit is called converged."""

DEFAULT_POINTS = 1001
TAIL_P = 37.0
MOST_DEFAULT_TURNS = 12

NEARLY_ONE = 1e-18
"""The −ln y from which on squares are below the last digit of an orbit for μ < 2."""

# Beyond this many e-foldings from y = ½ the orbit rests, for μ = 2 after an algebraic factor too.
REST_DECAY = 60.0

ERROR_METHODS = {
    "series": "largest difference to Taylor series of order {0.order} with other steps",
    "expansion": f"largest difference to the expansion with {FEWER_TERMS} terms",
}


class Resolution(NamedTuple):
    """How an orbit is computed, by Taylor series or by the expansion."""

    steps: Accuracy
    terms: int


USUAL, FINER = Resolution(USUAL_STEPS, TERMS), Resolution(FINER_STEPS, FEWER_TERMS)


def heteroclinic(mu: float, s: npt.ArrayLike | None = None) -> xr.Dataset:
    """Return the front y_h(s) and its slope, with y_h(0) = ½.

    Parameters
    ----------
    mu : float
        Damping μ of (54), 0 or from 1e-280 to 1e280.
    s : array_like, shape (points,), optional
        Where to evaluate it.  Without it, 1001 points between the places where 1 − y and where y
        have decayed to round-off; of an oscillating front at most 12 extrema.

    Returns
    -------
    xarray.Dataset
        `rescaled_force` y, `slope` y', `log_rescaled_force` ln y on `s`; `overshoot` y − 1 and
        `turning_point` (its s) on `turn`, for the extrema in the range of s, the first maximum
        first.  Each variable has `error_estimate` and `error_method`, ln y also
        `relative_error_estimate` (over y ≤ ½); the dataset has mu, converged, method and counts.

    Raises
    ------
    InputError
        If mu is out of range, or s is not a finite list of numbers. If s reaches beyond
        the underflow of y, or over more turns than can be followed.

    Examples
    --------
    >>> orbit = gf.heteroclinic(0.3)
    >>> orbit["overshoot"].values[:2].round(6)
    array([ 0.392557, -0.272794])
    """
    mu = check_mu(mu)
    s = None if s is None else sequence("s", s, advice="leave that point out")
    first = min(_first_of_default(mu) if s is None else float(s.min()), 0.0)
    orbits = with_refinement(lambda resolution: compute_orbit(mu, first, resolution), USUAL, FINER)
    orbit = orbits.usual
    if s is None:
        s = np.linspace(first, orbit.s_at(TAIL_P), DEFAULT_POINTS)
    _check_underflow(mu, s, orbit)
    values, others = orbits.map(lambda each: _profile(each, s))
    turns, other_turns = orbits.map(lambda each: _turns(each, first))
    common = min(turns[0].size, other_turns[0].size)
    method = _error_method(mu)
    variables = {
        name: ("s", value, error_attributes(value, other, method))
        for name, value, other in zip(_PROFILE, values, others, strict=True)
    } | {
        name: ("turn", value, error_attributes(value[:common], other[:common], method))
        for name, value, other in zip(_TURNS, turns, other_turns, strict=True)
    }
    logarithm, ahead = variables["log_rescaled_force"], s >= 0.0
    relative = np.max(np.abs(1.0 - others[2][ahead] / values[2][ahead]), initial=0.0)
    # Two orbits of strong damping share their rounding, of a few units of the last digit.
    logarithm[2]["relative_error_estimate"] = max(float(relative), 4.0 * EPSILON)
    error = variables["rescaled_force"][2]["error_estimate"]
    return name_variables(
        xr.Dataset(
            variables,
            coords={"s": s, "turn": np.arange(1, turns[0].size + 1)},
            attrs={"mu": mu, "converged": int(error <= ACCEPTED_ERROR), **orbit.counts()},
        )
    )


_PROFILE = ("rescaled_force", "slope", "log_rescaled_force")
_TURNS = ("turning_point", "overshoot")


def turning_points(mu):
    """Return s and y − 1 of all extrema of the front that double precision resolves, s decreasing.

    None for μ ≥ 2, one maximum for μ = 0; their number grows like 23/μ, and for μ below 0.001
    there are too many to follow, which is an InputError.
    """
    mu = check_mu(mu)
    # Without damping there is one turn, the maximum.
    first = -math.inf if mu > 0.0 else -4.0
    return _turns(compute_orbit(mu, first), first)


def compute_orbit(mu, first, resolution=USUAL):
    """Return the orbit by the method that suits μ, from an s of at most 0 on, `first`.

    Either method evaluates p and v at given s, and knows its tail and turning points.
    """
    # A whole number would have every kernel compiled again.
    mu = float(mu)
    if mu >= STIFF_DAMPING:
        return slow_orbit(mu, resolution.terms)
    return trace_orbit(mu, first, resolution.steps)


def squared_slope_at_one(mu):
    """Return q(1), where q = y'² over y obeys dq/dy = −2 (μ sign(q) |q|^(1/2) + y ln|y|), (59).

    It is the square of y' where y first reaches 1 from the foot.  For μ < 2 it is positive, though
    it falls below every double as μ → 2; from `NEARLY_ONE` on the orbit is that of the linear
    system at (1, 0).  For μ ≥ 2 the orbit does not reach 1, and q is taken where it rests, far
    below the last digit of y.
    """
    mu = check_mu(mu)
    if mu >= STIFF_DAMPING:
        orbit = slow_orbit(mu)
        return _squared_slope(orbit, orbit.s_at(REST))
    orbit = compute_orbit(mu, _before_crossing(mu))
    if mu >= CRITICAL_DAMPING:
        return _squared_slope(orbit, orbit.s_at(0.0))
    (p,), (v,) = orbit.evaluate(np.array([orbit.s_at(NEARLY_ONE)]))
    frequency, rest = linear_rates(mu)[1].imag, v - 0.5 * mu * p
    phase = math.atan2(frequency * p, rest)
    return math.hypot(frequency * p, rest) ** 2 * math.exp(-mu * phase / frequency)


def _squared_slope(orbit, s):
    """Return y'² at one s."""
    (p,), (v,) = orbit.evaluate(np.array([s]))
    return float((v * math.exp(-p)) ** 2)


def _before_crossing(mu):
    """Return an s before which the orbit has crossed y = 1 or rests there."""
    return -4.0 - min(_half_turn(mu), _decay_length(mu, REST_DECAY))


def _half_turn(mu):
    """Return the distance of two extrema near y = 1, without end if there are none."""
    frequency = abs(linear_rates(mu)[0].imag)
    return math.pi / frequency if frequency else math.inf


def _decay_length(mu, exponent):
    """Return the length over which y − 1 falls by e^(−exponent) towards small s."""
    rate = linear_rates(mu)[0].real
    return exponent / rate if rate else math.inf


def _first_of_default(mu):
    """Start of the default range: 1 − y at round-off, but at most some turns away."""
    if mu == 0.0:
        return 2.0 * gaussian_centre() - trace_orbit(mu, 0.0).s_at(TAIL_P)
    return -min(_decay_length(mu, TAIL_P), 2 * MOST_DEFAULT_TURNS * _half_turn(mu))


def gaussian_centre():
    """Return the s of the maximum for μ = 0, where y = exp(½ − (s − centre)²/4) and y(0) = ½."""
    return -2.0 * math.sqrt(0.5 + math.log(2.0))


def _check_underflow(mu, s, orbit):
    """Raise an InputError where y is below the smallest double above zero."""
    last = orbit.s_at(UNDERFLOW_P)
    if s.max() > last:
        raise InputError(
            f"s reaches to {s.max():.17g}, but for mu = {mu} y falls below the smallest double, "
            f"4.9e-324, at s = {last:.6f}: let s end there or earlier."
        )
    first = 2.0 * gaussian_centre() - last
    if mu == 0.0 and s.min() < first:
        raise InputError(
            f"s reaches to {s.min():.17g}, but without damping y falls below the smallest double, "
            f"4.9e-324, at s = {first:.6f} too: let s begin there or later."
        )


def _profile(orbit, s):
    """Return y, y' and ln y at each s."""
    p, v = orbit.evaluate(s)
    y = np.exp(-p)
    return y, -v * y, -p


def _turns(orbit, first):
    """Return positions and y − 1 of the turning points that are resolved and not before `first`."""
    s, p = orbit.turning_points()
    overshoot = np.expm1(-p)
    # Below the last digit of 1 a deviation y − 1 is not resolved.
    keep = (np.abs(overshoot) >= EPSILON) & (s >= first)
    return s[keep], overshoot[keep]


def _error_method(mu):
    kind = "expansion" if mu >= STIFF_DAMPING else "series"
    return ERROR_METHODS[kind].format(FINER_STEPS)
