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

A second method has the times at which compressions are largest at two contacts.  With damping the
shift is the lead over a wave that meets no other, by such times.

Errors.  Speeds and shifts are found again by momenta at an earlier time, with a larger tolerance.
Both waves of a collision have the larger of their errors, as one may be small by chance.
"""

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.signal import argrelmax

from granular_fronts.accuracy import Estimate, estimate, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_once
from granular_fronts.fronts.solitary_waves import POINTS_PER_BEAD, solitary_wave, start_in_waves

BEFORE, EARLY, LATE = 24, 300, 450
"""Times from the start to the collision, and from it to both readings, for a speed of 1."""

HALF = 7  # contacts on both sides of its highest one that belong to a wave
FAINT = 2e-3  # part of the height of the first wave below which none is sought
SPACING = 0.02  # time between two samples
CONTACTS = 60, 120  # from the place of the collision, where times of peaks are taken
DAMPED_CONTACTS = 32, 36, 40  # the same with damping

MEANINGS = {
    "speed_after": "speed of a wave after the collision over that before",
    "shift": "beads by which a wave is ahead after the collision",
    "secondary": "speed of the secondary wave over that of the incident one",
}


def find_collisions(alpha, pairs, places, tolerance):
    """Collide waves of the speeds of each pair at each place.

    On (pair, place, direction), each with its `…_error`: `speed_after`, `shift` and `secondary`.
    On (pair, place): `shift_by_times` of the wave to the right.
    """
    looser = {key: 100.0 * value for key, value in tolerance.items()}

    def both(pair, place):
        ways = (tolerance, LATE, False, 1), (looser, EARLY, True, 2)
        found = [_collide(alpha, pair, place, *way) for way in ways]
        return [estimate(*two) for two in zip(*found, strict=True)]

    table = np.array([[both(pair, place) for place in places] for pair in pairs])
    variables, dims = {}, ("pair", "place", "direction")
    method = "momenta earlier, a hundred times the tolerance"
    for number, (name, meaning) in enumerate(MEANINGS.items()):
        found = table[:, :, [number, number + len(MEANINGS)]]
        found[..., 1] = found[..., 1].max(axis=2, keepdims=True)
        variables |= variable_and_errors(name, dims, found, method, meaning)
    method, by_times = "half the samples", table[:, :, -1]
    variables |= variable_and_errors("shift_by_times", dims[:2], by_times, method, "shift by times")
    coordinates = dict(zip(dims, (range(len(pairs)), places, [1, -1]), strict=True))
    return xr.Dataset(variables, coordinates, {"alpha": alpha})


def _collide(alpha, pair, place, tolerance, time, by_momenta, every):
    """Return the numbers of `MEANINGS` for both directions, and the shift by times of peaks."""
    end = BEFORE + time / min(pair)
    middle, beads = (int(one * end) + 10 for one in (pair[1], sum(pair)))
    motion = _run(alpha, 0.0, pair, middle + place, beads + 10, end, CONTACTS, tolerance)
    u = np.maximum(motion["relative_displacement"].values[0, :-1], 0.0)
    velocity, gone = motion["velocity"].values[0], end - BEFORE
    right = _read(alpha, pair[0], u, velocity, middle + place, gone, by_momenta)
    mirrored = beads + 10 - middle - place
    left = _read(alpha, pair[1], u[::-1], -velocity[::-1], mirrored, gone, by_momenta)
    first, second = _times_of_peaks(motion, every) - BEFORE
    speed = (CONTACTS[1] - CONTACTS[0]) / (second - first)
    return *right, *left, CONTACTS[0] - place - speed * first


def _run(alpha, gamma, speeds, place, beads, end, contacts, tolerance):
    """Return the motion of a chain in which one wave, or two, will be at a place."""
    waves = [(place - BEFORE * speeds[0], speeds[0])]
    waves += [(place + BEFORE * speed, -speed) for speed in speeds[1:]]
    probe = {"beads": [int(place) + one for one in contacts], "start": BEFORE, "step": SPACING}
    scene = {
        "law": {"alpha": alpha, "beta": alpha, "gamma": gamma},
        "beads": beads,
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": start_in_waves(alpha, beads, waves),
        "end_time": end,
        "tolerance": tolerance,
        "record": {"snapshots": [end], "probes": {"peaks": probe | {"stop": end}}},
    }
    return simulate_once(scene, "colliding waves")


def _read(alpha, incident, u, velocity, place, gone, by_momenta):
    """Return the numbers of `MEANINGS` of what runs to the right."""
    [tops] = argrelmax(np.where(u > FAINT * u[int(place) :].max(), u, 0.0))
    content = solitary_wave(alpha).u.sum() / POINTS_PER_BEAD
    speeds, places = [], []
    for top in tops[:-3:-1]:
        near = np.arange(top - HALF, top + HALF + 1)
        share, power = u[near].sum() / content, 0.5 * (alpha - 1.0)
        if by_momenta:
            share, power = velocity[near].sum() / content, (alpha - 1.0) / (alpha + 1.0)
        speeds.append(abs(share) ** power)
        places.append((near + 1.0) @ u[near] / u[near].sum())
    return speeds[0] / incident, places[0] - place - speeds[0] * gone, speeds[1] / incident


def _times_of_peaks(motion, every):
    """Return when the compression is largest at each contact, by splines through samples."""
    times, found = motion["t_peaks"].values[::every], []
    for u in motion["relative_displacement_peaks"].values[::every].T:
        near = slice(u.argmax() - 9, u.argmax() + 10)
        zeros = CubicSpline(times[near], u[near]).derivative().roots(extrapolate=False)
        found.append(zeros[np.abs(zeros - times[u.argmax()]).argmin()])
    return np.array(found)


def damp_collisions(alpha, dampings, places, tolerance):
    """Return `shift` on (gamma, place) of damped waves of speed 1, by times of peaks."""

    def lead(gamma, place, every):
        setting = 200 + place, 400, 2.0 * BEFORE + 40.0, DAMPED_CONTACTS, tolerance
        alone, met = (
            _times_of_peaks(_run(alpha, gamma, speeds, *setting), every)
            for speeds in ([1.0], [1.0, 1.0])
        )
        speed = (DAMPED_CONTACTS[2] - DAMPED_CONTACTS[0]) / (alone[2] - alone[0])
        return speed * (alone - met)[::-1][every - 1]

    found = [[estimate(lead(g, p, 1), lead(g, p, 2)) for p in places] for g in dampings]
    variables = variable_and_errors("shift", ("gamma", "place"), found, "a nearer contact", "shift")
    return xr.Dataset(variables, {"gamma": dampings, "place": places})


def share(found, name, of, place, pair=0):
    """Return what a speed over the incident one is of `force`, `momentum` or `energy`."""
    alpha = found.attrs["alpha"]
    powers = {"force": 2.0 * alpha, "momentum": alpha + 1.0, "energy": 2.0 * (alpha + 1.0)}
    power = powers[of] / (alpha - 1.0)
    speed = tabulated(found.sel(pair=pair, place=place, direction=1), name)
    return Estimate(speed.value**power, power * speed.value ** (power - 1.0) * speed.error)


def even_over_odd(found):
    """Return the force of the secondary wave at a contact over that at a bead."""
    return share(found, "secondary", "force", 0) / share(found, "secondary", "force", 0.5)


def proportionality(found, place):
    """Return the share of force of the secondary wave of the second pair over that of the first."""
    return share(found, "secondary", "force", place, 1) / share(found, "secondary", "force", place)


def methods_apart(found, pair, place):
    """Return the shift of the wave to the right less that by times of peaks."""
    one = found.sel(pair=pair, place=place)
    return tabulated(one.sel(direction=1), "shift") - tabulated(one, "shift_by_times")


def damped_over_free(found, gamma, place):
    """Return the shift with damping over that without."""
    one = found.sel(place=place)
    return tabulated(one.sel(gamma=gamma), "shift") / tabulated(one.sel(gamma=0), "shift")
