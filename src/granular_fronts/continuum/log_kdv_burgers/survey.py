"""From a heteroclinic scene to a dataset: fronts for a list of dampings, and the plane around them.

A scene is the mapping that the configuration holds under `scenes: heteroclinic:`; its keys are
described in `granular_fronts.scenes.orbit`.  Variables of the dataset:

- the fronts: `rescaled_force`, `slope`, `log_rescaled_force` on (mu, s); their extrema in that
  range: `overshoot`, `turning_point` on (mu, turn), NaN where an orbit has fewer;
- what the orbits are near (1, 0), on (mu): `squared_slope_at_one`, `growth_rate` and
  `angular_frequency`. The last two, each with its `_error`, are measured and not computed from μ,
  NaN where they cannot be;
- the double well: `potential` on (y);
- the phase portrait: `rescaled_force_portrait`, `slope_portrait` on (trajectory, s_portrait), NaN
  where a trajectory has left the window.
"""

import math

import numpy as np
import xarray as xr
from scipy.integrate import solve_ivp

from granular_fronts.accuracy import error_attributes, with_refinement
from granular_fronts.continuum.log_kdv_burgers.equation import (
    CRITICAL_DAMPING,
    planar_system,
    potential,
)
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import (
    compute_orbit,
    heteroclinic,
    squared_slope_at_one,
    turning_points,
)
from granular_fronts.numerics.grids import regular_points
from granular_fronts.scenes.orbit import Orbits

# Extrema below this deviation from 1 are linear to round-off when ratios of them are taken.
LINEAR = 1e-9

# Values of 1 − y between which the growth of a monotone front is measured.
FAR, NEAR = 1e-9, 1e-18

# The number of turns down to round-off grows like 23/μ; at smaller μ it would take long.
SMALLEST_MEASURED_MU = 0.01

PORTRAIT_TOLERANCE = 1e-10
PORTRAIT_REFINEMENT = 100.0


def survey_heteroclinic(scene, name="given"):
    """Return the fronts, their approach to (1, 0), and what else figure 8 shows; see the module."""
    scene = Orbits.read(scene, name)
    profile = scene.profile
    s = regular_points(profile.start, profile.stop, profile.step)
    parts = [survey_fronts(scene.mu, s)]
    if scene.well:
        parts.append(_sample_potential(scene.well.limit, scene.well.step))
    if scene.portrait:
        parts.append(_draw_portrait(**dict(scene.portrait)))
    survey = xr.merge(parts, combine_attrs="drop_conflicts")
    survey.attrs["converged"] = min(part.attrs.get("converged", 1) for part in parts)
    return survey


def survey_fronts(dampings, s):
    """Return the fronts for a list of dampings, and how each approaches (1, 0)."""
    fronts = [heteroclinic(mu, s) for mu in dampings]
    mu = xr.DataArray(np.asarray(dampings, dtype=float), dims="mu", name="mu")
    survey = xr.concat(fronts, dim=mu, join="outer", combine_attrs="drop")
    for name, variable in survey.data_vars.items():
        worst = max(fronts, key=lambda front, name=name: front[name].attrs["error_estimate"])
        variable.attrs = {key: worst[name].attrs[key] for key in ("error_estimate", "error_method")}
    squares = np.array([squared_slope_at_one(value) for value in dampings])
    attributes = error_attributes(squares, np.where(mu < CRITICAL_DAMPING, squares, 0.0), "")
    attributes["error_method"] = "one unit of the last digit, or the value itself for μ ≥ 2"
    survey["squared_slope_at_one"] = ("mu", squares, attributes)
    rates = np.array([measure_rates(value) for value in dampings]).T
    for name, values in zip(_RATES, rates, strict=True):
        survey[name] = ("mu", values)
    survey.attrs["converged"] = min(front.attrs["converged"] for front in fronts)
    survey.attrs["steps"] = sum(front.attrs.get("steps", 0) for front in fronts)
    survey.attrs["methods"] = ", ".join(sorted({front.attrs["method"] for front in fronts}))
    return survey


_RATES = ("growth_rate", "growth_rate_error", "angular_frequency", "angular_frequency_error")


def measure_rates(mu):
    """Return growth rate and frequency with which the front leaves (1, 0), and their errors.

    They follow from the last extrema of an oscillating front, or from v/p of a monotone one.
    Errors are the changes since the extrema, or the deviation, before.  NaN where neither is to be
    had: for μ below `SMALLEST_MEASURED_MU`, and next to 2 with fewer than four small extrema.
    """
    nothing = (math.nan,) * 4
    if mu >= CRITICAL_DAMPING:
        orbit = compute_orbit(mu, -100.0 * max(mu, 1.0))
        p, v = orbit.evaluate(np.array([orbit.s_at(FAR), orbit.s_at(NEAR)]))
        before, rate = v / p
        return rate, abs(rate - before), 0.0, 0.0
    if mu < SMALLEST_MEASURED_MU:
        return nothing
    s, overshoot = turning_points(mu)
    small = np.abs(overshoot) < LINEAR
    if small.sum() < 4:
        return nothing
    length = -np.diff(s[small])
    rates = -np.diff(np.log(np.abs(overshoot[small]))) / length
    frequencies = math.pi / length
    return (
        rates[-1],
        np.abs(rates - rates[-1]).max(),
        frequencies[-1],
        np.abs(frequencies - frequencies[-1]).max(),
    )


def _sample_potential(limit, step):
    """Return W on −limit ≤ y ≤ limit."""
    y = regular_points(-limit, limit, step)
    values = potential(y)
    attributes = error_attributes(values, values, "one unit of the last digit")
    return xr.Dataset({"potential": ("y", values, attributes)}, coords={"y": y})


def _draw_portrait(mu, starts, span, step, limit):
    """Return the trajectories of (57) through given points, forwards and backwards in s."""
    after = regular_points(0.0, span, step)
    s = np.concatenate([-after[:0:-1], after])

    def follow(tolerance):
        halves = [
            [_follow_trajectory(mu, start, sign * after, limit, tolerance) for start in starts]
            for sign in (-1.0, 1.0)
        ]
        return np.concatenate([np.asarray(halves[0])[:, :, :0:-1], np.asarray(halves[1])], axis=2)

    portraits = with_refinement(
        follow, PORTRAIT_TOLERANCE, PORTRAIT_TOLERANCE / PORTRAIT_REFINEMENT
    )
    method = f"largest difference to DOP853 at a tolerance divided by {PORTRAIT_REFINEMENT:g}"
    variables = {}
    for i, name in enumerate(("rescaled_force_portrait", "slope_portrait")):
        values, others = portraits.map(lambda portrait, i=i: portrait[:, i])
        attributes = error_attributes(values, others, method)
        variables[name] = (("trajectory", "s_portrait"), values, attributes)
    return xr.Dataset(
        variables,
        coords={"s_portrait": s, "trajectory": np.arange(1, len(starts) + 1)},
        attrs={"portrait_mu": mu},
    )


def _follow_trajectory(mu, start, s, limit, tolerance):
    """Return one trajectory of (57) from s = 0 on, until it leaves the window."""

    def leaves(_s, state, _mu):
        return np.abs(state).max() - limit

    leaves.terminal = True
    found = solve_ivp(
        planar_system,
        (0.0, s[-1]),
        start,
        method="DOP853",
        t_eval=s,
        events=leaves,
        args=(mu,),
        rtol=tolerance,
        atol=tolerance,
    )
    values = np.full((2, s.size), np.nan)
    values[:, : found.t.size] = found.y
    return values
