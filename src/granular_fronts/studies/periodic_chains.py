r"""Pulses in chains of spheres of two or three kinds, and a long-wave theory of them.

One sphere strikes a chain at rest, whose spheres repeat in cells; no damping, α = 3/2.

Speed.  In long waves all contacts of a cell bear the same force F.  Compressions add up to those of
contacts of one stiffness, and masses to those of spheres of one mass,

.. math::

    k^{-2/3} = \langle k_j^{-2/3} \rangle, \qquad m = \langle m_j \rangle, \qquad
    c = H^{-1/4}\,k^{1/3} m^{-1/2} F^{1/6} ,

where c is the speed in beads, and H the height of the solitary wave of speed 1 (see
`solitary_waves`).  The power 1/6 is exact for any cell, by the scaling of the law.  In the chain
the largest forces of the contacts of a cell differ by up to 40 per cent.  F is their mean here.

Width of dimers, :math:`k_j = k`.  With :math:`\theta = (m_1 - m_2)/(m_1 + m_2)` a sphere takes the
length 1 ± θ in a coordinate s of mass, between the contacts on both its sides.  There the forces of
both kinds of contacts are one function G(s), up to third derivatives that differ in sign.  The mean
of the equations of both is, up to sixth derivatives,

.. math:: m\,\partial_t^2 u = G'' + \frac{1 + 3\theta^2}{12}\,G'''' , \qquad G = k\,u^{3/2} ,

that of equal spheres, stretched by :math:`(1 + 3\theta^2)^{1/2}`.  As :math:`m_2 \to 0` the stretch
is 2, and exact, since a cell then moves as one sphere with two contacts in series.

Width at half height means c times the time for which F exceeds half of its largest value.  Only
four cells on both sides count.  It is the mean of the contacts of a cell, in units of that of equal
spheres.  The theory has the factor :math:`(1 + 3\theta^2)^{1/2}` for it, as for any width.

Errors.  A pulse must form first, and some go on losing waves: the change since half the distance.
The change by a spline through every other sample is added.
"""

import math
from functools import cache

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from granular_fronts.accuracy import Estimate, estimate, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_once
from granular_fronts.errors import SolveError
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.model.materials import body_of, hertz_stiffness
from granular_fronts.studies.strikers import struck_chain

CELLS = 8  # between the contacts whose times give the speed
STEP = 0.025  # time between two samples, in units of the theory's for one bead at F = 1
SAME = 1.02  # largest over smallest time between cells, for the contacts of one pulse
NEWTONS = 10.0  # force at which speeds are given in m/s
METHOD = "change since half the distance, and by a spline through every other sample"
READ = {
    "speed_over_theory": "speed over that of the theory by the mean force of a cell",
    "speed_over_theory_by_largest": "speed over that of the theory by the largest force of a cell",
    "spread": "largest force of the contacts of a cell over the smallest",
    "width": "width at half height over that of equal spheres",
    "force_kept": "mean force of a cell over that at half the distance",
}
"""What is read, with its meaning; the force of a contact is its largest one."""


def strike_dimers(ratios, contact, tolerance):
    """Strike dimers of equal stiffness, for mass ratios.

    On (ratio,): `speed_over_theory`, by the mean of the largest forces of the contacts of a cell.
    `speed_over_theory_by_largest`, by the largest of them; `spread`, largest over smallest.
    `force_kept`, the mean over that at half the distance.  `width`; each of these has an `…_error`.
    `width_by_theory`; without dimensions `width_of_equal_spheres`, in beads.

    Raises
    ------
    SolveError
        If a pulse is lost before the contact.
    """
    found = [
        _strike(
            f"of mass ratio {m:g}",
            {"mass": {"cell": [1.0, m]}},
            np.array([1.0, m]),
            np.ones(2),
            contact,
            tolerance,
        )
        for m in ratios
    ]
    return _dataset("ratio", ratios, found, [stretch_of_dimer(1.0, m) for m in ratios])


def strike_spheres(cells, contact, tolerance):
    """Strike chains of cells of spheres, by their names.

    As `strike_dimers` on (cell,), and `speed_at_10_newtons` in m/s with its error, 10 N being the
    mean of the largest forces of the contacts of a cell.  The theory of the width is NaN where a
    cell has three spheres.
    """
    found, widths, speeds = [], [], []
    for name, words in cells.items():
        bodies = [body_of(one) for one in words]
        masses = np.array([body.mass for body in bodies])
        stiffness = np.array(
            [hertz_stiffness(*pair) for pair in zip(bodies, bodies[1:] + bodies[:1], strict=True)]
        )
        alike = hertz_stiffness(bodies[0], bodies[0])
        scaled = masses / masses[0], stiffness / alike
        found.append(_strike(name, {"cell": words}, *scaled, contact, tolerance))
        widths.append(stretch_of_dimer(*masses) if len(words) == 2 else math.nan)
        spacing = 2.0 * float(np.mean([body.radius for body in bodies]))
        theory = spacing * speed_of_pulse(masses, stiffness, NEWTONS)
        speeds.append(found[-1]["speed_over_theory"] * theory)
    dataset = _dataset("cell", list(cells), found, widths)
    name, meaning = "speed_at_10_newtons", "speed of a pulse of the mean force 10 N in m/s"
    return dataset.assign(variable_and_errors(name, "cell", speeds, METHOD, meaning))


def speed_of_pulse(masses, stiffness, force):
    """Return the speed in beads per time of a long pulse, by its largest force."""
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


def _dataset(dim, names, found, widths):
    variables = {}
    for name, meaning in READ.items():
        estimates = [one[name] for one in found]
        variables |= variable_and_errors(name, dim, estimates, METHOD, meaning)
    exact = {"long_name": "width by the theory", "error_estimate": 1e-15, "error_method": "formula"}
    variables["width_by_theory"] = dim, np.array(widths), exact
    equal, meaning = estimate(*map(_width_of_equal_spheres, (128, 64))), "width in beads"
    name, method = "width_of_equal_spheres", "half as many points"
    variables |= variable_and_errors(name, (), equal, method, meaning)
    return xr.Dataset(variables, {dim: names})


def _strike(name, beads, masses, stiffness, contact, tolerance):
    """Return what is read at a contact, each an `Estimate`."""
    size = masses.size
    places = [one - one % size for one in (contact // 2, contact)]
    unit = 1.0 / speed_of_pulse(masses, stiffness, 1.0)
    end, step = 2.0 * (contact + CELLS * size) * unit, STEP * unit
    probes = {}
    for place in places:
        first = list(range(place, place + size))
        beyond = [one + CELLS * size for one in first]
        probes[f"n{place}"] = {"beads": first + beyond, "start": 0.0, "stop": end, "step": step}
    record = {"snapshots": [], "probes": probes}
    beads = {"count": contact + 2 * CELLS * size, **beads}
    scene = struck_chain((1.5, 1.5, 0.0), beads, end, tolerance, record)
    motion = simulate_once(scene, f"chain {name}")
    (half, far), (half_coarse, far_coarse) = (
        [_read(motion, name, place, masses, stiffness, every) for place in places]
        for every in (1, 2)
    )
    for both in ((half, far), (half_coarse, far_coarse)):
        both[1]["force_kept"] = both[1].pop("force") / both[0]["force"]
    half["force_kept"] = far["force_kept"]
    return {
        key: Estimate(value, abs(value - half[key]) + abs(value - far_coarse[key]))
        for key, value in far.items()
    }


def _read(motion, name, place, masses, stiffness, every):
    """Return what is read in the cell after a contact, from some samples."""
    size = masses.size
    times = motion[f"t_n{place}"].values[::every]
    series = motion[f"relative_displacement_n{place}"].values[::every]
    # Contact n is between the spheres n and n + 1, the first of the cell sphere 1.
    factors = np.roll(stiffness, 1 - place % size)
    forces = np.tile(factors, 2) * np.maximum(series, 0.0) ** 1.5
    tops = times[forces.argmax(axis=0)].reshape(2, size)
    passages = tops[1] - tops[0]
    late = tops.max() > times[-5]
    if late or np.ptp(tops[0]) > passages.min() / 4.0 or passages.max() > SAME * passages.min():
        raise SolveError(
            f"The pulse in the chain {name} is lost before contact {place}: the largest forces "
            "there are not those of one pulse. Choose a contact nearer to the striker."
        )
    windows = [abs(times - top) < passages.min() / 2.0 for top in tops.ravel()]
    pulses = [_pulse(times[one], force[one]) for one, force in zip(windows, forces.T, strict=True)]
    peaks, heights, durations = np.array(pulses).T
    speed = CELLS * size**2 / (peaks[size:] - peaks[:size]).sum()
    contacts = heights.reshape(2, size).mean(axis=0)
    mean, largest = contacts.mean(), contacts.max()
    return {
        "speed_over_theory": speed / speed_of_pulse(masses, stiffness, mean),
        "speed_over_theory_by_largest": speed / speed_of_pulse(masses, stiffness, largest),
        "spread": largest / contacts.min(),
        "width": speed * durations.mean() / _width_of_equal_spheres(128),
        "force": mean,
    }


@cache
def _width_of_equal_spheres(points):
    wave = solitary_wave(1.5, points)
    return _pulse(wave.xi, np.maximum(wave.u, 0.0) ** 1.5)[2]


def _pulse(times, force):
    """Return when a force is largest, its largest value, and for how long it exceeds half of it."""
    top = int(np.argmax(force))
    near = CubicSpline(times[top - 4 : top + 5], force[top - 4 : top + 5])
    turns = near.derivative().roots(extrapolate=False)
    turn = turns[np.argmax(near(turns))]
    largest = float(near(turn))
    excess = CubicSpline(times, force - 0.5 * largest)
    before = np.flatnonzero(np.diff(force > 0.5 * largest))
    passages = [brentq(excess, *times[one : one + 2]) for one in before]
    return turn, largest, sum(passages[1::2]) - sum(passages[::2])


def width_over_theory(found, **place):
    """Return the width in a chain over that of the theory."""
    return tabulated(found, "width", **place) * (1.0 / float(found["width_by_theory"].sel(place)))


def width_in_cells(found, ratio):
    """Return the width in a dimer in cells."""
    equal = tabulated(found, "width_of_equal_spheres")
    return tabulated(found, "width", ratio=ratio) * equal * 0.5


def growth_of_deviation(found, first, second):
    """Return by what the deviation of the width from the theory grows between two mass ratios."""
    near, far = (width_over_theory(found, ratio=ratio) - 1.0 for ratio in (first, second))
    return far / near


def fastest(found, least):
    """Return the largest speed over theory in dimers that keep at least a share of the force."""
    kept = found.isel(ratio=np.flatnonzero(found["force_kept"] >= least))
    return tabulated(
        kept.isel(ratio=int(kept["speed_over_theory"].values.argmax())), "speed_over_theory"
    )
