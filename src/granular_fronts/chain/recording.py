"""From what a scene asks to record to the arrays of the integrator, and back to a dataset.

Variables of the dataset (names and units are given once, in `granular_fronts.output.datasets`):

- snapshots, on which steps land: `relative_displacement`, `velocity` on (t, bead);
- each probe set, by its name S: `relative_displacement_S` on (t_S, bead_S);
- the space-time grid: `relative_displacement_grid`, `velocity_grid` on (t_grid, bead), and the
  reductions `mean_relative_displacement`, `total_velocity` on (t_grid);
- located events: `arrival_time`, `first_peak`, `first_peak_time` on (bead), `front_speed`;
  `largest_relative_displacement`, `smallest_relative_displacement`, `first_gap`, each with its
  time and bead.

Attributes: `contacts`, how many contacts move, N − 1, or N on a ring; `contacts_open`, 1 where the
law lets contacts open, since no force holds extended ones, and 0 where it does not.

The last bead's entry of a relative displacement is the held value at the right end, or on a ring
the contact that closes it.  A piston is bead 1: its velocity is the prescribed one, and the first
relative displacement is that of its contact.
"""

import numpy as np
import xarray as xr

from granular_fronts.chain import equations
from granular_fronts.chain.recorder import EXTREMES, NEXT, Recording
from granular_fronts.numerics.grids import regular_points
from granular_fronts.numerics.runge_kutta import DEGREE

# The front's speed is fitted over these fractions of the chain: past the transient of the start,
# before the far end.
SPEED_RANGE = (0.5, 0.9)


def grid_times(scene):
    """Times of the space-time grid, empty if the scene records none."""
    if "grid" not in scene["record"]:
        return np.empty(0)
    return regular_points(0.0, scene["end_time"], scene["record"]["grid"]["step"])


def probe_samples(scene):
    """All samples of all probe sets: times and beads, each flat, set after set."""
    times, beads = [np.empty(0)], [np.empty(0, dtype=np.int64)]
    for probe in scene["record"].get("probes", {}).values():
        moments = regular_points(probe["start"], probe["stop"], probe["step"])
        times.append(np.repeat(moments, len(probe["beads"])))
        beads.append(np.tile(np.asarray(probe["beads"], dtype=np.int64), moments.size))
    return np.concatenate(times), np.concatenate(beads)


def make_recording(scene, ahead, u):
    """Empty arrays for everything the scene asks for.

    Parameters
    ----------
    scene : mapping
        A checked chain scene.
    ahead : float
        Compression ahead of the active window.
    u : ndarray, shape (columns,)
        Compressions at t = 0, a row of the engine.
    """
    columns = u.size
    record = scene["record"]
    snapshots = np.asarray(record["snapshots"], dtype=float)
    profile_times = np.union1d(snapshots, grid_times(scene))
    times, beads = probe_samples(scene)
    order = np.argsort(times, kind="stable")
    next_, extremes = np.zeros(1, NEXT)[0], np.full(1, np.nan).repeat(8).view(EXTREMES)[0]
    next_.arrival = 1
    extremes.largest, extremes.smallest = -np.inf, np.inf
    level = float(record.get("arrival_level", np.nan))
    return Recording(
        stops=_stops(scene, snapshots),
        profile_times=profile_times,
        profile_u=np.full((profile_times.size, columns), ahead),
        profile_d=np.zeros((profile_times.size, columns)),
        sample_times=times[order],
        sample_beads=beads[order],
        samples=np.zeros(times.size),
        next=next_,
        level=level,
        side=np.where(u < level, 1.0, -1.0),
        arrival=np.full(columns, np.nan),
        first_peak=np.full(columns, np.nan),
        first_peak_time=np.full(columns, np.nan),
        extremes=extremes,
        coefficients=np.zeros(DEGREE + 1),
        track_extremes=bool(record.get("extremes", False)),
        track_energy=bool(record.get("balances", False)),
    )


def _stops(scene, snapshots):
    """Times on which steps land: snapshots, the end of a piston's ramp, the end of the motion."""
    end_time, ramp = float(scene["end_time"]), float(scene["boundary"].get("ramp", 0.0))
    inside = np.append(snapshots, ramp)
    return np.union1d(inside[(inside > 0.0) & (inside < end_time)], end_time)


def collect(scene, run):
    """The dataset of everything that a run of a scene has recorded.

    Parameters
    ----------
    scene : mapping
    run : chain.run.Run

    Returns
    -------
    xarray.Dataset
    """
    recording = run.recording
    beads = np.arange(1, scene["beads"] + 1)
    dataset = xr.Dataset(coords={"bead": beads})
    dataset = dataset.merge(_profiles(scene, run))
    dataset = dataset.merge(_probes(scene, recording))
    if not np.isnan(recording.level):
        dataset = dataset.merge(_arrivals(scene, recording))
    if recording.track_extremes:
        dataset = dataset.merge(_extremes(recording.extremes))
    return dataset.assign_attrs(
        contacts=int(run.chain.contacts), contacts_open=int(not run.chain.law.attraction)
    )


def _profiles(scene, run):
    recording, boundary, beads = run.recording, run.boundary, scene["beads"]
    u = recording.profile_u[:, 1 : beads + 1]
    d = recording.profile_d[:, 1 : beads + 1]
    if not boundary.ring:
        u[:, -1] = boundary.right
    times = recording.profile_times
    velocity = equations.velocities(d, u, boundary, run.law, run.momentum, times)
    snapshots = np.asarray(scene["record"]["snapshots"], dtype=float)
    rows = np.searchsorted(recording.profile_times, snapshots)
    variables = {
        "relative_displacement": (("t", "bead"), u[rows]),
        "velocity": (("t", "bead"), velocity[rows]),
    }
    coordinates = {"t": snapshots}
    grid = grid_times(scene)
    if grid.size:
        rows = np.searchsorted(recording.profile_times, grid)
        moving = u if boundary.ring else u[:, :-1]
        variables |= {
            "relative_displacement_grid": (("t_grid", "bead"), u[rows]),
            "velocity_grid": (("t_grid", "bead"), velocity[rows]),
            "mean_relative_displacement": ("t_grid", moving[rows].sum(axis=1) / beads),
            "total_velocity": ("t_grid", velocity[rows].sum(axis=1)),
        }
        coordinates["t_grid"] = grid
    return xr.Dataset(variables, coordinates)


def _probes(scene, recording):
    times, _ = probe_samples(scene)
    samples = np.empty(times.size)
    samples[np.argsort(times, kind="stable")] = recording.samples
    dataset, first = xr.Dataset(), 0
    for name, probe in scene["record"].get("probes", {}).items():
        moments = regular_points(probe["start"], probe["stop"], probe["step"])
        shape = (moments.size, len(probe["beads"]))
        last = first + moments.size * len(probe["beads"])
        dataset[f"relative_displacement_{name}"] = xr.DataArray(
            samples[first:last].reshape(shape),
            coords={f"t_{name}": moments, f"bead_{name}": probe["beads"]},
        )
        first = last
    return dataset


def fitted_speed(arrival):
    """Slope of bead number over arrival time in the middle of the chain.

    NaN if fewer than two beads were passed there, or if neither end was passed first, as on a ring
    with two waves.

    Parameters
    ----------
    arrival : ndarray, shape (N,)
        NaN where the front has not arrived.
    """
    first, last = (int(fraction * arrival.size) for fraction in SPEED_RANGE)
    passed = np.arange(first, last)[np.isfinite(arrival[first:last])]
    if passed.size < 2:
        return np.nan
    beads, times = passed - passed.mean(), arrival[passed] - arrival[passed].mean()
    slowness = (beads @ times) / (beads @ beads)
    return 1.0 / slowness if slowness != 0.0 else np.nan


def _arrivals(scene, recording):
    beads = scene["beads"]
    arrival = recording.arrival[1 : beads + 1]
    speed = fitted_speed(arrival)
    variables = {"arrival_time": ("bead", arrival), "front_speed": speed}
    if recording.track_extremes:
        variables["first_peak"] = ("bead", recording.first_peak[1 : beads + 1])
        variables["first_peak_time"] = ("bead", recording.first_peak_time[1 : beads + 1])
    return xr.Dataset(variables)


def _extremes(extremes):
    variables = {"first_gap_time": extremes.gap_time, "first_gap_bead": extremes.gap_bead}
    for kind in ("largest", "smallest"):
        for part in ("", "_time", "_bead"):
            variables[f"{kind}_relative_displacement{part}"] = float(extremes[f"{kind}{part}"])
    return xr.Dataset(variables)
