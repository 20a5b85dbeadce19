r"""Exact fronts over the plane of exponent and damping, and how far continuum fronts are from them.

In the frame δ = c = 1 a front with :math:`\beta = \alpha` depends only on α and γ.  At each point
of a grid the front is solved and its properties are kept.  Each continuum front of
`granular_fronts.studies.continuum_fronts` is compared with it.  `distance_<front>` is the largest
absolute difference of u over all ξ where either front has not come to rest.
"""

import math

import numpy as np
import xarray as xr
from tqdm.auto import tqdm

from granular_fronts.continuum.log_kdv_burgers.equation import amplitude_of_chain
from granular_fronts.errors import NoFrontError
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.properties import MEASURES
from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.studies.continuum_fronts import (
    HETEROCLINIC,
    LOGARITHMIC,
    UNLIMITED,
    continuum_fronts,
)

POINTS = 8001
"""Points at which two fronts are compared, between where both have come to rest."""

REST = 40.0
"""−ln u of (45) above which it is at rest, far below round-off."""


def survey_fronts(exponents, dampings):
    """Solve a front with δ = c = 1 at each exponent α > 1 and damping γ > 0.

    On (alpha, gamma): what `properties_of` keeps, `converged` (0 or 1) and `reason`; on
    (alpha): `critical_damping`.  Where `converged` is 0, `reason` says why, and the rest is NaN; a
    NoFrontError if no front is found.
    """
    plane = [(alpha, gamma) for alpha in exponents for gamma in dampings]
    points, reasons = [], []
    for alpha, gamma in tqdm(plane, "survey of fronts", unit="front", delay=2.0, disable=None):
        try:
            found = properties_of(solve_converged(alpha, gamma))
            points.append(found | {"converged": 1, "reason": ""})
        except NoFrontError as failure:
            points.append(None)
            reasons.append(str(failure))
    known = next(filter(None, points), None)
    if known is None:
        raise NoFrontError(reasons[0])
    nothing = dict.fromkeys(known, np.nan) | {"converged": 0}
    points = [point or nothing | {"reason": reasons.pop(0)} for point in points]
    shape = len(exponents), len(dampings)
    survey = xr.Dataset(
        coords={"alpha": np.asarray(exponents, float), "gamma": np.asarray(dampings, float)}
    )
    for name in known:
        values = np.array([point[name] for point in points])
        survey[name] = ("alpha", "gamma"), values.reshape(shape)
    survey["critical_damping"] = ("alpha", [critical_damping(alpha) for alpha in exponents])
    return survey


def survey_plane(alpha, gamma):
    """Survey fronts over exponents, a list, and dampings, as of `numpy.geomspace`."""
    return survey_fronts(alpha, np.geomspace(**gamma))


def solve_converged(alpha, gamma):
    """Return a front, or raise a NoFrontError with the reason."""
    front = solve_front(alpha, gamma)
    if not front.attrs["converged"]:
        raise NoFrontError(f"alpha = {alpha}, gamma = {gamma}: {front.attrs['reason']}.")
    return front


def properties_of(front):
    """Return what the survey keeps of a front, as a mapping of numbers."""
    alpha, gamma = front.attrs["alpha"], front.attrs["gamma"]
    root = tail_roots(alpha, gamma, count=1)[0]
    return {
        **{name: front.attrs[name] for name in ("overshoot", *MEASURES)},
        **{name: front.attrs[name] for name in ("speed_defect", "residual")},
        "error": front.attrs["error_estimate"],
        "tail_rate": root.real,
        "tail_frequency": root.imag,
        "mu_heteroclinic": amplitude_of_chain(alpha, gamma).mu,
        **distances(front),
    }


def distances(front):
    """Return largest difference of each continuum front to an exact one, as `distance_<front>`."""
    alpha, gamma = front.attrs["alpha"], front.attrs["gamma"]
    # (45) is the continuum front that comes to rest last.
    last = math.log(REST / math.log(2.0)) * alpha * gamma / (alpha - 1.0)
    xi = np.linspace(front["xi"].values[0], max(front["xi"].values[-1], last), POINTS)
    exact = evaluate_front(front, xi)
    approximations = continuum_fronts(alpha, gamma, xi)
    return {
        f"distance_{name}": float(np.abs(approximations[name][0] - exact).max())
        for name in (LOGARITHMIC, UNLIMITED, HETEROCLINIC)
    }
