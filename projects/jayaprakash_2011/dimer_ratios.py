r"""Mass ratios at which a dimer carries a wave unchanged, and at which it attenuates a pulse most.

Beads of the masses 1 and ε alternate, without damping and without precompression.

*Antiresonances.*  In a wave that leaves nothing behind, the contacts of cell j, on both sides of
its light bead, have the compressions u(t − j) and u(j − t).  The time from cell to cell is 1, and t
is reversed by the reflection of the chain.  Hence

.. math::

    \ddot u(t) = F(u(-t-1)) - F(u(t)) - \frac{F(u(t)) - F(u(-t))}{\varepsilon} =: g(t), \qquad
    F(u) = u_+^\alpha .

The integral of g vanishes by symmetry.  That u tends to 0 on both sides also takes

.. math:: \int t\,g\,dt = 0, \qquad \hat u(\omega) = -\hat g(\omega)/\omega^2, \qquad
          \hat u(0) = \tfrac12 \int t^2 g\,dt .

The first equation is one for ε, which holds for single ε only.  Newton's method solves all of it
for u and ε on a grid.  u decays super-exponentially and stays positive, so that trapezoidal sums
converge exponentially.  Equal masses are the antiresonance ε = 1.

*Attenuation.*  A striker hits the chain.  Its pulse soon loses the same share with each cell, since
the chain has no scale of its own, until other waves overtake it.  Light beads ring behind the
pulse.  Their velocity has a simple zero at an antiresonance, so that the rate a of attenuation has
a double one, and the lines through ±√a cross there.  This finds it again, by the chain alone.  A
*resonance* is a largest a.

*Spacing.*  As ε → 0 heavy beads move as if each second contact had the force F(w/2).  Each light
bead oscillates about its middle place with :math:`\omega^2 = 4\alpha U^{\alpha-1}/\varepsilon`,
where U is the solitary wave of speed 1.  One more oscillation within the wave leads from an
antiresonance to the next one, and :math:`\varepsilon^{-1/2}` grows by

.. math:: \pi \Big/ \Bigl(\sqrt\alpha \int U^{(\alpha-1)/2} d\xi\Bigr) .

Errors.  ε by Newton's method: a finer grid, and rounding.  By the chain: the lines through other
points.  Rates and resonances: other cells, and half the steps.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize_scalar

from granular_fronts.accuracy import EPSILON, Estimate, rounded, tabulated, variable_and_errors
from granular_fronts.chain.measures import peak_decay
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.studies.strikers import struck_chain

ALPHA = 1.5
"""Exponent of beads."""

POINTS = 32, 48
"""Points of a cell on the usual and the finer grid."""

HALF_PERIOD = 4
"""Cells from the middle of the wave to the end of the grid; u is below 1e-100 there."""

ITERATIONS = 30
SETTLED = 1e-13
"""Largest change of u over its largest value."""

LARGEST = 10.0
"""Mass ratio beyond which Newton's method has gone astray."""

SOUGHT = 1e-5
"""How far in ε^(−1/2) the place of a largest attenuation is sought."""

SHOWN = np.linspace(-2.0, 2.0, 401)
"""Times at which waves are kept, in units of the time from cell to cell."""

AHEAD, PER_CELL = 12, 2.9
"""Beads beyond the last cell, and a time in which every pulse crosses one."""


class DimerWave(NamedTuple):
    """A wave that leaves nothing behind: mass ratio, times, and u of a heavy bead's contact."""

    ratio: float
    t: np.ndarray
    u: np.ndarray


def times_of(points):
    """Return the grid of a wave; the time from cell to cell is 1."""
    return np.arange(-points * HALF_PERIOD, points * HALF_PERIOD) / points


def solve_wave(alpha, ratio, u, points):
    """Return the wave and its mass ratio by Newton's method, from a guess u at `times_of(points)`.

    Raises
    ------
    SolveError
        If the guess is too far from a wave.
    """
    t, size = times_of(points), u.size
    reflected, shifted = -np.arange(size) % size, (-np.arange(size) - points) % size
    omega = 2.0 * np.pi * np.fft.rfftfreq(size, 1.0 / points)
    spectrum = -1.0 / np.where(omega > 0.0, omega, np.inf) ** 2
    twice = np.fft.irfft(spectrum[:, None] * np.fft.rfft(np.eye(size), axis=0), size, axis=0)
    twice += 0.5 * t**2 / size
    for _ in range(ITERATIONS):
        force, slope = np.maximum(u, 0.0) ** alpha, alpha * np.maximum(u, 0.0) ** (alpha - 1.0)
        difference, slopes = force - force[reflected], np.diag(slope)
        g = force[shifted] - force - difference / ratio
        by_u = slopes[shifted] - slopes - (slopes - slopes[reflected]) / ratio
        by_both = np.column_stack([by_u, difference / ratio**2])
        system = np.vstack([np.eye(size, size + 1) - twice @ by_both, t @ by_both])
        try:
            step = np.linalg.solve(system, np.append(twice @ g - u, -t @ g))
        except np.linalg.LinAlgError:
            break
        u, ratio = u + step[:-1], ratio + step[-1]
        if not 0.0 < ratio < LARGEST:
            break
        if np.abs(step).max() < SETTLED * u.max():
            return DimerWave(float(ratio), t, u)
    raise SolveError(
        f"No wave of a dimer was found near the mass ratio {ratio:.4g}: begin at a ratio where the "
        "attenuation is smaller."
    )


def strike(alpha, ratio, cells, tolerance, probes=()):
    """Return the motion of a dimer that a heavy bead hits, long enough for a number of cells."""
    end = PER_CELL * cells
    record = {"snapshots": [], "arrival_level": 1e-3, "extremes": True}
    if probes:
        record["probes"] = {
            "cell": {"beads": probes, "start": 0.0, "stop": end, "step": end / 6000}
        }
    beads = {"count": 2 * cells + AHEAD, "mass": {"cell": [1.0, ratio]}}
    scene = struck_chain((alpha, alpha, 0.0), beads, end, tolerance, record)
    return simulate_chain(scene, f"dimer of mass ratio {ratio:.4g}")


def rates(alpha, ratio, cells, tolerance):
    """Return the attenuation per cell between each two successive ones of some cells."""
    motion = strike(alpha, ratio, cells[-1], tolerance)
    contacts = [2 * cell + 1 for cell in cells]
    return [peak_decay(motion, first, last) * 2.0 for first, last in pairwise(contacts)]


def guess_of_chain(alpha, ratio, cells, tolerance, points):
    """Return u at `times_of(points)` of the pulse in the last cell but three, as a guess."""
    contact = 2 * (cells - 3) + 1
    motion = strike(alpha, ratio, cells, tolerance, [contact, contact + 1])
    peaks = motion["first_peak_time"]
    passage = float(peaks.sel(bead=contact + 2) - peaks.sel(bead=contact))
    times = motion["t_cell"].values
    u = np.maximum(motion["relative_displacement_cell"].values, 0.0)
    u[abs(times - float(peaks.sel(bead=contact))) > 2.0 * passage] = 0.0
    middle = np.mean(times @ u / u.sum(axis=0))
    t = times_of(points)
    value = CubicSpline(times, u[:, 0])(np.clip(middle + passage * t, times[0], times[-1]))
    return np.where(abs(t) < 2.0, value, 0.0) * passage ** (2.0 / (alpha - 1.0))


def find_wave(alpha, ratio, cells, tolerance):
    """Return the wave near a mass ratio, and this ratio with its error."""
    usual, finer = (
        solve_wave(alpha, ratio, guess_of_chain(alpha, ratio, cells, tolerance, points), points)
        for points in POINTS
    )
    return finer, Estimate(finer.ratio, max(abs(finer.ratio - usual.ratio), 16.0 * EPSILON))


def crossing(rate_of, middle, distance):
    """Return where ±√a crosses zero, by lines through points of two distances, with its error."""
    found = []
    for width in (distance, 0.5 * distance):
        low, high = (np.sqrt(abs(rate_of(middle + side * width))) for side in (-1.0, 1.0))
        found.append(middle + width * (low - high) / (low + high))
    return Estimate(found[1], abs(found[1] - found[0]))


def find_ratios(roots, cells, tolerance):
    """Find antiresonances and resonances over ε^(−1/2), `roots` with start, stop and step.

    On (root): `attenuation`, per cell.  On (order): `antiresonance`, `antiresonance_of_chain`, each
    with its `…_error`.  On (order, t): `wave`.  On (resonance_order): `resonance`,
    `resonance_attenuation`, alike.  `spacing` of ε^(−1/2) as ε → 0.
    """
    root = np.arange(roots["start"], roots["stop"], roots["step"])

    def both(place):
        return rates(ALPHA, place**-2.0, cells, tolerance)[-2:]

    scan = [both(place) for place in root]
    late = np.array([pair[1].value for pair in scan])
    turns = np.diff(np.sign(np.diff(late)))
    lows, highs = (1 + np.flatnonzero(turns == side) for side in (2.0, -2.0))
    waves, exact, by_chain = [], [], []
    for low in root[lows]:
        crossed = crossing(lambda place: both(place)[1].value, low, roots["step"])
        wave, ratio = find_wave(ALPHA, crossed.value**-2.0, cells[-1], tolerance)
        waves.append(CubicSpline(wave.t, wave.u)(SHOWN))
        exact.append(ratio)
        by_chain.append(crossed**-2.0)
    places, heights = [], []
    for high in root[highs]:
        early, last = (_largest(both, which, high, roots["step"]) for which in (0, 1))
        error = abs(last[0] ** -2.0 - early[0] ** -2.0) + 2.0 * SOUGHT * last[0] ** -3.0
        places.append(Estimate(last[0] ** -2.0, error))
        heights.append(Estimate(last[1], abs(last[1] - early[1])))
    attenuation = [last + Estimate(0.0, abs((last - early).value)) for early, last in scan]
    variables = {"wave": (("order", "t"), np.array(waves), {"long_name": "u of an antiresonance"})}
    cells_and_steps = "other cells, half the steps"
    for name, dims, found, method, meaning in (
        ("attenuation", "root", attenuation, cells_and_steps, "attenuation of a pulse per cell"),
        ("antiresonance", "order", exact, "a finer grid", "mass ratio of an antiresonance"),
        ("antiresonance_of_chain", "order", by_chain, "other lines", "mass ratio by the chain"),
        ("resonance", "resonance_order", places, "other cells", "mass ratio of a resonance"),
        ("resonance_attenuation", "resonance_order", heights, "other cells", "attenuation there"),
    ):
        variables |= variable_and_errors(name, dims, found, method, meaning)
    last = spacing(ALPHA)
    variables |= variable_and_errors("spacing", (), last, "no faint u", "spacing as ε → 0")
    coordinates = {
        name: (name, values, {"long_name": words})
        for name, values, words in (
            ("root", root, "inverse square root of the mass ratio"),
            ("t", SHOWN, "time over that from cell to cell"),
            ("order", np.arange(1, len(exact) + 1), "number of the antiresonance"),
            ("resonance_order", np.arange(1, len(places) + 1), "number of the resonance"),
        )
    }
    return xr.Dataset(variables, coordinates)


def _largest(both, which, middle, step):
    """Return where a rate is largest near a point of the scan, and its value."""
    found = minimize_scalar(
        lambda place: -both(place)[which].value,
        bounds=(middle - step, middle + step),
        options={"xatol": SOUGHT},
    )
    return found.x, -found.fun


def spacing(alpha):
    """Return by how much ε^(−1/2) grows from one antiresonance to the next as ε → 0.

    u below 1e-13 is rounding and left out; its root is not small, and the error is by 1e-9.
    """
    wave = solitary_wave(alpha, POINTS[0])
    fine, coarse = (
        np.where(wave.u > least, wave.u, 0.0) ** (0.5 * (alpha - 1.0)) for least in (1e-13, 1e-9)
    )
    first, second = (np.pi * POINTS[0] / (np.sqrt(alpha) * part.sum()) for part in (fine, coarse))
    return Estimate(float(first), float(abs(first - second)))


def farthest_by_chain(found):
    """Return the largest distance of an antiresonance by the chain from its wave, over its error.

    Its own error is that of the wave.
    """
    stated = found["antiresonance_of_chain_error"]
    apart = abs(found["antiresonance_of_chain"] - found["antiresonance"]) / stated
    return Estimate(float(apart.max()), float((found["antiresonance_error"] / stated).max()))


def energy_lost(found, order, cells):
    """Return the share of its energy that a pulse loses at a resonance in some cells."""
    power = (ALPHA + 1.0) * cells
    rate = tabulated(found, "resonance_attenuation", resonance_order=order)
    kept = float(np.exp(-power * rate.value))
    return Estimate(1.0 - kept, power * kept * rate.error)


def interlaced(found):
    """Return the least distance of ε^(−1/2) from each ratio to the next of the other kind.

    It is negative if two of one kind follow each other.
    """
    exact, strong = found["antiresonance"].values ** -0.5, found["resonance"].values ** -0.5
    places, kinds = np.append(exact, strong), np.repeat([0, 1], [exact.size, strong.size])
    order = np.argsort(places)
    gaps = np.where(np.diff(kinds[order]) == 0, -1.0, 1.0) * np.diff(places[order])
    errors = 0.5 * found["resonance_error"].values * strong**3
    return Estimate(float(gaps.min()), float(errors.max()))


def last_spacing(found):
    """Return the last distance of two antiresonances in ε^(−1/2) over that as ε → 0."""
    last = found["antiresonance"].values[-2:] ** -0.5
    return rounded(float(last[1] - last[0]), 1e3) / tabulated(found, "spacing")
