r"""What an experimenter reads off recorded series: pulses and their time of flight.

A series is a variable of a motion along time at several places, such as `contact_force_S` of a
sensor S (`sensors`).  It has J samples at equal steps h, and the error ε of its values.

Pulses.  A spline of degree 5 runs through the samples.  It errs by :math:`O(h^6)` where the series
is smooth.  A pulse is a maximum that rises above its surroundings, by a given share of the
largest deviation from the start (its *prominence*).  The level half-way between the value
:math:`s_0` at the start and the peak :math:`s_p` is

.. math:: \ell = \tfrac12 (s_0 + s_p) .

A pulse *arrives* where the series rises through this level, and its *width* is the time above it.

Errors of pulses.  Everything is measured again on every other sample.  The change exceeds the error
of sampling, by about 2⁶ where the series is smooth.  Errors of the series move the peak and the
level by at most ε each, and so a passage of the level by :math:`2\varepsilon/|\dot s|`.  The change
of the peak counts for passages too, over the slope, since two passages may agree by chance.
All of these are bounds from above, usually 5 to 200 times the true errors.

Time of flight is the difference of the first arrivals at two places.
"""

import math

import numpy as np
import xarray as xr
from scipy.interpolate import PPoly, make_interp_spline
from scipy.signal import find_peaks

from granular_fronts import arguments
from granular_fronts.accuracy import Estimate, estimate, variable_and_errors
from granular_fronts.errors import InputError

PROMINENCE = 0.1
"""Share of the largest deviation that a pulse rises above its surroundings."""

DEGREE = 5
LEAST_SAMPLES = 4 * (DEGREE + 1)
"""Samples of a series, so that a spline runs through every other one too."""

SAMPLING = "change with every other sample, and the error of the series"


def pulses(series: xr.DataArray, prominence: float = PROMINENCE) -> xr.Dataset:
    """Measure the pulses of a recorded series: arrival, peak and width of each.

    Parameters
    ----------
    series : xarray.DataArray
        Samples along time at several places, such as ``motion["contact_force_near"]``.
    prominence : float, optional
        Part of the largest deviation from the start that a pulse rises above its surroundings.
        Range 0 to 1.

    Returns
    -------
    xarray.Dataset
        `arrival`, `peak` and `width` on (pulse, place), in the order of time, and the error of each
        number, such as `peak_error`, a bound that is usually 5 to 200 times the true error.  They
        are NaN where a place has fewer pulses, or where half of the height is not passed.

    Raises
    ------
    InputError
        If the series has too few samples, no evenly spaced ones forward in time, or no numbers.

    Examples
    --------
    >>> t = np.linspace(0.0, 20.0, 401)
    >>> force = xr.DataArray(
    ...     np.exp(-((t - 8.0) ** 2))[:, None],
    ...     {"t": t, "contact": [5]},
    ...     ("t", "contact"),
    ...     attrs={"error_estimate": 0.0},
    ... )
    >>> round(gf.pulses(force)["width"].item(), 6)  # 2 (ln 2)^(1/2)
    1.665109
    """
    share = arguments.scalar("prominence", prominence, above=0.0, most=1.0)
    series = _checked(series)
    _, place = series.dims
    found = [_pulses_of(series.isel({place: index}), share) for index in range(series.sizes[place])]
    numbers = np.full((3, max(1, *map(len, found)), len(found), 2), (math.nan, 0.0))
    for index, column in enumerate(found):
        if column:
            numbers[:, : len(column), index] = np.swapaxes(column, 0, 1)
    words = {
        "arrival": "time at which a pulse rises through half of its height",
        "peak": "largest value of a pulse",
        "width": "time that a pulse spends above half of its height",
    }
    variables: dict = {}
    for (name, meaning), of in zip(words.items(), numbers, strict=True):
        variables |= variable_and_errors(name, ("pulse", place), of, SAMPLING, meaning)
    pulse = 1 + np.arange(numbers.shape[1])
    return xr.Dataset(variables, {"pulse": pulse, place: series[place]})


def _checked(series):
    """Return a series along time at several places, with its error; a single place counts too."""
    series = arguments.instance("series", series, xr.DataArray, "give a variable of a motion")
    if series.ndim == 1:
        series = series.expand_dims("place", 1)
    if series.ndim != 2 or "error_estimate" not in series.attrs:
        raise InputError(
            f"series has dimensions {series.dims} and attributes {list(series.attrs)}, but must "
            "be one along time and places with its error_estimate: give a variable of a motion."
        )
    error = arguments.scalar("series.error_estimate", series.attrs["error_estimate"], least=0.0)
    values = arguments.array("series", series.values)
    times = arguments.sequence("series along time", series[series.dims[0]].values)
    steps = np.diff(times)
    even = times.size > 1 and np.allclose(steps, steps[0], rtol=1.0e-6, atol=0.0) and steps[0] > 0.0
    if times.size < LEAST_SAMPLES or not even:
        raise InputError(
            f"series has {times.size} samples, at steps of {steps.min(initial=np.inf):g} to "
            f"{steps.max(initial=-np.inf):g}, but must have {LEAST_SAMPLES} or more at equal "
            "steps forward in time: record a sensor or a grid."
        )
    return series.copy(data=values).assign_attrs(error_estimate=error)


def _pulses_of(series, share=PROMINENCE):
    """Return arrival, peak and width, as estimates, of each pulse at one place."""
    times, values = series[series.dims[0]].values, series.values
    height, error = values - values[0], series.attrs["error_estimate"]
    if not height.max() > error:
        return []
    curves = {
        k: PPoly.from_spline(make_interp_spline(times[::k], values[::k], DEGREE)) for k in (1, 2)
    }
    found = []
    for near in times[find_peaks(height, prominence=share * height.max())[0]]:
        own, other = (
            _measure(curve, near, k * (times[1] - times[0]), values[0])
            for k, curve in curves.items()
        )
        rise, _, width = own
        moved = [
            (2.0 * error + abs(own[1] - other[1])) / abs(float(curves[1](time, 1)))
            for time in (rise, rise + width)
        ]
        errors = moved[0], error, sum(moved)
        found.append([_certain(*numbers) for numbers in zip(own, other, errors, strict=True)])
    return found


def _measure(curve, near, reach, start):
    """Return where a curve rises through half the height of a peak, the peak, and its width."""
    turns = curve.derivative().roots(extrapolate=False)
    turns = turns[np.abs(turns - near) <= reach]
    if not turns.size:
        return (math.nan,) * 3
    top = turns[np.argmax(curve(turns))]
    peak = float(curve(top))
    passages = curve.solve(0.5 * (start + peak), extrapolate=False)
    before, after = passages[passages < top], passages[passages > top]
    rise = before[-1] if before.size else math.nan
    return rise, peak, after[0] - rise if after.size else math.nan


def _certain(own, other, error):
    """Return an estimate from both measurements, of infinite error if only one found it."""
    if math.isnan(own):
        return Estimate(math.nan, 0.0)
    if math.isnan(other):
        return Estimate(own, math.inf)
    return estimate(own, other) + Estimate(0.0, error)


def time_of_flight(series, start, stop):
    """Return the time from the first arrival at one place to that at another, an `Estimate`."""
    series = _checked(series)
    _, place = series.dims
    first, last = (_pulses_of(series.sel({place: number})) for number in (start, stop))
    return last[0][0] - first[0][0] if first and last else Estimate(math.nan, 0.0)
