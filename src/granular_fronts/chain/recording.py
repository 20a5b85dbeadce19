"""From what a scene asks to record to the arrays of the integrator, and back to a dataset.

Variables of the dataset (names and units are given once, in `granular_fronts.output.datasets`):

- snapshots, on which steps land: `relative_displacement`, `velocity` on (t, bead);
- each probe set, by its name S: `relative_displacement_S` on (t_S, bead_S);
- each sensor, by its name S: what `sensors` reads off whole states;
- the space-time grid: `relative_displacement_grid`, `velocity_grid` on (t_grid, bead), and the
  reductions `mean_relative_displacement`, `total_velocity` on (t_grid);
- located events: `arrival_time`, `first_peak`, `first_peak_time` on (bead), `front_speed`;
  `largest_relative_displacement`, `smallest_relative_displacement`, `first_gap`, each with its
  time and bead; `first_gap_velocity`, u̇ of the contact that opens first, NaN if it parts from rest.

A contact opens where u returns to 0, James (2021), remark 6.  Shortly before a damped one pulls.
The force has a kink there, so that u̇ of the opening is less exact than the velocities after it.

Attributes.  `contacts` is how many contacts move: N − 1, or N on a ring and before a wall.
`contacts_open` is 1 where the law lets contacts open, since no force holds extended ones, else 0.

The last bead's entry of a relative displacement is the held value at the right end.  On a ring it
is the contact that closes it.  A piston is bead 1: its velocity is prescribed, and the first
relative displacement belongs to its contact.
"""

from typing import NamedTuple

import numpy as np
import xarray as xr

from granular_fronts.accuracy import rounding_floor
from granular_fronts.chain import equations, recorder
from granular_fronts.chain.recorder import END, END_TIME, RIVAL, RIVAL_TIME, STEEPNESS, TIME, VALUE
from granular_fronts.chain.sensors import read_sensors, times_of_states
from granular_fronts.errors import SolveError
from granular_fronts.numerics.grids import regular_points
from granular_fronts.numerics.records import make_record
from granular_fronts.numerics.runge_kutta import DEGREE

# The front's speed is fitted over these fractions of the chain: past the transient of the start,
# before the far end.
SPEED_RANGE = (0.5, 0.9)

# Two runs are compared at the end divided by these powers of 2.
MONITORS = np.arange(11, -1, -1)


def _grid_times(scene):
    """Return the times of the space-time grid, empty if the scene records none."""
    grid = scene.record.grid
    return regular_points(0.0, scene.end_time, grid.step) if grid else np.empty(0)


def monitor_times(scene):
    """Return the times at which two runs are compared, if events are recorded."""
    record = scene.record
    has_events = record.arrival_level is not None or record.extremes
    return np.ldexp(scene.end_time, -MONITORS) if has_events else np.empty(0)


def _probe_samples(scene):
    """Return times and beads of each probe set by name, and of all samples, set after set."""
    probes = {
        name: (regular_points(probe.start, probe.stop, probe.step), [*probe.beads])
        for name, probe in scene.record.probes.items()
    }
    times = [np.repeat(moments, len(beads)) for moments, beads in probes.values()]
    beads = [np.tile(beads, moments.size) for moments, beads in probes.values()]
    return probes, np.concatenate([[], *times]), np.concatenate([[], *beads]).astype(np.int64)


def make_recording(scene, chain, u, breaks):
    """Return arrays for all that the scene records; what is located on the way begins as NaN.

    `chain` is a record of type `state.CHAIN`, `u`, shape (columns,), the row of compressions at
    t = 0, and `breaks` are the break points of a drive.
    """
    columns, moving = u.size, u[1 : chain.contacts + 1]
    record = scene.record
    snapshots = np.asarray(record.snapshots, dtype=float)
    moments = [snapshots, _grid_times(scene), monitor_times(scene), *times_of_states(scene)]
    profile_times = np.unique(np.concatenate(moments))
    _, times, beads = _probe_samples(scene)
    order = np.argsort(times, kind="stable")
    passage = np.full((STEEPNESS + 1, columns), np.nan)
    largest, smallest = np.full((2, END_TIME + 1, columns), np.nan)
    for event, none in ((largest, -np.inf), (smallest, np.inf)):
        event[[VALUE, RIVAL]], event[END], event[END_TIME] = none, u, 0.0
    level = np.nan if record.arrival_level is None else record.arrival_level
    return recorder.Recording(
        stops=_stops(scene.end_time, np.append(snapshots, breaks)),
        profile_times=profile_times,
        profile_u=np.full((profile_times.size, columns), chain.ahead),
        profile_d=np.zeros((profile_times.size, columns)),
        sample_times=times[order],
        sample_beads=beads[order],
        samples=np.full(times.size, np.nan),
        next=make_record(recorder.NEXT, arrival=1),
        level=level,
        side=np.where(u < level, 1.0, -1.0),
        arrival=passage,
        first_peak=passage.copy(),
        opening=passage.copy(),
        largest=largest,
        smallest=smallest,
        extremes=np.array([moving.max(), moving.min()]),
        coefficients=np.zeros(DEGREE + 1),
        track_extremes=record.extremes,
        track_energy=record.balances,
    )


def _stops(end_time, times):
    """Return the times on which steps land, the end of the motion among them."""
    return np.union1d(times[(times > 0.0) & (times < end_time)], end_time)


class Recorded(NamedTuple):
    """What a run has recorded: dims and values of each variable, coordinates, attributes."""

    variables: dict
    coordinates: dict
    attributes: dict
    rounding_of_velocity: float

    @property
    def dataset(self):
        """All of it as a dataset."""
        return xr.Dataset(self.variables, self.coordinates, self.attributes)

    def values(self, name):
        """Return the values of a variable."""
        return self.variables[name][1]


def collect(run):
    """Return what a run has recorded, as `Recorded`."""
    scene, recording, next_ = run.scene, run.recording, run.recording.next
    if next_.profile < recording.profile_times.size or next_.sample < recording.samples.size:
        raise SolveError(f"The run ended at t = {run.clock.t:.17g}, before its last output.")
    contacts = int(run.chain.contacts)
    attributes = {"contacts": contacts, "contacts_open": int(not run.chain.law.attraction)}
    beads = {"bead": np.arange(1, scene.beads.count + 1)}
    recorded = Recorded({}, beads, attributes, _rounding_of_velocity(run))
    _add_profiles(recorded, scene, run)
    _add_probes(recorded, scene, run)
    for variables, coordinates in read_sensors(scene, run, _states_at):
        recorded.variables.update(variables)
        recorded.coordinates.update(coordinates)
    if not np.isnan(recording.level):
        recorded.variables.update(_arrivals(scene, recording))
    if recording.track_extremes:
        extremes = extremes_of_all(recording, contacts)
        recorded.variables.update({name: ((), value) for name, value in extremes.items()})
    return recorded


def _rounding_of_velocity(run):
    """Return one unit in the last place of the largest G_n/m_n, which w takes off ẋ, eq. (31)."""
    law, boundary, beads = run.law, run.boundary, run.beads
    compression = max(run.recording.profile_u.max(initial=0.0), boundary.left)
    damping = np.max(beads.viscosity) * equations.force(law.viscous, compression)
    return rounding_floor(damping / np.min(beads.mass))


def _states_at(run, times):
    """Return u and the velocities of all beads at times of whole states."""
    recording, inside = run.recording, slice(1, run.chain.beads + 1)
    rows = np.searchsorted(recording.profile_times, times)
    u, d = (of[rows, inside] for of in (recording.profile_u, recording.profile_d))
    return u, equations.velocities(d, u, run.boundary, run.law, run.momentum, run.beads)


def _add_profiles(recorded, scene, run):
    recording, boundary, beads = run.recording, run.boundary, scene.beads.count
    if run.beads.varied:
        recorded.variables["mass"] = ("bead",), run.beads.mass
    if boundary.holds_right:
        recording.profile_u[:, beads] = boundary.right
    snapshots, grid = np.asarray(scene.record.snapshots, dtype=float), _grid_times(scene)
    for times, along, suffix in ((snapshots, "t", ""), (grid, "t_grid", "_grid")):
        if suffix and not times.size:
            continue
        u, velocity = _states_at(run, times)
        recorded.coordinates[along] = times
        recorded.variables[f"relative_displacement{suffix}"] = (along, "bead"), u
        recorded.variables[f"velocity{suffix}"] = (along, "bead"), velocity
        if suffix:
            mean = boundary.moving(u).sum(axis=1) / beads
            recorded.variables["mean_relative_displacement"] = (along,), mean
            recorded.variables["total_velocity"] = (along,), velocity.sum(axis=1)


def _add_probes(recorded, scene, run):
    probes, times, beads = _probe_samples(scene)
    samples = np.empty(times.size)
    samples[np.argsort(times, kind="stable")] = run.recording.samples
    if run.boundary.holds_right:
        # The engine keeps the last bead itself where the held contact has its place.
        samples[beads == scene.beads.count] = run.boundary.right
    for name, (moments, places) in probes.items():
        own, samples = np.split(samples, [moments.size * len(places)])
        dims = (f"t_{name}", f"bead_{name}")
        recorded.coordinates.update(zip(dims, (moments, places), strict=True))
        values = own.reshape(moments.size, len(places))
        recorded.variables[f"relative_displacement_{name}"] = dims, values


def fitted_speed(arrival: np.ndarray) -> float:
    """Return the slope of bead number over arrival time at mid-chain."""
    return front_speed_and_error(arrival, np.zeros_like(arrival))[0]


def front_speed_and_error(arrival: np.ndarray, errors: np.ndarray) -> tuple[float, float]:
    """Return the slope of bead number over arrival time in the middle of the chain, and its error.

    Both arguments have the shape (N,), with NaN where the front has not arrived; errors of times
    count in the worst case.  The slope is NaN if fewer than two beads were passed there.  It is NaN
    too if neither end was passed first, as on a ring with two waves.
    """
    first, last = (int(fraction * arrival.size) for fraction in SPEED_RANGE)
    passed = np.arange(first, last)[np.isfinite(arrival[first:last])]
    if passed.size < 2:
        return np.nan, np.nan
    beads, times = passed - passed.mean(), arrival[passed] - arrival[passed].mean()
    slowness = (beads @ times) / (beads @ beads)
    if slowness == 0.0:
        return np.nan, np.nan
    return 1.0 / slowness, np.abs(beads) @ errors[passed] / (beads @ beads) / slowness**2


def _arrivals(scene, recording):
    every = slice(1, scene.beads.count + 1)
    arrival = recording.arrival[TIME, every]
    variables = {"arrival_time": (("bead",), arrival), "front_speed": ((), fitted_speed(arrival))}
    if recording.track_extremes:
        variables["first_peak"] = ("bead",), recording.first_peak[VALUE, every]
        variables["first_peak_time"] = ("bead",), recording.first_peak[TIME, every]
    return variables


def extremes_of_all(recording, contacts):
    """Return the largest and smallest u of all contacts and times, and the first opening."""
    opening = recording.opening[TIME, 1 : contacts + 1]
    opens = np.isfinite(opening).any()
    first = int(np.nanargmin(opening)) if opens else 0
    variables = {
        "first_gap_time": opening[first],
        "first_gap_bead": first + 1.0 if opens else np.nan,
        "first_gap_velocity": -recording.opening[STEEPNESS, 1 + first],
    }
    rounding = rounding_of(recording, contacts)
    for kind, side in (("largest", 1.0), ("smallest", -1.0)):
        event = getattr(recording, kind)[:, 1 : contacts + 1]
        values = side * event[[VALUE, RIVAL, END]]
        # Of extremes that are equal up to rounding the first one counts.
        rows, beads = np.nonzero(values >= values.max() - rounding)
        times = event[[TIME, RIVAL_TIME, END_TIME]][rows, beads]
        best = np.lexsort((beads, times))[0]
        variables[f"{kind}_relative_displacement"] = side * values[rows[best], beads[best]]
        variables[f"{kind}_relative_displacement_time"] = times[best]
        variables[f"{kind}_relative_displacement_bead"] = beads[best] + 1.0
    return variables


def rounding_of(recording, contacts):
    """Return one unit in the last place of the largest |u| of the motion."""
    return rounding_floor(
        [event[END, 1 : contacts + 1] for event in (recording.largest, recording.smallest)]
    )


def candidates(event):
    """Return values, times and beads that may hold an extreme: turns, rivals and ends."""
    value, time = event[[VALUE, RIVAL, END]].ravel(), event[[TIME, RIVAL_TIME, END_TIME]].ravel()
    bead = np.tile(np.arange(1.0, event.shape[1] + 1.0), 3)
    there = np.isfinite(value)
    return value[there], time[there], bead[there]
