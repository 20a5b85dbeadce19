r"""What an experimenter reads off recorded series: pulses, their decay, time of flight, a spectrum.

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

Decay.  The peaks :math:`s_n > 0` at the places n are compared with

.. math:: s_n = A\,e^{-\lambda n}, \qquad s_n = A\,n^{-\lambda},

by least squares of :math:`\ln s_n`.  The residual is the root mean square of what is left of
:math:`\ln s_n`: the form that fits has the smaller one.  The fit is linear in :math:`\ln s_n`, with
a matrix M.  The errors of λ and :math:`\ln A` are twice their standard errors and
:math:`-\sum_n |M_{\cdot n}| \ln(1 - \varepsilon/s_n)`, which errors of the peaks add in the worst
case.

Time of flight is the difference of the first arrivals at two places.

Spectrum.  With the window of Hann, :math:`h_j = \sin^2(\pi j/J)`, the amplitude at the frequency
:math:`f_k = k/(Jh)`, in cycles per unit of time, is

.. math:: a_k = 2\,\Bigl|\sum_j h_j (s_j - \bar s)\, e^{-2\pi i jk/J}\Bigr| \Big/ \sum_j h_j .

A sine of one of these frequencies and of amplitude A gives A, but for the first and the last one.
Two sines can be distinguished if their frequencies differ by more than the resolution,
:math:`2/(Jh)`.  It is the width at half its height of the window's main lobe.  Amplitudes err by at
most 4ε, of which the mean adds half.
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
OF_SERIES = "error of the series"
OF_FIT = "twice the standard error of the fit, and the errors of the peaks"


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
        number, such as `peak_error`.  They are NaN where a place has fewer pulses, or where half of
        the height is not passed.

    Raises
    ------
    InputError
        If the series has too few samples, or no evenly spaced ones.

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
    times = arguments.sequence("series along time", series[series.dims[0]].values)
    steps = np.diff(times)
    if times.size < LEAST_SAMPLES or not np.allclose(steps, steps[0], rtol=1.0e-6, atol=0.0):
        raise InputError(
            f"series has {times.size} samples, at steps of {steps.min(initial=np.inf):g} to "
            f"{steps.max(initial=-np.inf):g}, but must have {LEAST_SAMPLES} or more at equal "
            "steps: record a sensor or a grid."
        )
    return series


def _pulses_of(series, share=PROMINENCE):
    """Return arrival, peak and width, as estimates, of each pulse at one place."""
    times, values = series[series.dims[0]].values, series.values
    height, error = values - values[0], float(series.attrs["error_estimate"])
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
    _, place = _checked(series).dims
    first, last = (_pulses_of(series.sel({place: number})) for number in (start, stop))
    return last[0][0] - first[0][0] if first and last else Estimate(math.nan, 0.0)


def peak_decay(peaks: xr.DataArray) -> xr.Dataset:
    """Fit an exponential and a power to peaks along the chain.

    Parameters
    ----------
    peaks : xarray.DataArray
        Peaks at three or more beads or contacts, all above 0, such as ``motion["first_peak"]`` or
        ``gf.pulses(series)["peak"].sel(pulse=1)``; NaN is left out.

    Returns
    -------
    xarray.Dataset
        On `form`, which is ``exponential`` or ``power``: the decay λ (`rate`), the logarithm of A
        (`log_amplitude`) and `residual`.  Each has its error, such as `rate_error`.

    Raises
    ------
    InputError
        If fewer than three peaks are there, or one is not above its error.

    Examples
    --------
    >>> n = np.arange(1, 21)
    >>> peaks = xr.DataArray(
    ...     0.5 * np.exp(-0.02 * n), {"bead": n}, ("bead",), attrs={"error_estimate": 1e-9}
    ... )
    >>> round(gf.peak_decay(peaks)["rate"].sel(form="exponential").item(), 9)
    0.02
    """
    peaks = arguments.instance("peaks", peaks, xr.DataArray, "give a variable along the chain")
    if peaks.ndim != 1 or "error_estimate" not in peaks.attrs:
        raise InputError(
            f"peaks has dimensions {peaks.dims} and attributes {list(peaks.attrs)}, but must be "
            "one along the chain with its error_estimate: give first_peak of a motion."
        )
    [place] = peaks.dims
    peaks = peaks.dropna(place)
    if peaks.size < 3 or not (peaks > peaks.attrs["error_estimate"]).all():
        raise InputError(
            f"peaks has {peaks.size} numbers, the smallest of them {peaks.min().item():g}, but "
            "three or more above their error are needed: leave out places that no pulse reaches."
        )
    numbers = peaks[place].values
    errors = -np.log1p(-peaks.attrs["error_estimate"] / peaks.values)
    fits = [_fit(x, np.log(peaks.values), errors) for x in (numbers, np.log(numbers))]
    words = {
        "rate": "decay per place, or exponent of a power",
        "log_amplitude": "logarithm of the amplitude at the place 0, or 1 of a power",
        "residual": "root mean square of the logarithms of the peaks less those of the fit",
    }
    variables: dict = {}
    for (name, meaning), of in zip(words.items(), zip(*fits, strict=True), strict=True):
        variables |= variable_and_errors(name, "form", of, OF_FIT, meaning)
    return xr.Dataset(variables, {"form": ["exponential", "power"]})


def _fit(x, logarithms, errors):
    """Return λ, ln A and residual of ln A − λx, as estimates."""
    design = np.column_stack([-x, np.ones_like(logarithms)])
    matrix = np.linalg.pinv(design)
    found = matrix @ logarithms
    left = logarithms - design @ found
    spread = np.sqrt(left @ left / (x.size - 2) * (matrix**2).sum(axis=1))
    of_both = 2.0 * spread + np.abs(matrix) @ errors
    residual = Estimate(np.sqrt(np.mean(left**2)), np.sqrt(np.mean(errors**2)))
    return *map(Estimate, found, of_both), residual


def spectrum(series: xr.DataArray) -> xr.Dataset:
    """Return the amplitudes of the frequencies that a recorded series holds.

    Parameters
    ----------
    series : xarray.DataArray
        As of `pulses`; ``motion["velocity_grid"]`` is one too.

    Returns
    -------
    xarray.Dataset
        `amplitude` on (frequency, place), of sines in the window of Hann; frequencies are in cycles
        per unit of time.  The attribute `resolution` is the distance of two of them that can be
        distinguished.

    Raises
    ------
    InputError
        If the series has too few samples, or no evenly spaced ones.

    Examples
    --------
    >>> t = 0.05 * np.arange(400)
    >>> sine = xr.DataArray(
    ...     0.3 * np.sin(2 * np.pi * 1.5 * t), {"t": t}, ("t",), attrs={"error_estimate": 0.0}
    ... )
    >>> found = gf.spectrum(sine)
    >>> amplitude = found["amplitude"].squeeze()
    >>> round(amplitude.idxmax().item(), 6), round(amplitude.max().item(), 6)
    (1.5, 0.3)
    """
    series = _checked(series)
    along, place = series.dims
    times, count = series[along].values, series.sizes[along]
    step = (times[-1] - times[0]) / (count - 1)
    window = np.sin(np.pi * np.arange(count) / count)[:, None] ** 2
    waves = np.fft.rfft(window * (series.values - series.values.mean(axis=0)), axis=0)
    attributes = {
        "long_name": "amplitude of a frequency",
        "error_estimate": 4.0 * float(series.attrs["error_estimate"]),
        "error_method": OF_SERIES,
    }
    return xr.Dataset(
        {"amplitude": (("frequency", place), 2.0 * np.abs(waves) / window.sum(), attributes)},
        {"frequency": np.fft.rfftfreq(count, step), place: series[place]},
        {"resolution": float(2.0 / (count * step))},
    )
