"""Random chains: stated errors, and true ones by `reference_methods.extended`."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from numpy.random import Generator, default_rng

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import InputError, SolveError
from granular_fronts.reference_methods.extended import Motion, Passages

Scene = dict[str, Any]
Number = tuple[str, float, float, float]
"""Name, stated error, true error, and the largest value that it was found among."""

EXPONENTS = (1.0, 1.2, 1.5, 1.5, 2.0, 2.5)
# Front speeds are fitted between these parts of a chain.
FITTED = (0.5, 0.9)
# Part of the size of a motion below which the reference resolves nothing.
RESOLVED = 1e-17
# Above it a contact that touches at the start has parted.
PARTED = 1e-15


def _random_law(rng: Generator) -> tuple[Scene, float]:
    """Return a law, and the size of the compressions that suit it."""
    gamma = float(rng.choice([0.0, 1.0, 1.0, 1.0, 1.0])) * 10 ** rng.uniform(-2, 0.3)
    gamma = 10 ** rng.uniform(0.3, 1.5) if rng.random() < 0.07 else gamma
    alpha, beta = map(float, rng.choice(EXPONENTS, 2))
    if rng.random() < 0.2:
        alpha, beta = rng.uniform(1, 2.5, 2).round(3).tolist()
    size, kind = 10 ** rng.uniform(-1.3, 0), rng.integers(10)
    if kind < 4:
        return {"alpha": alpha, "beta": beta if kind < 2 else alpha, "gamma": gamma}, size
    hertz = {"kind": "hertz", "alpha": alpha, "stiffness": rng.uniform(0.5, 2)}
    if kind < 6:
        viscous = rng.choice(["linear", "simon_hunt_crossley", "kuwabara_kono", "none"])
        return {"elastic": hertz, "viscous": _viscous(viscous, gamma)}, size
    toda = {"kind": "toda", "strength": rng.uniform(0.5, 2), "rate": rng.uniform(0.5, 2)}
    fpu = {"kind": "fpu", "cubic": rng.uniform(-0.8, 0.8), "quartic": rng.uniform(0.3, 1)}
    morse = {"kind": "morse", "depth": rng.uniform(0.3, 1), "rate": rng.uniform(0.5, 1.5)}
    lennard_jones = {"kind": "lennard_jones", "depth": 0.1, "distance": rng.uniform(1, 3)}
    elastic, size = ((toda, 0.5), (fpu, 0.7), (morse, 0.15), (lennard_jones, 0.08))[kind - 6]
    viscous = _viscous(rng.choice(["linear", "proportional", "none", "power"]), gamma, beta)
    return {"elastic": elastic, "viscous": viscous}, size * rng.uniform(0.3, 1)


def _viscous(kind: str, gamma: float, beta: float = 1.5) -> Scene:
    own: Scene = {"none": {}, "power": {"beta": beta, "gamma": gamma}}
    return {"kind": str(kind)} | own.get(kind, {"gamma": gamma})


def random_scene(rng: Generator) -> Scene:
    """Return a scene of the schema, small enough for the reference."""
    law, size = _random_law(rng)
    beads = int(rng.integers(2, 13) if rng.random() < 0.8 else rng.integers(13, 31))
    end = round(10 ** rng.uniform(-1, 1.5), int(rng.integers(1, 4)))
    end = 12.6 if rng.random() < 0.05 else end
    kind = str(rng.choice(["pressure", "pressure", "ring", "piston"]))
    boundary: Scene = {"kind": kind}
    if kind == "pressure":
        boundary |= {"left": size * rng.uniform(0.3, 1), "right": size * float(rng.random() < 0.3)}
    elif kind == "piston":
        boundary |= {"velocity": size * rng.uniform(0.3, 1)}
        boundary |= {"ramp": end * rng.uniform(0.05, 1.2)} if rng.random() < 0.5 else {}
    start: Scene = {"kind": "rest"}
    if kind == "ring" or rng.random() < 0.4:
        u = size * rng.uniform(-0.3, 1, beads if kind == "ring" else beads - 1)
        velocity = size * rng.uniform(-1, 1, beads)
        if kind == "piston":
            velocity[0] = 0.0 if boundary.get("ramp") else boundary["velocity"]
        start = {"kind": "given", "relative_displacement": u.tolist()}
        start["velocity"] = velocity.tolist()
    relative = 10 ** rng.uniform(-12, -3)
    snapshots = {end, *(end * 10 ** rng.uniform(-2, 0, int(rng.integers(1, 4))))}
    record: Scene = {"snapshots": sorted(map(float, snapshots)), "extremes": True}
    record |= {"balances": bool(rng.random() < 0.3)}
    if rng.random() < 0.5:
        record["grid"] = {"step": 0.1 if 0.5 < end < 20 else end / 7}
    if rng.random() < 0.5:
        stop = end if rng.random() < 0.5 else end * rng.uniform(0.1, 1)
        beads_probed = rng.choice(beads, min(2, beads), replace=False) + 1
        probe = {"beads": sorted(beads_probed.tolist()), "start": 0.0, "stop": stop}
        record["probes"] = {"near": probe | {"step": stop / int(rng.integers(3, 12))}}
    if rng.random() < 0.7:
        record["arrival_level"] = size * rng.uniform(0.05, 0.4)
    scene = _unlike_beads(rng, beads, boundary, start, size) | {
        "law": law,
        "end_time": end,
        "tolerance": {"relative": relative, "absolute": size * relative * 10 ** rng.uniform(-3, 0)},
        "record": record,
    }
    return _touched_and_driven(rng, scene, size)


def _touched_and_driven(rng: Generator, scene: Scene, size: float) -> Scene:
    """Return a scene some of whose contacts touch at the start, or that is driven."""
    start, boundary, end = scene["start"], scene["boundary"], scene["end_time"]
    if start["kind"] == "given" and rng.random() < 0.5:
        u = np.array(start["relative_displacement"])
        start["relative_displacement"] = np.where(rng.random(u.size) < 0.7, 0.0, u).tolist()
    if boundary["kind"] != "ring" and start["kind"] == "rest" and rng.random() < 0.5:
        key = "velocity" if boundary["kind"] == "piston" else "force"
        kind = "force" if boundary["kind"] == "pressure" else boundary["kind"]
        held = {} if kind == "wall" else {"right": boundary.get("right", 0.0)}
        scene["boundary"] = {"kind": kind, key: _random_drive(rng, size, end, key)} | held
    return scene


def _random_drive(rng: Generator, size: float, end: float, key: str) -> Scene:
    """Return a function of time of any kind; one of a velocity does not jump."""
    height, time = size * rng.uniform(0.3, 1), end * rng.uniform(0.1, 1.2)
    times = np.cumsum(rng.uniform(0.05, 0.5, 4)) * end
    values = height * np.append(rng.choice([0.0, 1.0]), rng.uniform(-0.5, 1, 3))
    drives = {
        "half_sine": {"amplitude": height, "duration": time},
        "harmonic": {
            "amplitude": height,
            "angular_frequency": rng.uniform(0.2, 3),
            "phase": rng.uniform(-1, 1),
            "offset": height * rng.uniform(0, 1.5),
        },
        "table": {"times": times.tolist(), "values": values.tolist()},
        "pulse": {"height": height, "duration": time},
    }
    kind = str(rng.choice([*drives][: 4 if key == "force" else 3]))
    return {kind: drives[kind]}


def _unlike_beads(rng: Generator, beads: int, boundary: Scene, start: Scene, size: float) -> Scene:
    """Return beads, boundary, contacts, body force and start, where a third of all chains vary."""
    scene: Scene = {"beads": beads, "boundary": boundary, "start": start}
    if rng.random() < 0.67:
        return scene

    def drawn(count: int) -> Scene:
        return {"list": (10 ** rng.uniform(-1.5, 0.5, count)).tolist()}

    scene["beads"] = {"count": beads, "mass": drawn(beads)}
    if boundary["kind"] == "pressure" and start["kind"] == "rest" and rng.random() < 0.5:
        scene["boundary"] = {"kind": "wall", "left": boundary["left"]}
        scene["gravity"] = 0.1 * size * rng.uniform(0, 1)
        if rng.random() < 0.5:
            striker = {"kind": "striker", "beads": 1, "velocity": size}
            free = {"kind": "wall", "left": 0.0}
            scene |= {"start": striker, "boundary": free, "gravity": 0.0}
    if rng.random() < 0.5:
        contacts = beads - (scene["boundary"]["kind"] not in ("ring", "wall"))
        scene["contacts"] = {"elastic": drawn(contacts)}
        scene["contacts"] |= {"viscous": drawn(contacts)} if rng.random() < 0.5 else {}
    return scene


def _states(data: xr.Dataset, motion: Motion) -> Scene:
    """Return what the variables of a dataset should hold, but for events."""
    true: Scene = {"mass": motion.mass}
    for name in ("", "_grid", "_near"):
        variable = data.get(f"relative_displacement{name}")
        if variable is None:
            continue
        u, velocity = motion.states(data[variable.dims[0]].values)
        held = np.full((len(u), motion.beads - u.shape[1]), motion.right)
        places = data[variable.dims[1]].values - 1
        true[f"relative_displacement{name}"] = np.column_stack([u, held])[:, places]
        true[f"velocity{name}"] = velocity
        if name == "_grid":
            true["mean_relative_displacement"] = u.sum(axis=1) / motion.beads
            true["total_velocity"] = velocity.sum(axis=1)
    return true


def _events(scene: Scene, data: xr.Dataset, motion: Motion) -> Scene:
    """Return the arrivals, first peaks, extremes and the first gap.

    Where two extremes are equal within the stated error, time and bead may belong to either; the
    nearer one counts.
    """
    turns, opened = motion.passages(), motion.passages(0.0)
    true: Scene = {}
    opens = (opened.direction < 0) & (np.abs(opened.rate) > 1e-15 * motion.size)
    parted, contacts, part_at = _parted(motion)
    times = np.concatenate([opened.time[opens], parted])
    beads = np.concatenate([opened.contact[opens], contacts]) + 1
    rates = np.concatenate([opened.rate[opens], part_at])
    first = np.lexsort((np.abs(beads - data["first_gap_bead"].item()), times))[:1]
    for part, of in (("time", times), ("bead", beads), ("velocity", rates)):
        true[f"first_gap_{part}"] = of[first[0]] if first.size else np.nan
    ends = motion.states([0.0, scene["end_time"]])[0]
    contact = np.concatenate([turns.contact, np.tile(np.arange(ends.shape[1]), 2)])
    time = np.concatenate([turns.time, np.repeat([0.0, scene["end_time"]], ends.shape[1])])
    u = np.concatenate([turns.u, ends.ravel()])
    for name, sign in (("largest", 1), ("smallest", -1)):
        name = f"{name}_relative_displacement"
        extreme = (sign * u).max()
        slack = 2 * data[name].attrs["error_estimate"] + 4 * np.spacing(float(abs(extreme)))
        near = sign * u >= extreme - slack - RESOLVED * motion.size
        distances = (
            np.abs(found[near] - data[f"{name}_{part}"].item())
            for found, part in ((contact + 1, "bead"), (time, "time"))
        )
        at = np.flatnonzero(near)[np.lexsort(tuple(distances))[0]]
        true |= {name: sign * extreme, f"{name}_time": time[at], f"{name}_bead": contact[at] + 1}
    if "arrival_level" in scene["record"]:
        true |= _arrivals(scene, motion, turns, ends[0])
    return true


def _parted(motion: Motion) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times and contacts that part from touch, at the start or a break of the drive.

    The third array has the rates at which they part, NaN from rest.
    """
    starts = np.array([step.start for step in motion.steps])
    u = motion.compression(np.array([step.state for step in motion.steps]))
    moved = np.abs(u) > PARTED * motion.size
    row = moved.argmax(axis=0)
    parts = ~moved[0] & (np.take_along_axis(u, row[None], axis=0)[0] < -PARTED * motion.size)
    contacts = np.flatnonzero(parts)
    breaks = motion.pieces[0] if motion.driven else np.zeros(1)
    before = np.searchsorted(breaks, starts[row[contacts] - 1], side="right") - 1
    times = breaks[before]
    velocity = motion.states(times)[1]
    ahead = np.roll(velocity, -1, axis=1)
    if not motion.ring:
        ahead[:, -1] = 0.0
    rates = (velocity - ahead)[np.arange(contacts.size), contacts]
    return times, contacts, np.where(rates < -PARTED * motion.size, rates, np.nan)


def _arrivals(scene: Scene, motion: Motion, turns: Passages, start: np.ndarray) -> Scene:
    """Return what follows from the first passages through the level of arrival."""
    beads, level = motion.beads, scene["record"]["arrival_level"]
    arrival, peak, peak_time = np.full((3, beads), np.nan, dtype=np.longdouble)
    passed = motion.passages(level)
    for n in range(start.size):
        side = 1 if start[n] < level else -1
        times = passed.time[(passed.contact == n) & (passed.direction == side)]
        if times.size:
            arrival[n] = times[0]
            later = (turns.contact == n) & (turns.direction < 0) & (turns.time >= times[0])
            if later.any():
                at = np.flatnonzero(later)[np.argmin(turns.time[later])]
                peak[n], peak_time[n] = turns.u[at], turns.time[at]
    first, last = (int(part * beads) for part in FITTED)
    fitted = np.flatnonzero(np.isfinite(arrival[first:last])) + first
    speed = np.nan
    if fitted.size >= 2:
        from_mean = fitted - fitted.mean()
        slowness = from_mean @ arrival[fitted] / (from_mean @ from_mean)
        speed = 1 / slowness if slowness else np.nan
    return {
        "arrival_time": arrival,
        "first_peak": peak,
        "first_peak_time": peak_time,
        "front_speed": speed,
    }


def judge(scene: Scene) -> Iterator[Number]:
    """Compare every variable of a scene with what it should hold."""
    data, motion = simulate_chain(scene), Motion(scene)
    true = _states(data, motion) | _events(scene, data, motion)
    for name, variable in data.data_vars.items():
        found, wanted = np.atleast_1d(variable.values), np.atleast_1d(true[str(name)])
        nothing = np.isnan(found) & np.isnan(wanted)
        if nothing.all():
            continue
        difference = np.where(nothing, 0, np.abs(found - wanted)).astype(float)
        difference[difference < RESOLVED * motion.size] = 0.0
        error = float(np.nan_to_num(difference, nan=np.inf).max())
        largest = float(np.nanmax(np.abs(found), initial=0.0))
        yield str(name), float(variable.attrs["error_estimate"]), error, largest


def cases(seed: int, count: int) -> Iterator[Number]:
    """All numbers of some random chains; one that is refused has no numbers, but a sentence."""
    for index in range(count):
        scene = random_scene(default_rng([seed, index]))
        try:
            for name, stated, true, largest in judge(scene):
                yield f"{name} {index}", stated, true, largest
        except (InputError, SolveError) as error:
            yield f"refused {index}: {error}", np.nan, np.nan, np.nan
