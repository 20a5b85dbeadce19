r"""How far a ring of beads is from its amplitude equations, as α → 1.

A ring is followed as the chain itself and by three equations for the rescaled force y.  All have
the same start and the units δ = c = 1: (41), (40), and the logarithmic KdV–Burgers equation (55),
which in ξ and τ is (41) with the dispersion :math:`\mu^{-2} = (\varepsilon/\gamma c)/12`.

The chain is followed bead by bead.  A smooth wave is followed by its Fourier coefficients
(`chain.fourier_ring`) where wave numbers up to 12 in ξ mean waves longer than two beads.  It is
compared at eight times as many places.  A contact that opens ends the smoothness.  Such a ring is
followed bead by bead.  A gap counts as no compression, since no equation for u^α can have one.

Errors at a slow time τ, each against the chain at its beads, or at those places.  A maximum over
places is that of the parabola through the three highest, so that it is one over all chains between
the beads: at ε = ¼ it is larger by 0.5 % for a pulse.  Therefore a map over μ has a step where
:math:`12\varepsilon = \pi`, from which on the maximum is one over beads.

- `sup` and `rms` of :math:`u_n/\delta`, and of :math:`\dot x_n/(\delta c)` with the velocities of
  the equation to first order; `leading` is the sup of the velocities (51);
- `height`, of the largest u, at the vertex of the parabola through the three highest places;
- `place`, in ξ, of the last fall of u through the middle between the equation's extremes, within
  half a turn of its highest point;
- `decay`, relative, of the loss of height since the start.

Heights and places are interpolated alike in the two waves that are compared, so that what
interpolation adds all but cancels.

The mean difference of velocities to first order is subtracted.  A constant is momentum of the whole
ring, which no formula in y knows.  The formulas are measured too, without any equation or means, on
the chain's own :math:`y = u^\alpha` with its slope by Fourier series.  They are `residual_leading`
of (51), `residual_printed` of (43), and `residual_first_order` of the whole first order
(`model.amplitude_scaling`).

A model has *lost* 1, 5 or 10 % at the first slow time at which `sup` of u exceeds that part of δ.
It is interpolated linearly between the times of `_loss_times`.

Accuracy.  Chain and equation are solved again with more coefficients or cells and a tenth of the
tolerance, a ring of single beads by two steps for each.  Everything is measured again, at fewer
places and on every other of `_loss_times`.  The difference is the error estimate, so that it
contains the error of interpolation.  Two maxima may agree by chance, and so may two means of
squares.  So their error is at least the maximum, or the mean, of the difference of the two fields
at the places that both have.  A place is wrong by at least the difference next to the steepest
fall, over its slope, and in a smooth ring by what lines between places miss, as a rule 2 to 40
times the true error.  Lines between single beads are part of what a place is there.  The errors of
the smallest compression and of the first gap of a ring followed bead by bead are those of a chain.
"""

import math
from functools import partial
from operator import attrgetter, itemgetter
from typing import NamedTuple

import numpy as np
from scipy.fft import irfft, rfft, rfftfreq
from scipy.special import xlogy

from granular_fronts.accuracy import Estimate, Refined, refined_by, with_refinement
from granular_fronts.chain.event_errors import event_errors
from granular_fronts.chain.fourier_ring import FourierRing, GapError, solve_fourier_ring
from granular_fronts.chain.measures import last_fall
from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, integrate_in_halves, prepare
from granular_fronts.continuum import evolution
from granular_fronts.continuum.log_burgers import solution as log_burgers
from granular_fronts.continuum.log_kdv_burgers import solution as log_kdv_burgers
from granular_fronts.model.amplitude_scaling import SlowScales
from granular_fronts.scenes.ring import PlateauStart, RingStart
from granular_fronts.studies.chain_scenes import chain_scene, kuwabara_kono
from granular_fronts.studies.ring_starts import slope_of, start_fields

LOSSES = (0.01, 0.05, 0.1)
NEAR = 2
"""Places at either side of the highest at which two solutions are compared for the error of it."""
LOSS_RATIO = 2.0**0.25
"""Ratio of the slow times between which losses are interpolated, powers of which they are."""
FIRST_LOSS_TIME = 2.0**-4

MODELS = {
    evolution.LOGARITHMIC: log_burgers.START_LEVELS,
    evolution.UNLIMITED: log_burgers.START_LEVELS,
    evolution.DISPERSIVE: log_kdv_burgers.START_LEVELS,
}
"""Equations (41), (40) and (55), and how often the cells of each are halved for kinks."""


class Ring(NamedTuple):
    """A wave on a ring, in units δ = c = 1."""

    alpha: float  # exponent of both forces, above 1
    damping: float  # γc, above 0
    half_beads: int  # p; the ring has 2p − 1 beads
    start: RingStart
    velocity: str  # ``leading`` or ``slow``, see `ring_starts`

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
    def has_kinks(self):
        """Whether the start has kinks."""
        return isinstance(self.start, PlateauStart)


class Resolution(NamedTuple):
    """How accurately a ring is solved."""

    wave_number: float  # largest one in ξ that is kept of a smooth chain
    places: int  # for each point of the Fourier series, places at which a smooth chain is compared
    cell: float  # width of the cells of the equations in ξ
    chain_tolerance: float  # per step, as the next
    equation_tolerance: float

    def points(self, half_length):
        """Return the points of a Fourier series on the ring, a multiple of 16."""
        return 16 * math.ceil(half_length * self.wave_number / (8.0 * math.pi))

    def cells(self, half_length):
        """Return the cells of an equation on the ring, even."""
        return 2 * math.ceil(half_length / self.cell)

    def holds_between_beads(self, epsilon):
        """Whether the largest wave number is that of waves longer than two beads, all damped."""
        return self.wave_number * epsilon < math.pi


def resolutions(tolerance):
    """Return the usual resolution for a tolerance, and the finer one."""
    usual = Resolution(12.0, 8, 0.125, tolerance, tolerance)
    return usual, Resolution(16.0, 4, 0.0625, 0.1 * tolerance, 0.1 * tolerance)


class Motion(NamedTuple):
    """The chain at some times, at equally spaced bead numbers `site` that need not be whole."""

    site: np.ndarray
    relative_displacement: np.ndarray
    velocity: np.ndarray
    smallest: Estimate
    gap_time: float = math.nan
    events: tuple | None = None  # Scene, recording and ends of steps of a ring of single beads.

    @property
    def is_smooth(self):
        """Whether places lie between the beads."""
        return self.events is None


def _loss_times(last):
    """Return the slow times, the last included, between which losses are interpolated."""
    count = math.floor(math.log(last / FIRST_LOSS_TIME) / math.log(LOSS_RATIO) + 1e-9)
    return FIRST_LOSS_TIME * LOSS_RATIO ** np.arange(count + 1)


def compare(ring, slow_times, tolerance, xi=None, resolve=resolutions):
    """Return values and error estimates at slow times above 0, by the names of `campaign.kinds`.

    `xi` are places ξ̃ of the moving frame at which u/δ of the chain is wanted too.  `resolve`
    makes the usual and the finer resolution of the tolerance.
    """
    passages = _loss_times(float(np.max(slow_times)))
    every = np.union1d(slow_times, passages)
    times, (usual, finer) = every / ring.scaling.slow_rate, resolve(tolerance)
    motions = follow(ring, times, usual, finer)
    kept, passed = np.searchsorted(every, slow_times), np.searchsorted(every, passages)
    measured = _facts(ring, motions, slow_times)
    residuals = motions.map(lambda motion: velocity_residuals(ring, motion, kept))
    for key in residuals.usual:
        field = residuals.map(itemgetter(key))
        measured[key] = _over_places(field, partial(largest, between=motions.usual.is_smooth))
    if xi is not None:
        profiles = motions.map(lambda motion: _profiles(ring, motion, times, kept, xi))
        measured["relative_displacement"] = profiles.usual, _error_of(profiles)
    for name in MODELS:
        solve = partial(_solve, ring, name, times)
        solutions = refined_by(partial(solve, finer), solve(usual))
        pairs = list(zip(motions, solutions, strict=True))
        fields = Refined(*(_fields(ring, *pair, kept) for pair in pairs))
        numbers = Refined(
            *(
                _numbers(ring, *pair, kept) | _losses(ring, *pair, slow_times, rows)
                for pair, rows in zip(pairs, (passed, passed[1::2]), strict=True)
            )
        )
        found = {key: _estimated(numbers.map(itemgetter(key))) for key in numbers.usual}
        sup = partial(largest, between=motions.usual.is_smooth)
        for key in fields.usual:
            found[f"{key}_sup"] = _over_places(fields.map(itemgetter(key)), sup)
        for key in ("displacement", "velocity"):
            found[f"{key}_rms"] = _over_places(fields.map(itemgetter(key)), root_mean_square)
        chain, field = (
            motions.usual.relative_displacement[kept],
            fields.map(itemgetter("displacement")),
        )
        found |= _heights(found, _near(field, chain.argmax(axis=1)))
        cell, drops = 2.0 * ring.half_length / chain.shape[1], chain - np.roll(chain, -1, axis=1)
        place, error = found["place"]
        moved = _near(field, drops.argmax(axis=1))
        if motions.usual.is_smooth:
            # A line misses up to an eighth of the second difference, alike in both waves but for
            # what the one is ahead.
            shift = np.minimum(0.5 * np.abs(place) / cell, 0.125)
            moved += 0.125 * _bend(field.usual) + shift * _bend(chain)
        found["place"] = place, np.maximum(error, moved * cell / drops.max(axis=1))
        measured |= {f"{key}_{name}": value for key, value in found.items()}
    return measured


def _estimated(both):
    """Return numbers and the errors that their refinement shows."""
    return both.usual, _error_of(both)


def _over_places(field, reduce):
    """Return a maximum or mean over places at each time, and its error, by a finer field.

    The error is at least the same reduction of their difference at the places that both have.
    """
    value, error = _estimated(field.map(reduce))
    return value, np.maximum(error, reduce(_change(field)))


def _change(field):
    """Return the difference of a field to a finer one at the places that both have."""
    common = math.gcd(*(rows.shape[1] for rows in field))
    usual, finer = (rows[:, :: rows.shape[1] // common] for rows in field)
    return usual - finer


def _near(field, places):
    """Return the largest change of a field next to a place at each time."""
    change = np.abs(_change(field))
    among = places * change.shape[1] // field.usual.shape[1]
    beside = (among[:, None] + np.arange(-NEAR, NEAR + 1)) % change.shape[1]
    return np.take_along_axis(change, beside, axis=1).max(axis=1)


def _bend(rows):
    """Return the largest second difference of places at each time."""
    return np.abs(np.diff(rows, 2, axis=1)).max(axis=1)


def _heights(found, change):
    """Return height and decay, whose errors are at least those of so large a change of heights.

    The decay is the height over the loss of height of the chain.
    """
    (height, error), (decay, of_decay) = found["height"], found["decay"]
    error = np.maximum(error, change)
    with np.errstate(divide="ignore", invalid="ignore"):
        of_decay = np.fmax(of_decay, np.abs(decay / height) * error)
    return {"height": (height, error), "decay": (decay, of_decay)}


def follow(ring, times, usual, finer):
    """Return the chain at some times, and more accurately at the same places."""
    if not ring.has_kinks and usual.holds_between_beads(ring.scaling.epsilon):
        smooth = partial(_follow_smooth, ring, times)
        try:
            return with_refinement(smooth, usual, finer)
        except GapError:
            pass
    found = _follow_beads(ring, times, usual)
    return refined_by(lambda found: _follow_beads(ring, times, usual, found.events[2]), found)


def _follow_smooth(ring, times, resolution):
    """Return the chain by Fourier coefficients, at several places for each."""
    points = resolution.points(ring.half_length)
    places = resolution.places * points
    site = ring.beads * np.arange(places) / places
    fields = _start_at(ring, site)
    fourier = FourierRing(ring.alpha, ring.damping, ring.beads, points)
    wave = solve_fourier_ring(fourier, *fields, times, resolution.chain_tolerance)
    return Motion(site, wave.relative_displacement, wave.velocity, wave.smallest)


def _follow_beads(ring, times, resolution, ends=None):
    """Return the chain bead by bead, by two steps for each of a run whose steps had those ends."""
    site = np.arange(1.0, ring.beads + 1.0)
    tolerance = resolution.chain_tolerance
    scene = chain_scene(
        kuwabara_kono(ring.alpha, ring.damping),
        ring.beads,
        {"kind": "ring"},
        float(times[-1]),
        (tolerance, 0.01 * tolerance),
        {"snapshots": list(times), "extremes": True},
        _start_at(ring, site),
    )
    run = prepare(scene)
    if ends is None:
        ends = integrate(run, run.scene.tolerance)
    else:
        integrate_in_halves(run, run.scene.tolerance, ends)
    data = collect(run).dataset
    return Motion(
        site,
        data["relative_displacement"].values,
        data["velocity"].values,
        Estimate(float(data["smallest_relative_displacement"]), 0.0),
        gap_time=float(data["first_gap_time"]),
        events=(run.scene, run.recording, ends),
    )


def _start_at(ring, site):
    xi = ring.scaling.epsilon * (site - ring.half_beads)
    return start_fields(ring.start, ring.scaling, ring.half_length, xi, ring.velocity)


def _facts(ring, motions, slow_times):
    """Return the numbers of the ring itself, the same at every slow time."""
    rate, scaling = ring.scaling.slow_rate, ring.scaling
    known = {
        "epsilon_of_ring": scaling.epsilon,
        "ratio_of_ring": scaling.ratio,
        "damping_of_ring": ring.damping,
        "beads_of_ring": ring.beads,
    }
    facts = {name: _estimated(Refined(value, value)) for name, value in known.items()}
    (smallest, own), (finer, other) = motions.map(attrgetter("smallest"))
    least_error = own + other
    gap_time, of_gap = _estimated(motions.map(attrgetter("gap_time")))
    if not motions.usual.is_smooth:
        scene, recording, _ = motions.usual.events
        errors = event_errors(scene, recording, motions.finer.events[1], ring.beads)
        least_error, of_gap = errors["smallest_relative_displacement"], errors["first_gap_time"]
    facts["smallest_compression"] = smallest, least_error + abs(smallest - finer)
    facts["first_gap_time"] = rate * gap_time, rate * of_gap
    return {
        name: tuple(np.full(slow_times.size, number) for number in both)
        for name, both in facts.items()
    }


def _profiles(ring, motion, times, kept, xi):
    """Return the chain's compressions at places of the moving frame, by lines between beads."""
    rows = []
    for row in kept:
        moved = np.mod(ring.scaling.frame_speed * times[row], ring.beads)
        place = xi / ring.scaling.epsilon + ring.half_beads + moved
        u = motion.relative_displacement[row]
        rows.append(np.interp(place, motion.site, u, period=ring.beads))
    return np.array(rows)


def _error_of(both):
    """Return the difference of numbers that were computed twice, at least their rounding."""
    with np.errstate(invalid="ignore"):
        return np.maximum(abs(both.usual - both.finer), np.spacing(np.abs(both.usual)))


def _solve(ring, equation, times, resolution, coarser=None):
    """Return one equation on the ring; without kinks the start needs no finer cells."""
    return evolution.solve(
        ring,
        equation,
        times,
        resolution.cells(ring.half_length),
        resolution.equation_tolerance,
        MODELS[equation] if ring.has_kinks else 0,
        coarser,
    )


def velocity_residuals(ring, motion, rows):
    """Return the difference of ẋ to each formula in the chain's own y, less its mean, by row."""
    scaling, sites = ring.scaling, motion.site.size
    y = np.maximum(motion.relative_displacement[rows], 0.0) ** ring.alpha
    wave_numbers = 2.0 * np.pi * rfftfreq(sites, 2.0 * ring.half_length / sites)
    slope = irfft(1j * wave_numbers * rfft(y), sites)
    formulas = {
        "leading": scaling.velocity(y),
        "printed": scaling.corrected_velocity(y, slope, slope),
        "first_order": scaling.corrected_velocity(y, slope, xlogy(y, y)),
    }
    return {
        f"residual_{name}": _centred(motion.velocity[rows] - value)
        for name, value in formulas.items()
    }


def _centred(rows):
    """Return each row less its mean."""
    return rows - rows.mean(axis=1, keepdims=True)


def _force(ring, motion, solution, rows):
    """Return places ξ̃ of the chain and rescaled forces of an equation there, at some times."""
    moved = np.mod(ring.scaling.frame_speed * solution.times[rows], ring.beads)
    xi = ring.scaling.epsilon * (motion.site - ring.half_beads - moved[:, None])
    force = [solution.rescaled_force(row, there) for row, there in zip(rows, xi, strict=True)]
    return xi, np.array(force)


def _compressions(ring, motion, force, rows):
    """Return compressions of the chain and of an equation at some rows; a gap counts as none."""
    chain = np.maximum(motion.relative_displacement[rows], 0.0)
    return chain, ring.scaling.displacement(np.maximum(force, 0.0))


def _losses(ring, motion, solution, slow_times, rows):
    """Return the slow times at which an equation has lost so much, NaN if after `slow_times`."""
    times, sup = ring.scaling.slow_rate * solution.times[rows], np.array([])
    if rows.size:
        _, force = _force(ring, motion, solution, rows)
        chain, u = _compressions(ring, motion, force, rows)
        sup = largest(chain - u, motion.is_smooth)
    passages = {part: first_passage(times, sup, part) for part in LOSSES}
    return {
        f"lost_{100 * part:g}": np.where(time <= slow_times, time, math.nan)
        for part, time in passages.items()
    }


def _fields(ring, motion, solution, rows):
    """Return differences of the chain to one solution of an equation, at some rows of its times."""
    scaling = ring.scaling
    xi, force = _force(ring, motion, solution, rows)
    chain, u = _compressions(ring, motion, force, rows)
    slopes = np.array(
        [
            slope_of(partial(solution.rescaled_force, row), there)
            for row, there in zip(rows, xi, strict=True)
        ]
    )
    flux = xlogy(np.maximum(force, 0.0), np.maximum(force, 0.0))
    velocity = motion.velocity[rows]
    return {
        "displacement": chain - u,
        "velocity": _centred(velocity - scaling.corrected_velocity(force, slopes, flux)),
        "leading_velocity": velocity - scaling.velocity(force),
    }


def _numbers(ring, motion, solution, rows):
    """Return height, place and decay of one solution of an equation against those of the chain."""
    _, force = _force(ring, motion, solution, rows)
    chain, u = _compressions(ring, motion, force, rows)
    start, _ = _start_at(ring, motion.site)
    return {
        "height": heights(u) - heights(chain),
        "place": ring.scaling.epsilon * lead(u, chain, ring.beads / motion.site.size),
        "decay": relative_decay(u, chain, start),
    }


# Distances between two waves at equally spaced places, a row for each time.


def largest(difference, between):
    """Return the largest size of a difference at each time, at or between its places."""
    size = np.abs(difference)
    return heights(size) if between else size.max(axis=1)


def root_mean_square(difference):
    """Return the root mean square of a difference at each time."""
    return np.sqrt((difference**2).mean(axis=1))


def heights(rows):
    """Return the largest value at each time."""
    return np.array([_height(row) for row in np.atleast_2d(rows)])


def _height(row):
    i = int(np.argmax(row))
    left, top, right = (row[(i + k) % row.size] for k in (-1, 0, 1))
    curvature = left - 2.0 * top + right
    return top - (left - right) ** 2 / (8.0 * curvature) if curvature < 0.0 else top


def relative_decay(model, chain, start):
    """Return the loss of height since the start, model over chain, minus 1."""
    [first] = heights(start)
    with np.errstate(divide="ignore", invalid="ignore"):
        return (first - heights(model)) / (first - heights(chain)) - 1.0


def lead(model, chain, spacing):
    """By how much the model is ahead of the chain at each time; NaN where there is no such fall."""
    return np.array([_lead(*rows) * spacing for rows in zip(model, chain, strict=True)])


def _lead(model, chain):
    half = model.size // 2
    turn, level = half - int(np.argmax(model)), 0.5 * (model.max() + model.min())
    return _last_fall(np.roll(model, turn), level) - _last_fall(np.roll(chain, turn), level)


def _last_fall(row, level):
    """Return index, interpolated, of the last fall of a row through a level; NaN without one."""
    try:
        return last_fall(row, np.arange(row.size), level)
    except IndexError:
        return math.nan


def first_passage(times, errors, level):
    """Return the first time at which an error, 0 at time 0, exceeds a level, or NaN."""
    above = np.flatnonzero(errors > level)
    if not above.size:
        return np.nan
    t, e = np.append(0.0, times), np.append(0.0, errors)
    row = above[0] + 1
    return float(t[row - 1] + (t[row] - t[row - 1]) * (level - e[row - 1]) / (e[row] - e[row - 1]))
