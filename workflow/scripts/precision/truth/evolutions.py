"""The amplitude equations on a ring by other steps, and the true errors of the package.

The equations are solved for Fourier amplitudes by the exponential steps of Cox and Matthews, J.
Comput. Phys. 176 (2002) 430-455.  Their coefficients are means over circles, and each step is taken
once and in two halves.  Amplitudes of a start with kinks are closed formulas.  No step, no cell and
no cut-off of the logarithm is the package's.
"""

import functools
import math

import numpy as np

from granular_fronts.continuum.evolution import (
    evolve_log_burgers,
    evolve_log_kdv_burgers,
    evolve_unlimited,
)
from granular_fronts.errors import InputError
from granular_fronts.model.amplitude_scaling import gamma_for, make_slow_scales, scaling_of

POINTS, FEWEST_POINTS = 4096, 512
# The steps of (40) and (41) are short for stability, and err far less than their tolerance.
SHARE_OF_TOLERANCE = {"dispersive": 3e-4, "logarithmic": 0.0, "unlimited": 0.0}
LEAST_TOLERANCE = 3e-14
EXTINCT = 1e-15
CIRCLE = np.exp(1j * np.pi * (np.arange(32) + 0.5) / 16)
SMALLEST = 1e-30


class Ring:
    """One equation on a ring, for the amplitudes of y, or of v = y^(1/α) where α is above 1.

    Parameters
    ----------
    half_length, dispersion, alpha : float
        ℓ, μ⁻² and the exponent of (40), 1 for its limit; (40) is not dispersive.
    amplitudes : ndarray of complex, shape (POINTS//2 + 1,)
    tolerance : float
        Error allowed per step.
    """

    def __init__(self, half_length, dispersion, alpha, amplitudes, tolerance):
        self.points, self.tolerance = POINTS, tolerance
        self.kappa = np.pi * np.arange(POINTS // 2 + 1) / half_length
        self.alpha, self.half_length = alpha, half_length
        highest = np.abs(np.fft.irfft(amplitudes, POINTS, norm="forward")).max()
        self.diffusion = alpha * highest ** (alpha - 1.0)
        self.rates = self.kappa**2 * (1j * dispersion * self.kappa - self.diffusion)
        self.amplitudes, self.tau, self.halvings = amplitudes, 0.0, 30
        self.step = functools.cache(self.make_step)

    def rest(self, amplitudes):
        """Return the rates that are not linear, two thirds of the waves kept."""
        v = np.fft.irfft(amplitudes, self.points, norm="forward")
        if self.alpha == 1.0:
            flux = v * np.log(np.maximum(np.abs(v), SMALLEST))
        else:
            power = np.sign(v) * np.abs(v) ** self.alpha
            flux = self.alpha * (power - v) / (self.alpha - 1.0)
        rates = -1j * self.kappa * np.fft.rfft(flux, norm="forward")
        if self.alpha > 1.0:
            excess = power - self.diffusion * v
            rates -= self.kappa**2 * np.fft.rfft(excess, norm="forward")
        rates[2 * rates.size // 3 :] = 0.0
        return rates

    def make_step(self, halvings):
        """Return the coefficients of a step of length 2^(−halvings)."""
        h = 2.0**-halvings
        z = h * self.rates[:, None] + CIRCLE
        exponential = np.exp(z)
        half = ((np.exp(0.5 * z) - 1.0) / z).mean(axis=1)
        first = (-4.0 - z + exponential * (4.0 - 3.0 * z + z**2)) / z**3
        middle = (2.0 + z + exponential * (z - 2.0)) / z**3
        last = (-4.0 - 3.0 * z - z**2 + exponential * (4.0 - z)) / z**3
        means = [h * part for part in (half, *(p.mean(axis=1) for p in (first, middle, last)))]
        return np.exp(h * self.rates), np.exp(0.5 * h * self.rates), *means

    def take(self, u, halvings):
        """Return the amplitudes after one step."""
        whole, halfway, half, first, middle, last = self.step(halvings)
        n = self.rest(u)
        a = halfway * u + half * n
        of_a = self.rest(a)
        of_b = self.rest(halfway * u + half * of_a)
        of_c = self.rest(halfway * a + half * (2.0 * of_b - n))
        return whole * u + first * n + 2.0 * middle * (of_a + of_b) + last * of_c

    def advance(self, stop):
        """Go on to the slow time `stop`, a multiple of 2⁻³⁰."""
        while self.tau < stop:
            while self.tau + 2.0**-self.halvings > stop:
                self.halvings += 1
            once = self.take(self.amplitudes, self.halvings)
            twice = self.amplitudes
            for _ in range(2):
                twice = self.take(twice, self.halvings + 1)
            error = np.abs(np.fft.irfft(twice - once, self.points, norm="forward")).max() / 15.0
            if error > self.tolerance:
                self.halvings += 1
                continue
            self.tau += 2.0**-self.halvings
            self.amplitudes = twice + (twice - once) / 15.0
            # Times stay multiples of the step.
            longer = self.tau % 2.0 ** (1 - self.halvings) == 0.0
            if error < self.tolerance / 64.0 and longer:
                self.halvings -= 1
            half = self.points // 4 + 1
            extinct = np.abs(self.amplitudes[half // 2 :]).max() < EXTINCT
            if extinct and self.points > FEWEST_POINTS:
                self.points //= 2
                self.amplitudes = self.amplitudes[:half]
                self.kappa, self.rates = self.kappa[:half], self.rates[:half]
                self.step = functools.cache(self.make_step)

    def values(self, tau, xi):
        """Return the values of y at any ξ, by a step of first order to a slow time just ahead."""
        rates = self.rest(self.amplitudes) + self.rates * self.amplitudes
        amplitudes = self.amplitudes + (tau - self.tau) * rates
        waves = np.flatnonzero(np.abs(amplitudes) > 1e-17)[-1] + 1
        weights = 2.0 * amplitudes[:waves]
        weights[0] /= 2.0
        phase = 1j * np.pi * (xi / self.half_length + 1.0)
        v = (np.exp(np.multiply.outer(phase, np.arange(waves))) @ weights).real
        return np.sign(v) * np.abs(v) ** self.alpha


def _plateau_amplitudes(half_width, floor, half_length):
    """Return the amplitudes of the start (49), by parts."""
    kappa = np.pi * np.arange(1, POINTS // 2 + 1) / half_length
    fall = math.sqrt(1.0 - floor)

    def primitive(x):
        i = 1j * kappa
        powers = (1.0 - x**2) / i + 2.0 * x / i**2 - 2.0 / i**3
        return np.exp(1j * kappa * (x + half_width)) * powers

    edge = half_width + fall
    cosines = np.sin(kappa * half_width) / kappa + (primitive(fall) - primitive(0.0)).real
    cosines += floor * (np.sin(kappa * half_length) - np.sin(kappa * edge)) / kappa
    mean = half_width + fall - fall**3 / 3.0 + floor * (half_length - edge)
    waves = np.concatenate([[mean], cosines]) / half_length
    return waves * (-1.0) ** np.arange(waves.size) + 0j


def _given_amplitudes(values, power):
    """Return the amplitudes of the power of a start that is listed at points."""
    found = np.fft.rfft(np.asarray(values[:-1]) ** power, norm="forward")
    if len(values) % 2:
        # The last wave of an even number of points counts once there, and twice among more.
        found[-1] *= 0.5
    return np.concatenate([found, np.zeros(POINTS // 2 + 1 - found.size)])


EQUATIONS = {
    "logarithmic": evolve_log_burgers,
    "dispersive": evolve_log_kdv_burgers,
    "unlimited": evolve_unlimited,
}


def compare(equation, scene):
    """Return (name, stated error, true error, largest value) of the answer at all times."""
    found = EQUATIONS[equation](scene)["rescaled_force"]
    scales = scaling_of(scene)
    half_length = scales.half_length(scene["half_beads"])
    alpha = scales.alpha if equation == "unlimited" else 1.0
    start = scene["start"]
    if start["kind"] == "plateau":
        amplitudes = _plateau_amplitudes(start["half_width"], start["floor"], half_length)
    else:
        amplitudes = _given_amplitudes(start["rescaled_force"], 1.0 / alpha)
    dispersion = scales.dispersion if equation == "dispersive" else 0.0
    allowed = SHARE_OF_TOLERANCE[equation] * scene["equations"][equation]["tolerance"]
    allowed = max(allowed, LEAST_TOLERANCE)
    ring, error = Ring(half_length, dispersion, alpha, amplitudes, allowed), 0.0
    for row, tau in zip(found.values, found["slow_time"].values, strict=True):
        ring.advance(math.floor(tau * 2.0**30) / 2.0**30)
        values = ring.values(tau, found["xi"].values + tau)
        error = max(error, float(np.abs(values - row).max()))
    return found.attrs["error_estimate"], error, float(np.abs(found.values).max())


def random_scene(rng, equation):
    """Return a scene of one equation on a ring."""
    alpha, epsilon = 1.0 + float(10 ** rng.uniform(-2.0, -0.2)), float(rng.uniform(0.1, 1.0))
    delta = float(rng.uniform(0.5, 2.0))
    gamma = gamma_for(alpha, delta, epsilon=epsilon)
    half_length = float(rng.uniform(6.0, 14.0))
    slow_rate = make_slow_scales(alpha, gamma, delta).slow_rate
    times = np.sort(10 ** rng.uniform(-1.7, 0.3, rng.integers(1, 4))) / slow_rate
    if equation != "unlimited" and rng.random() < 0.6:
        floor = float(10 ** rng.uniform(-7.0, -1.0))
        half_width = float(rng.uniform(0.3, 0.6)) * (half_length - 1.0)
        start = {"kind": "plateau", "half_width": half_width, "floor": floor}
    else:
        x = np.pi * np.linspace(-1.0, 1.0, 65)
        waves = sum(
            rng.uniform(-1, 1) / k * np.cos(k * (x - rng.uniform(-3, 3))) for k in (1, 2, 3)
        )
        waves = 1.0 + 0.8 * waves / np.abs(waves).max()
        waves[-1] = waves[0]
        start = {"kind": "given", "rescaled_force": waves.tolist()}
    tolerance = float(10 ** rng.uniform(-8.0, -4.0))
    resolution = {"cells": int(2 ** rng.integers(7, 10)), "tolerance": tolerance}
    return {
        "law": {"alpha": alpha, "gamma": gamma},
        "displacement": delta,
        "half_beads": math.ceil(half_length / epsilon),
        "start": start,
        "end_time": float(times[-1]),
        "tolerance": {"relative": 1e-9, "absolute": 1e-12},
        "equations": {equation: resolution},
        "record": {"snapshots": times.tolist(), "grid": {"step": float(times[-1])}},
    }


def cases(seed, count):
    """Compare random evolutions with true ones; numbers as of `truth.chains.cases`."""
    for k, rng in enumerate(np.random.default_rng(seed).spawn(count)):
        equation = ("dispersive", "logarithmic", "dispersive", "unlimited")[k % 4]
        scene = random_scene(rng, equation)
        described = {name: scene[name] for name in ("law", "displacement", "half_beads")}
        described |= {"snapshots": scene["record"]["snapshots"]} | scene["equations"][equation]
        if scene["start"]["kind"] == "plateau":
            described["start"] = scene["start"]
        try:
            yield f"{equation} {k}: {described}", *compare(equation, scene)
        except InputError:
            # Too few cells for the edge of the wave.
            continue
