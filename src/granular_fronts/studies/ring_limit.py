r"""How far a ring of beads is from its amplitude equations, as α → 1.

A ring is followed as the chain itself and by three equations for the rescaled force y, all from the
same start and in units δ = c = 1: (41), (40), and the logarithmic KdV–Burgers equation (55), which
in ξ and τ is (41) with the dispersion :math:`\mu^{-2} = (\varepsilon/\gamma c)/12`.

The chain is followed bead by bead, or, where a smooth wave needs fewer points than there are beads,
by its Fourier coefficients (`chain.fourier_ring`).  A contact that opens ends the smoothness, and
such a ring is followed bead by bead.  A gap counts as no compression, since no equation for u^α
can have one.

Errors at a slow time τ, each against the chain at its beads, or at as many places as there are
coefficients:

- `sup` and `rms` of :math:`u_n/\delta`, and of :math:`\dot x_n/(\delta c)` with the velocities (43)
  of the equation; `leading` is the sup of the velocities (51);
- `height`, of the largest u; `place`, in ξ, of where u falls through the middle of its range;
  `decay`, relative, of the loss of height since the start.

A model has *lost* 1, 5 or 10 % at the first slow time at which `sup` of u exceeds that part of δ,
by linear interpolation between the times of `loss_times`.

Accuracy.  Chain and equation are solved a second time with more coefficients or cells and a tenth
of the tolerance, and everything is measured again; the difference is the error estimate.
"""

import functools
import math
from typing import NamedTuple

import numpy as np

from granular_fronts.accuracy import Refined, with_refinement
from granular_fronts.chain.fourier_ring import FourierRing, GapError, solve_fourier_ring
from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, prepare
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_kdv_burgers import solution as log_kdv_burgers
from granular_fronts.model.amplitude_scaling import SlowScales
from granular_fronts.studies import ring_errors
from granular_fronts.studies.ring_starts import slope_of, start_fields

LOSSES = (0.01, 0.05, 0.1)
LOSS_RATIO = 2.0**0.25
"""Ratio of the slow times between which losses are interpolated, powers of which they are."""
FIRST_LOSS_TIME = 2.0**-4


class Ring(NamedTuple):
    """A wave on a ring, in units δ = c = 1.

    Attributes
    ----------
    alpha : float
        Exponent of both forces, above 1.
    damping : float
        γc, above 0.
    half_beads : int
        p; the ring has 2p − 1 beads.
    start : mapping
        Of a periodic scene.
    velocity : str
        ``leading`` or ``slow``, see `ring_starts`.
    """

    alpha: float
    damping: float
    half_beads: int
    start: dict
    velocity: str

    @property
    def scaling(self):
        """Scales of section 4."""
        return SlowScales(self.alpha, self.damping, 1.0)

    @property
    def half_length(self):
        """ℓ in ξ."""
        return self.scaling.half_length(self.half_beads)

    @property
    def beads(self):
        """N = 2p − 1."""
        return 2 * self.half_beads - 1

    @property
    def scene(self):
        """What the solvers of the equations need of a periodic scene."""
        law = {"alpha": self.alpha, "gamma": self.damping}
        return {"law": law, "displacement": 1.0} | {
            "half_beads": self.half_beads,
            "start": self.start,
        }

    @property
    def has_kinks(self):
        """Whether the start has kinks."""
        return self.start["kind"] == "plateau"


class Resolution(NamedTuple):
    """How accurately a ring is solved.

    Attributes
    ----------
    wave_number : float
        Largest one in ξ that is kept of a smooth chain.
    cell : float
        Width of the cells of the equations in ξ.
    chain_tolerance, equation_tolerance : float
        Per step.
    """

    wave_number: float
    cell: float
    chain_tolerance: float
    equation_tolerance: float

    def points(self, half_length):
        """Points of a Fourier series on the ring, even."""
        return 2 * math.ceil(half_length * self.wave_number / math.pi)

    def cells(self, half_length):
        """Cells of an equation on the ring, even."""
        return 2 * math.ceil(half_length / self.cell)


def resolutions(tolerance):
    """The usual resolution for a tolerance, and the finer one."""
    usual = Resolution(12.0, 0.125, tolerance, tolerance)
    return usual, Resolution(16.0, 0.0625, 0.1 * tolerance, 0.1 * tolerance)


class Motion(NamedTuple):
    """The chain at some times, at equally spaced bead numbers `site` that need not be whole."""

    site: np.ndarray
    relative_displacement: np.ndarray
    velocity: np.ndarray
    smallest: float
    gap_time: float


def loss_times(last):
    """Slow times, up to and including the last of all, between which losses are interpolated."""
    count = math.floor(math.log(last / FIRST_LOSS_TIME) / math.log(LOSS_RATIO) + 1e-9)
    return FIRST_LOSS_TIME * LOSS_RATIO ** np.arange(count + 1)


def compare(ring, slow_times, tolerance, xi=None):
    """Errors of every equation at some slow times.

    Parameters
    ----------
    ring : Ring
    slow_times : ndarray
        Above 0.
    tolerance : float
        Of the solvers, per step.
    xi : ndarray, optional
        Places ξ̃ of the moving frame at which u/δ of the chain is wanted too.

    Returns
    -------
    dict of str to (ndarray, ndarray)
        Values and error estimates at the slow times, by the names of `campaign.kinds`.

    Raises
    ------
    SolveError
        If a solver stops.
    """
    every = np.union1d(slow_times, loss_times(float(np.max(slow_times))))
    times, usual_and_finer = every / ring.scaling.slow_rate, resolutions(tolerance)
    motions = follow(ring, times, *usual_and_finer)
    measured = _facts(ring, motions, slow_times)
    asked = np.searchsorted(every, slow_times)
    if xi is not None:
        profiles = motions.map(lambda motion: _profiles(ring, motion, times, asked, xi))
        measured["relative_displacement"] = profiles.usual, error_of(profiles)
    for name, solve in MODELS.items():
        solutions = with_refinement(functools.partial(solve, ring, times), *usual_and_finer)
        both = [
            _errors(ring, motion, solution, every, asked)
            for motion, solution in zip(motions, solutions, strict=True)
        ]
        for key, value in both[0].items():
            measured[f"{key}_{name}"] = value, error_of(Refined(value, both[1][key]))
    return measured


def follow(ring, times, usual, finer):
    """The chain at some times, and more accurately at the same places."""
    points = usual.points(ring.half_length)
    if not ring.has_kinks and ring.beads > points:
        smooth = functools.partial(_follow_smooth, ring, times, points)
        try:
            return with_refinement(smooth, usual, finer)
        except GapError:
            pass
    return with_refinement(functools.partial(_follow_beads, ring, times), usual, finer)


def _follow_smooth(ring, times, points, resolution):
    """The chain by Fourier coefficients, at a number of places."""
    site = ring.beads * np.arange(points) / points
    fields = _start_at(ring, site)
    fourier = FourierRing(ring.alpha, ring.damping, ring.beads, resolution.points(ring.half_length))
    wave = solve_fourier_ring(fourier, *fields, times, resolution.chain_tolerance)
    return Motion(site, wave.relative_displacement, wave.velocity, wave.smallest, math.nan)


def _follow_beads(ring, times, resolution):
    """The chain bead by bead."""
    site = np.arange(1.0, ring.beads + 1.0)
    u, velocity = _start_at(ring, site)
    tolerance = resolution.chain_tolerance
    scene = {
        "law": {"alpha": ring.alpha, "beta": ring.alpha, "gamma": ring.damping},
        "beads": ring.beads,
        "boundary": {"kind": "ring"},
        "start": {"kind": "given", "relative_displacement": u, "velocity": velocity},
        "end_time": float(times[-1]),
        "tolerance": {"relative": tolerance, "absolute": 0.01 * tolerance},
        "record": {"snapshots": list(times), "extremes": True},
    }
    run = prepare(scene)
    integrate(run, scene["tolerance"])
    data = collect(scene, run)
    return Motion(
        site,
        data["relative_displacement"].values,
        data["velocity"].values,
        float(data["smallest_relative_displacement"]),
        float(data["first_gap_time"]),
    )


def _start_at(ring, site):
    xi = ring.scaling.epsilon * (site - ring.half_beads)
    return start_fields(ring.start, ring.scaling, ring.half_length, xi, ring.velocity)


def _facts(ring, motions, slow_times):
    """Numbers of the ring itself, the same at every slow time."""
    rate, scaling = ring.scaling.slow_rate, ring.scaling
    facts = {
        "epsilon_of_ring": Refined(scaling.epsilon, scaling.epsilon),
        "ratio_of_ring": Refined(scaling.ratio, scaling.ratio),
        "damping_of_ring": Refined(ring.damping, ring.damping),
        "beads_of_ring": Refined(ring.beads, ring.beads),
        "smallest_compression": motions.map(lambda motion: motion.smallest),
        "first_gap_time": motions.map(lambda motion: rate * motion.gap_time),
    }
    return {
        name: (np.full(slow_times.size, both.usual), np.full(slow_times.size, error_of(both)))
        for name, both in facts.items()
    }


def _profiles(ring, motion, times, asked, xi):
    """Compressions of the chain at places of the moving frame, by lines between its beads."""
    rows = []
    for row in asked:
        moved = np.mod(ring.scaling.frame_speed * times[row], ring.beads)
        place = xi / ring.scaling.epsilon + ring.half_beads + moved
        u = motion.relative_displacement[row]
        rows.append(np.interp(place, motion.site, u, period=ring.beads))
    return np.array(rows)


def error_of(both):
    """Difference of numbers that were computed twice, at least their rounding."""
    return np.maximum(abs(both.usual - both.finer), np.spacing(np.abs(both.usual)))


def _logarithmic(ring, times, resolution):
    return _log_burgers(ring, 1.0, times, resolution)


def _unlimited(ring, times, resolution):
    return _log_burgers(ring, ring.alpha, times, resolution)


def _log_burgers(ring, alpha, times, resolution):
    levels = log_burgers.START_LEVELS if ring.has_kinks else 0
    cells, tolerance = resolution.cells(ring.half_length), resolution.equation_tolerance
    return log_burgers.solve(ring.scene, alpha, times, cells, tolerance, levels=levels)


def _dispersive(ring, times, resolution):
    levels = log_kdv_burgers.START_LEVELS if ring.has_kinks else 0
    points, tolerance = resolution.cells(ring.half_length), resolution.equation_tolerance
    return log_kdv_burgers.solve(ring.scene, times, points, tolerance, levels=levels)


MODELS = {"logarithmic": _logarithmic, "unlimited": _unlimited, "dispersive": _dispersive}
"""Equations (41), (40) and (55), by the names of their errors."""


def _errors(ring, motion, solution, slow_times, asked):
    """All errors of one solution of an equation at the slow times asked for."""
    scaling = ring.scaling
    moved = np.mod(scaling.frame_speed * solution.times, ring.beads)
    xi = scaling.epsilon * (motion.site - ring.half_beads - moved[:, None])
    force = np.array([solution.rescaled_force(row, xi[row]) for row in range(len(xi))])
    u = scaling.displacement(np.maximum(force, 0.0))
    compression = np.maximum(motion.relative_displacement, 0.0)
    sup = ring_errors.largest(compression, u)
    found = {
        f"lost_{100 * part:g}": ring_errors.first_passage(slow_times, sup, part) for part in LOSSES
    }
    found = {
        name: np.where(time <= slow_times[asked], time, math.nan) for name, time in found.items()
    }
    start, _ = _start_at(ring, motion.site)
    chain = compression[asked]
    found |= {
        "displacement_sup": sup[asked],
        "displacement_rms": ring_errors.root_mean_square(chain, u[asked]),
        "height": ring_errors.heights(u[asked]) - ring_errors.heights(chain),
        "place": scaling.epsilon * ring_errors.lead(u[asked], chain, ring.beads / motion.site.size),
        "decay": ring_errors.relative_decay(u[asked], chain, start),
    }
    slopes = np.array(
        [slope_of(functools.partial(solution.rescaled_force, row), xi[row]) for row in asked]
    )
    corrected = scaling.corrected_velocity(force[asked], slopes)
    leading = scaling.velocity(force[asked])
    velocity = motion.velocity[asked]
    return found | {
        "velocity_sup": ring_errors.largest(velocity, corrected),
        "velocity_rms": ring_errors.root_mean_square(velocity, corrected),
        "leading_velocity_sup": ring_errors.largest(velocity, leading),
    }
