r"""Pulses in chains of spheres of two or three kinds, and a long-wave theory of them.

One sphere strikes a chain at rest, whose spheres repeat in cells; no damping, α = 3/2.

Speed.  In long waves all contacts of a cell bear the same force F.  Compressions add up to those of
contacts of one stiffness, and masses to those of spheres of one mass,

.. math::

    k^{-2/3} = \langle k_j^{-2/3} \rangle, \qquad m = \langle m_j \rangle, \qquad
    c = H^{-1/4}\,k^{1/3} m^{-1/2} F^{1/6} ,

where F is the largest force of a wave, c its speed in beads, and H the height of the solitary wave
of speed 1 (see `solitary_waves`).  The power 1/6 is exact for any cell, by the scaling of the law.

Width of dimers, :math:`k_j = k`.  With :math:`\theta = (m_1 - m_2)/(m_1 + m_2)` a sphere takes the
length 1 ± θ in a coordinate s of mass, between the contacts on both its sides.  There the forces of
both kinds of contacts are one function G(s), up to third derivatives that differ in sign.  The mean
of the equations of both is, up to sixth derivatives,

.. math:: m\,\partial_t^2 u = G'' + \frac{1 + 3\theta^2}{12}\,G'''' , \qquad G = k\,u^{3/2} ,

that of equal spheres, stretched by :math:`(1 + 3\theta^2)^{1/2}`.  As :math:`m_2 \to 0` the stretch
is 2, and exact, since a cell then moves as one sphere with two contacts in series.

Width means :math:`c \int F\,dt` over the largest F, in units of that of equal spheres, the mean of
the contacts of a cell.  The integral ends where F falls below 0.01 of its largest value.  The error
is the change since half the distance: a pulse must form first, and some go on losing waves.
"""

import math

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from granular_fronts.accuracy import estimate, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_once
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.model.materials import body_of, hertz_stiffness

CELLS = 8  # between the contacts whose times give the speed
STEP = 0.025  # time between two samples, in units of the theory's for one bead at F = 1
FOOT = 0.01  # F over its largest value where a pulse ends
NEWTONS = 10.0  # force at which speeds are given in m/s
METHOD = "change since half the distance"


def strike_dimers(ratios, contact, tolerance):
    """Strike dimers of equal stiffness, for mass ratios.

    On (ratio,): `speed`, c over the theory, and `stretch`, the width, each with its `…_error`;
    `stretch_theory`.
    """
    found = [
        _strike({"mass": {"cell": [1.0, m]}}, np.array([1.0, m]), np.ones(2), contact, tolerance)
        for m in ratios
    ]
    return _dataset("ratio", ratios, found, [stretch_of_dimer(1.0, m) for m in ratios])


def strike_spheres(cells, contact, tolerance):
    """Strike chains of cells of spheres, by their names.

    As `strike_dimers` on (cell,), and `speed_at_10_newtons` in m/s with its error.  The theory of
    the stretch is NaN where a cell has three spheres.
    """
    found, stretches, speeds = [], [], []
    for cell in cells.values():
        bodies = [body_of(words) for words in cell]
        masses = np.array([body.mass for body in bodies])
        stiffness = np.array(
            [hertz_stiffness(*pair) for pair in zip(bodies, bodies[1:] + bodies[:1], strict=True)]
        )
        alike = hertz_stiffness(bodies[0], bodies[0])
        scaled = masses / masses[0], stiffness / alike
        found.append(_strike({"cell": cell}, *scaled, contact, tolerance))
        stretches.append(stretch_of_dimer(*masses) if len(cell) == 2 else math.nan)
        spacing = 2.0 * float(np.mean([body.radius for body in bodies]))
        speeds.append(found[-1][0] * (spacing * speed_of_pulse(masses, stiffness, NEWTONS)))
    dataset = _dataset("cell", list(cells), found, stretches)
    name, meaning = "speed_at_10_newtons", "speed of a pulse of 10 N in m/s"
    return dataset.assign(variable_and_errors(name, "cell", speeds, METHOD, meaning))


def speed_of_pulse(masses, stiffness, force):
    """Return the speed in beads per time of a pulse, by its largest force."""
    mean = np.mean(np.asarray(stiffness) ** (-2.0 / 3.0)) ** -1.5
    height = float(solitary_wave(1.5).u.max())
    return height**-0.25 * mean ** (1.0 / 3.0) * force ** (1.0 / 6.0) / math.sqrt(np.mean(masses))


def stretch_of_dimer(first, second):
    """Return how much wider a long wave is in a dimer than with equal spheres.

    Examples
    --------
    >>> stretch_of_dimer(1.0, 1.0), stretch_of_dimer(1.0, 0.0)
    (1.0, 2.0)
    """
    return math.sqrt(1.0 + 3.0 * ((first - second) / (first + second)) ** 2)


def _dataset(dim, names, found, stretches):
    speeds, widths = zip(*found, strict=True)
    variables = variable_and_errors("speed", dim, speeds, METHOD, "speed over that of the theory")
    variables |= variable_and_errors("stretch", dim, widths, METHOD, "width over equal spheres")
    exact = {"long_name": "width by the theory", "error_estimate": 1e-15, "error_method": "formula"}
    variables["stretch_theory"] = dim, np.array(stretches), exact
    return xr.Dataset(variables, {dim: names})


def _strike(beads, masses, stiffness, contact, tolerance):
    """Return the speed over theory and the stretch at a contact, each an `Estimate`."""
    places = [cell - cell % masses.size for cell in (contact // 2, contact)]
    unit = 1.0 / speed_of_pulse(masses, stiffness, 1.0)
    end, step = 2.0 * contact * unit, STEP * unit
    probes = {}
    for place in places:
        first = list(range(place, place + masses.size))
        beyond = [one + CELLS * masses.size for one in first]
        probes[f"n{place}"] = {"beads": first + beyond, "start": 0.0, "stop": end, "step": step}
    scene = {
        "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.0},
        "beads": {"count": contact + 2 * CELLS * masses.size, **beads},
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": {"kind": "striker", "beads": 1, "velocity": 1.0},
        "end_time": end,
        "tolerance": tolerance,
        "record": {"snapshots": [], "probes": probes},
    }
    motion = simulate_once(scene, "struck")
    half, far = (_read(motion, place, masses, stiffness) for place in places)
    return [estimate(one, other) for one, other in zip(far, half, strict=True)]


def _read(motion, place, masses, stiffness):
    """Return the speed over theory, and the stretch, in the cell after a contact."""
    times, series = motion[f"t_n{place}"].values, motion[f"relative_displacement_n{place}"].values
    # Contact n is between the spheres n and n + 1, the first of the cell sphere 1.
    factors = np.roll(stiffness, 1 - place % masses.size)
    forces = np.tile(factors, 2) * np.maximum(series, 0.0) ** 1.5
    peaks, tops, durations = np.array([_pulse(times, one) for one in forces.T]).T
    cell = masses.size
    speed = CELLS * cell**2 / (peaks[cell:] - peaks[:cell]).sum()
    force = tops.mean()
    equal = solitary_wave(1.5, 64)
    *_, duration = _pulse(equal.xi, np.maximum(equal.u, 0.0) ** 1.5)
    width = speed * durations[:cell].mean() / duration
    return speed / speed_of_pulse(masses, stiffness, force), width


def _pulse(times, force):
    """Return when a force is largest, its largest value, and its integral over that."""
    top = int(np.argmax(force))
    near = slice(top - 4, top + 5)
    spline = CubicSpline(times[near], force[near])
    turns = spline.derivative().roots(extrapolate=False)
    turn = turns[np.argmax(spline(turns))]
    largest = float(spline(turn))
    end = top + int(np.argmax(force[top:] < FOOT * largest))
    last = np.interp(-FOOT * largest, -force[end - 1 : end + 1], times[end - 1 : end + 1])
    whole = CubicSpline(times[: end + 1], force[: end + 1]).integrate(times[0], last)
    return turn, largest, float(whole) / largest


def number(found, name, **place):
    """Return a number at a place."""
    return tabulated(found.sel(place), name)


def stretch_over_theory(found, **place):
    """Return the stretch of a chain over that of the theory."""
    return number(found, "stretch", **place) * (1.0 / float(found["stretch_theory"].sel(place)))
