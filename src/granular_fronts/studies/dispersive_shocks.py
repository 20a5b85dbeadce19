r"""Dispersive shocks of a chain without damping, and the fronts into which damping turns them.

A constant force 1 drives bead 1 of a chain of two powers, β = α.  Ahead the chain is at rest and
compressed by r, behind it u = 1.  A leading crest passes contact n, and others follow.

Without damping this train of crests spreads for ever.  Its *zone* ends where crests pass u = 1 by
0.1 alone: it is the time until then, times the speed c (14) of a front of both states.  The method
of dispersive-shock fitting joins both states by a simple wave.  With the sound speed c(u) and
:math:`\omega = 2c(u)\sin(k/2)`, it gives here

.. math::

    \frac{dk}{d\ln c} = 2\cot\frac k4 \;\Rightarrow\; \cos^2\frac k4 = \frac{c_+}{c_-}, \qquad
    \cosh^2\frac\kappa4 = \frac{c_-}{c_+}, \qquad v_- = \int_r^1 c(u)\,du .

The leading crest has the speed :math:`2c_+\sinh(\kappa/2)/\kappa` of a tail :math:`e^{-\kappa\xi}`,
and the trailing edge the group velocity :math:`c_-\cos(k/2) = 2c_+ - c_-`.

With weak damping and r = 0 all waves of the settled front have the speed c = 1.  Mass and momentum
pass it unchanged, so that waves of period P solve :math:`u = K * u^\alpha`, as the solitary wave
does (see `solitary_waves`).  The energy changes: in the frame of the front

.. math::

    \Pi = \Bigl\langle v(\xi)\,u^\alpha(\xi - 1) - \frac{v^2}2 - \frac{u^{\alpha+1}}{\alpha+1}
          \Bigr\rangle, \qquad
    D = \langle \alpha\,u^{\alpha-1} u'^2 \rangle, \qquad
    \frac{d\Pi}{d\xi} = -\gamma D

for slow changes, which gives P as a function of γξ.  Π grows from 0, the solitary wave, to (16),
:math:`(\alpha-1)/(2(\alpha+1))`, the state behind.  As γ → 0 the zone times γ therefore tends to
:math:`\int d\Pi/D`, and the first crest of the front to the solitary wave.
"""

import math

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline
from scipy.linalg import circulant
from scipy.optimize import brentq

from granular_fronts.accuracy import Estimate, error_attributes, estimate, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import SolveError
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.fronts.solve import solve_front

REACH = 8  # contacts on both sides between which the speed of the leading crest is measured
ZONE = 0.1  # by how much the last crest of the zone passes u = 1
LINE = 0.1, 0.2  # between them crests are on a straight line, which ends at the trailing edge
SLOWEST = 0.36  # speed of the last crests that are recorded
STEP = 0.05  # time between two samples
LONGEST = 9.0  # period in beads where Π is 0 to round-off
ITERATIONS = 30
SETTLED = 1e-12  # largest change of u of a wave that is found
NEAREST = 4.0e-4  # by how much the shortest period exceeds that of infinitely small waves
SHOWN = np.linspace(-0.02, 0.5, 2601)  # γξ behind the first crest at which fronts are kept
SPLINES = "difference of splines through all and half the samples"
FEWER = "difference to fewer waves and points"


def follow_shocks(alpha, dampings, ahead, contacts, tolerance):
    """Follow the crests behind a constant force 1, for each damping and compression ahead.

    On (gamma, ahead, contact): `height` and `speed` of the leading crest, `zone`, and
    `trailing_edge`, the speed at which the straight line of crests ends.  On (gamma, ahead):
    `velocity_behind` in the second half of the time.  Each comes with its `…_error`.
    """
    found = [[_follow(alpha, g, r, contacts, tolerance) for r in ahead] for g in dampings]
    variables, dims = {}, ("gamma", "ahead", "contact")
    for place, (name, meaning) in enumerate(
        (
            ("height", "compression of the leading crest"),
            ("speed", "speed of the leading crest"),
            ("zone", "beads from the leading crest to where crests pass u = 1 by 0.1"),
            ("trailing_edge", "speed of the trailing edge"),
        )
    ):
        table = [[[crest[place] for crest in crests] for crests, _ in row] for row in found]
        variables |= variable_and_errors(name, dims, table, SPLINES, meaning)
    velocities, meaning = [[one for _, one in row] for row in found], "velocity of the driven beads"
    method = "range of six times"
    variables |= variable_and_errors("velocity_behind", dims[:2], velocities, method, meaning)
    coordinates = {"gamma": dampings, "ahead": ahead, "contact": contacts}
    return xr.Dataset(variables, coordinates, {"alpha": alpha})


def _follow(alpha, gamma, ahead, contacts, tolerance):
    """Return the numbers of the crests at each contact, and the velocity behind."""
    law = {"alpha": alpha, "beta": alpha, "gamma": gamma}
    motion = simulate_chain(shock_scene(law, 1.0, ahead, contacts, tolerance), "shock")
    speed = math.sqrt((1.0 - ahead**alpha) / (1.0 - ahead))
    velocities = motion["velocity"].values[:, :40].mean(axis=1)
    behind = Estimate(float(velocities.mean()), float(np.ptp(velocities)))
    return [read_shock(motion, contact, 1.0, speed) for contact in contacts], behind


def shock_scene(law, force, ahead, contacts, tolerance):
    """Return the scene of a constant force whose time series cover the crests at some contacts."""
    probes = {}
    for contact in contacts:
        start, samples = 0.5 * contact, 2 * int((1.0 / SLOWEST - 0.5) * contact / (2.0 * STEP))
        beads = [contact - REACH, contact, contact + REACH]
        stop = start + samples * STEP
        probes[f"n{contact}"] = {"beads": beads, "start": start, "stop": stop, "step": STEP}
    return {
        "law": law,
        "beads": int(1.3 * stop),
        "boundary": {"kind": "force", "force": force, "right": ahead},
        "start": {"kind": "equilibrium"},
        "end_time": stop,
        "tolerance": tolerance,
        "record": {"snapshots": np.linspace(0.5 * stop, stop, 6).tolist(), "probes": probes},
    }


def read_shock(motion, contact, behind, speed):
    """Return height, speed, zone and trailing edge at a contact, u over the state behind."""
    times = motion[f"t_n{contact}"].values
    values = motion[f"relative_displacement_n{contact}"].values / behind
    readings = (_read(contact, times[::every], values[::every], speed) for every in (1, 2))
    return [estimate(*pair) for pair in zip(*readings, strict=True)]


def _read(contact, times, values, speed):
    (before, _), (places, heights), (after, _) = (_crests(times, one) for one in values.T)
    passage = 2.0 * REACH / (after[0] - before[0])
    over = heights - 1.0
    straight = (over > LINE[0]) & (over < LINE[1])
    if np.count_nonzero(straight) < 2:
        raise SolveError(
            f"Fewer than two crests pass the state behind by {LINE[0]:g} to {LINE[1]:g}: take "
            "contacts further away."
        )
    slope, start = np.polyfit(contact / places[straight], over[straight], 1)
    return np.array([heights[0], passage, speed * _zone(places, heights), -start / slope])


def _crests(places, values):
    """Return where a curve has maxima above 1, and how high they are."""
    spline = CubicSpline(places, values)
    turns = spline.derivative().roots(extrapolate=False)
    turns = turns[(spline(turns, 2) < 0.0) & (spline(turns) > 1.0)]
    return turns, spline(turns)


def _zone(places, heights):
    """Return how far behind the first crest the overshoot falls to `ZONE` for good."""
    last = np.flatnonzero(heights > 1.0 + ZONE)[-1]
    if last + 1 == heights.size:
        raise SolveError(
            f"The last crest recorded still passes the state behind by more than {ZONE:g}: the "
            "train is longer than what is recorded of it."
        )
    pair = slice(last, last + 2)
    return np.interp(-math.log(ZONE), -np.log(heights[pair] - 1.0), places[pair]) - places[0]


def fitted_edges(sound_ahead, sound_behind):
    """Return the speeds of leading crest and trailing edge by dispersive-shock fitting.

    Examples
    --------
    >>> [round(float(one), 4) for one in fitted_edges(1.0, 1.3)]
    [1.193, 0.7]
    """
    kappa = 4.0 * np.arccosh(np.sqrt(sound_behind / sound_ahead))
    return 2.0 * sound_ahead * np.sinh(0.5 * kappa) / kappa, 2.0 * sound_ahead - sound_behind


def damp_weakly(alpha, dampings):
    """Compare exact fronts of weak damping, each half the one before, with their limit.

    On (gamma,): `overshoot`, and `zone` times γ; without dimension: their limits by waves,
    `overshoot_limit` and `zone_limit`, and `…_extrapolated` from the last fronts.  Each comes with
    its `…_error`.  On (wave,): `damped_distance_wave`, γξ behind the first crest, `crest` and
    `trough` there.  On (gamma, damped_distance): `front`, u of the front.
    """
    *fronts, curves = zip(
        *(_look_at(solve_front(alpha, gamma), gamma) for gamma in dampings), strict=True
    )
    # The coarse periods are every other of the fine ones.
    waves, coarse = (slow_waves(alpha, *sizes) for sizes in ((64, 199), (48, 100)))
    limits = zip(*(_limits(one) for one in (waves, coarse)), strict=True)
    variables, names = {}, ("overshoot", "zone")
    for name, values, limit in zip(names, fronts, limits, strict=True):
        for end, dims, found, method in (
            ("", "gamma", values, SPLINES),
            ("_limit", (), estimate(*limit), FEWER),
            (
                "_extrapolated",
                (),
                extrapolate(dampings, values),
                "difference to a form of one term less",
            ),
        ):
            variables |= variable_and_errors(
                name + end, dims, found, method, f"{name}{end} of fronts"
            )
    for name, values in waves.items():
        variables[name] = ("wave", values, error_attributes(values[::2], coarse[name], FEWER))
    usual, halved = np.moveaxis(curves, 1, 0)
    attributes = error_attributes(usual, halved, SPLINES) | {"long_name": "u of an exact front"}
    variables["front"] = (("gamma", "damped_distance"), usual, attributes)
    return xr.Dataset(variables, {"gamma": dampings, "damped_distance": SHOWN}, {"alpha": alpha})


def _look_at(front, gamma):
    """Return the overshoot of a front, its zone times γ, and u behind its crest, by two splines."""
    places, values = -front["xi"].values[::-1], front["relative_displacement"].values[::-1]
    crests = [_crests(places[::every], values[::every]) for every in (1, 2)]
    shown = crests[0][0][0] + SHOWN / gamma
    curves = [CubicSpline(places[::every], values[::every])(shown) for every in (1, 2)]
    overshoot = Estimate(front.attrs["overshoot"], front.attrs["overshoot_error"])
    return overshoot, estimate(*(gamma * _zone(*one) for one in crests)), curves


def extrapolate(dampings, estimates):
    """Return the limit γ → 0 by 1, γ, γ ln γ and γ² through the last four values.

    Its error is that of the values, and the distance to the limit without γ², through three.
    """
    gamma = np.array(dampings[-4:])
    terms = np.stack([gamma**0, gamma, gamma * np.log(gamma), gamma**2])
    whole, less = (
        sum(weight * one for weight, one in zip(weights, estimates[-n:], strict=True))
        for n in (4, 3)
        for weights in [np.linalg.solve(terms[:n, -n:], np.eye(n)[0])]
    )
    return whole + Estimate(0.0, abs(whole.value - less.value))


def slow_waves(alpha, points, count):
    """Return `damped_distance_wave`, `crest` and `trough` of the waves of a weakly damped front.

    Periodic waves by Newton's method, from period to period; a spline of Π integrates dΠ/D.
    """
    shortest = 1.0 / brentq(lambda inverse: np.sinc(inverse) ** 2 - 1.0 / alpha, 1e-3, 1.0)
    logs = np.linspace(math.log(LONGEST - shortest), math.log(NEAREST), count)
    solitary, rows = solitary_wave(alpha), []
    sites = (np.arange(points) / points + 0.5) % 1.0 - 0.5
    u = np.interp(LONGEST * sites, solitary.xi, solitary.u)
    for period in shortest + np.exp(logs):
        u = _periodic_wave(alpha, u, period)
        rows.append((*_energies(alpha, u, period), u.max(), u.min()))
    flux, losses, crest, trough = np.array(rows).T
    rate = CubicSpline(-logs, flux).derivative()(-logs) / losses
    return {
        "damped_distance_wave": CubicSpline(-logs, rate).antiderivative()(-logs),
        "crest": crest,
        "trough": trough,
    }


def _periodic_wave(alpha, u, period):
    """Return the solution of u = K * u^α of a period near another one."""
    smooth = circulant(np.fft.irfft(np.sinc(np.fft.rfftfreq(u.size, period / u.size)) ** 2, u.size))
    for _ in range(ITERATIONS):
        force = np.maximum(u, 0.0)
        slope = np.eye(u.size) - smooth * (alpha * force ** (alpha - 1.0))
        # Least squares, since every translate of a solution is one.
        change = np.linalg.lstsq(slope, smooth @ force**alpha - u, rcond=1e-9)[0]
        u = u + change
        # The state behind, u = 1, solves it too.
        if np.abs(change).max() <= SETTLED < np.ptp(u):
            return u
    raise SolveError(
        f"No wave of the period {period:.6g} was found for alpha = {alpha:g}: take more waves, so "
        "that each is nearer to the one before."
    )


def _energies(alpha, u, period):
    """Return the energy flux Π of a wave in its frame, and its dissipation D over γ."""
    k, compression = 2.0 * np.pi * np.fft.rfftfreq(u.size, period / u.size), np.maximum(u, 0.0)
    slope = np.fft.irfft(1j * k * np.fft.rfft(u), u.size)
    forces = np.fft.rfft(compression**alpha)
    # v' = u^α(ξ) − u^α(ξ − 1), and v and u^α have the same mean.
    shares = np.exp(-0.5j * k) * np.sinc(k / (2.0 * np.pi))
    v, behind = (np.fft.irfft(forces * by, u.size) for by in (shares, np.exp(-1j * k)))
    energy = 0.5 * v**2 + compression ** (alpha + 1.0) / (alpha + 1.0)
    return np.mean(v * behind - energy), alpha * np.mean(compression ** (alpha - 1.0) * slope**2)


def _limits(waves):
    """Return the overshoot of the first crest, and the zone times γ."""
    over = np.log(waves["crest"] - 1.0)
    lower = over < over[0] - 0.01  # The first waves are equally high to round-off.
    zone = CubicSpline(-over[lower], waves["damped_distance_wave"][lower])(-math.log(ZONE))
    return waves["crest"][0] - 1.0, zone
