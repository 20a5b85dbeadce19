r"""Fronts of weak damping, and slowly changing waves, to which they tend as damping vanishes.

All waves of a front into a chain at rest have the speed c = 1.  Mass and momentum
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

from dispersive_shocks import SPLINES, ZONE, crests_of, zone_of
from granular_fronts.accuracy import Estimate, error_attributes, estimate, variable_and_errors
from granular_fronts.errors import SolveError
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.fronts.solve import solve_front
from granular_fronts.output.datasets import write_dataset
from job import job

LONGEST = 9.0  # period in beads where Π is 0 to round-off
NEAREST = 4.0e-4  # by how much the shortest period exceeds that of infinitely small waves
ITERATIONS = 30
SETTLED = 1e-12  # largest change of u of a wave that is found
SHOWN = np.linspace(-0.02, 0.5, 2601)  # γξ behind the first crest at which fronts are kept
FEWER = "difference to fewer waves and points"


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
    variables, terms = {}, "difference to a form of one term less"
    for name, values, limit in zip(("overshoot", "zone"), fronts, limits, strict=True):
        last = extrapolate(dampings, values)
        for end, dims, found, method in (
            ("", "gamma", values, SPLINES),
            ("_limit", (), estimate(*limit), FEWER),
            ("_extrapolated", (), last, terms),
        ):
            words = f"{name}{end} of fronts"
            variables |= variable_and_errors(name + end, dims, found, method, words)
    for name, words in (
        ("damped_distance_wave", "γξ behind the first crest, of waves"),
        ("crest", "largest u of a wave"),
        ("trough", "smallest u of a wave"),
    ):
        attributes = error_attributes(waves[name][::2], coarse[name], FEWER) | {"long_name": words}
        variables[name] = ("wave", waves[name], attributes)
    usual, halved = np.moveaxis(curves, 1, 0)
    attributes = error_attributes(usual, halved, SPLINES) | {"long_name": "u of an exact front"}
    variables["front"] = (("gamma", "damped_distance"), usual, attributes)
    distance = ("damped_distance", SHOWN, {"long_name": "γξ behind the first crest"})
    return xr.Dataset(variables, {"gamma": dampings, "damped_distance": distance}, {"alpha": alpha})


def _look_at(front, gamma):
    """Return the overshoot of a front, its zone times γ, and u behind its crest, by two splines."""
    places, values = -front["xi"].values[::-1], front["relative_displacement"].values[::-1]
    crests = [crests_of(places[::every], values[::every]) for every in (1, 2)]
    shown = crests[0][0][0] + SHOWN / gamma
    curves = [CubicSpline(places[::every], values[::every])(shown) for every in (1, 2)]
    overshoot = Estimate(front.attrs["overshoot"], front.attrs["overshoot_error"])
    return overshoot, estimate(*(gamma * zone_of(*one) for one in crests)), curves


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


if __name__ == "__main__":
    with job(snakemake):
        settings = snakemake.params.settings
        fronts = damp_weakly(**settings)
        write_dataset(fronts, snakemake.output.dataset, scene_id="fronts", config=settings)
