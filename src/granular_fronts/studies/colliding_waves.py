r"""Two solitary waves that collide: by how much each is ahead afterwards, and what is left behind.

Two waves run towards each other in a chain at rest.  The *place* p is where both would be at t = 0
if neither met the other.  Place 0 is a contact and place 1/2 a bead, the middles of chains with
even and with odd numbers of beads.

A wave :math:`u_n(t) = c^{2/(\alpha-1)} U(n - x(t))` of speed c has :math:`U = K * U^\alpha`, and
the transform of K has double zeros at :math:`2\pi k` (see `solitary_waves`).  By Poisson's formula
sums over its contacts are integrals, without an error of the lattice:

.. math::

    \sum_n u_n = c^{2/(\alpha-1)} \int U, \qquad \sum_n n\,u_n = x \sum_n u_n, \qquad
    \sum_n v_n = c^{(\alpha+1)/(\alpha-1)} \int U .

The first and the third give the speed of a wave that is by itself, the second its place.  After the
collision it is at :math:`x = p + c't + s` with its new speed c', which defines the *shift* s.
The wave next behind it is the *secondary* one.

A wave that meets no other is at p + ct.  The *lead* over it has no limit if c' differs from c.

Errors.  Speeds and shifts are found again by momenta at an earlier time, and with a tolerance three
times larger.  All collisions of a pair have the largest difference, as one may be small by chance.
A second method has the times at which compressions are largest at two contacts.
"""

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.signal import argrelmax

from granular_fronts.accuracy import estimate, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_once
from granular_fronts.fronts.solitary_waves import POINTS_PER_BEAD, solitary_wave, start_in_waves

BEFORE, EARLY, LATE = 24, 300, 450
"""Times from the start to the collision, and from it to both readings, for a speed of 1."""

HALF = 7  # contacts on both sides of its highest one that belong to a wave
FAINT = 2e-3  # part of the height of the first wave below which none is sought
SPACING = 0.02  # time between two samples
CONTACTS = 60, 120  # from the place of the collision, where times of peaks are taken

MEANINGS = {
    "speed_after": "speed of a wave after the collision over that before",
    "shift": "beads by which a wave is ahead after the collision",
    "secondary": "speed of the secondary wave over that of the incident one",
    "third": "speed of the wave behind the secondary one over that of the incident one",
}


def find_collisions(alpha, pairs, places, tolerance):
    """Collide waves of the speeds of each pair at each place.

    On (pair, place, direction), each with its `…_error`: `speed_after`, `shift`, `secondary` and
    `third`, and the same `…_by_momenta`.  On (pair, place): `shift_by_times` of the wave to the
    right.
    """
    looser = {key: 3.0 * value for key, value in tolerance.items()}
    ways = (tolerance, 1), (looser, 2)
    table = np.array(
        [
            [[_collide(alpha, pair, place, *way) for way in ways] for place in places]
            for pair in pairs
        ]
    )
    usual, other = np.moveaxis(table[..., :-1], 2, 0).reshape(2, len(pairs), len(places), 2, 2, -1)
    late, early = np.moveaxis(usual, 2, 0)
    apart = np.maximum(abs(usual - other).max(axis=2), abs(late - early))
    errors = np.broadcast_to(apart.max(axis=(1, 2), keepdims=True), late.shape)
    variables, dims = {}, ("pair", "place", "direction")
    for ending, found in (("", late), ("_by_momenta", early)):
        for number, (name, meaning) in enumerate(MEANINGS.items()):
            estimates = np.stack([found[..., number], errors[..., number]], axis=-1)
            method = "other tolerance, sum and time"
            variables |= variable_and_errors(name + ending, dims, estimates, method, meaning)
    by_times = np.array([[estimate(*numbers) for numbers in row] for row in table[..., -1]])
    by_times[..., 1] = by_times[..., 1].max(axis=1, keepdims=True)
    method, meaning = "half the samples, a larger tolerance", "shift by times of peaks"
    variables |= variable_and_errors("shift_by_times", dims[:2], by_times, method, meaning)
    coordinates = dict(zip(dims, (range(len(pairs)), places, [1, -1]), strict=True))
    return xr.Dataset(variables, coordinates, {"alpha": alpha})


def _collide(alpha, pair, place, tolerance, every):
    """Return the numbers of `MEANINGS`, late and early, right and left, and the shift by times."""
    ends = [BEFORE + time / min(pair) for time in (LATE, EARLY)]
    middle, beads = (int(one * ends[0]) + 10 for one in (pair[1], sum(pair)))
    motion = _run(alpha, pair, middle + place, beads + 10, ends[::-1], tolerance)
    mirrored, found = beads + 10 - middle - place, []
    for snapshot, end, by_momenta in ((1, ends[0], False), (0, ends[1], True)):
        u = np.maximum(motion["relative_displacement"].values[snapshot, :-1], 0.0)
        velocity, when = motion["velocity"].values[snapshot], (end - BEFORE, by_momenta)
        found += _read(alpha, pair[0], u, velocity, middle + place, *when)
        found += _read(alpha, pair[1], u[::-1], -velocity[::-1], mirrored, *when)
    first, second = _times_of_peaks(motion, every) - BEFORE
    speed = (CONTACTS[1] - CONTACTS[0]) / (second - first)
    return *found, CONTACTS[0] - place - speed * first


def _run(alpha, pair, place, beads, ends, tolerance):
    """Return the motion of a chain in which two waves would be at a place."""
    waves = [(place - BEFORE * pair[0], pair[0]), (place + BEFORE * pair[1], -pair[1])]
    peaks = {"beads": [int(place) + one for one in CONTACTS], "start": BEFORE, "stop": ends[1]}
    scene = {
        "law": {"alpha": alpha, "beta": alpha, "gamma": 0.0},
        "beads": beads,
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": start_in_waves(alpha, beads, waves),
        "end_time": ends[1],
        "tolerance": tolerance,
        "record": {"snapshots": ends, "probes": {"peaks": peaks | {"step": SPACING}}},
    }
    return simulate_once(scene, "colliding waves")


def _read(alpha, incident, u, velocity, place, gone, by_momenta):
    """Return the numbers of `MEANINGS` of what runs to the right."""
    [tops] = argrelmax(np.where(u > FAINT * u[int(place) :].max(), u, 0.0))
    content = solitary_wave(alpha).u.sum() / POINTS_PER_BEAD
    speeds, places = [], []
    for top in tops[:-4:-1]:
        near = np.arange(top - HALF, top + HALF + 1)
        share, power = u[near].sum() / content, 0.5 * (alpha - 1.0)
        if by_momenta:
            share, power = velocity[near].sum() / content, (alpha - 1.0) / (alpha + 1.0)
        speeds.append(abs(share) ** power)
        places.append((near + 1.0) @ u[near] / u[near].sum())
    shift = places[0] - place - speeds[0] * gone
    return speeds[0] / incident, shift, speeds[1] / incident, speeds[2] / incident


def _times_of_peaks(motion, every):
    """Return when the compression is largest at each contact, by splines through samples."""
    times, found = motion["t_peaks"].values[::every], []
    for u in motion["relative_displacement_peaks"].values[::every].T:
        near = slice(u.argmax() - 9, u.argmax() + 10)
        zeros = CubicSpline(times[near], u[near]).derivative().roots(extrapolate=False)
        found.append(zeros[np.abs(zeros - times[u.argmax()]).argmin()])
    return np.array(found)


def share(found, name, of, place, pair=0):
    """Return what a speed over the incident one is of `force`, `momentum` or `energy`."""
    alpha = found.attrs["alpha"]
    powers = {"force": 2.0 * alpha, "momentum": alpha + 1.0, "energy": 2.0 * (alpha + 1.0)}
    speed = tabulated(found, name, pair=pair, place=place, direction=1)
    return speed ** (powers[of] / (alpha - 1.0))


def even_over_odd(found):
    """Return the force of the secondary wave at a contact over that at a bead."""
    return share(found, "secondary", "force", 0) / share(found, "secondary", "force", 0.5)


def proportionality(found, place):
    """Return the share of force of the secondary wave of the second pair over that of the first."""
    return share(found, "secondary", "force", place, 1) / share(found, "secondary", "force", place)


def energy_found(found, name, place):
    """Return the energy of a wave behind the first one over what the first one has lost."""
    return share(found, name, "energy", place) / (-share(found, "speed_after", "energy", place) + 1)


def lead(found, distance, place, pair=0):
    """Return by how much the wave to the right leads a free one that has run a distance since."""
    one = found.sel(pair=pair, place=place, direction=1)
    return tabulated(one, "shift") + (tabulated(one, "speed_after") - 1.0) * distance


def methods_apart(found, name, by, place, pair=0):
    """Return a number of the wave to the right less that by momenta, or the shift by times."""
    one = found.sel(pair=pair, place=place, direction=1)
    return tabulated(one, name) - tabulated(one, f"{name}_by_{by}")
