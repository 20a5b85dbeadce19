"""Random chains: the errors that the package states, and the true errors."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import InputError, SolveError
from granular_fronts.reference_methods.extended import Motion

EXPONENTS = (1.0, 1.2, 1.5, 1.5, 2.0, 2.5)
# Front speeds are fitted between these parts of a chain.
FITTED = (0.5, 0.9)
# Part of the size of a motion below which the reference resolves nothing.
RESOLVED = 1e-17
# Above it a contact that touches at the start has parted.
PARTED = 1e-15
# Of the difference quotients of smooth viscous forces.
STEP = np.longdouble(1) / 4096


def _random_law(rng: np.random.Generator) -> tuple[dict[str, Any], float]:
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
    elastic, size = (
        ({"kind": "toda", "strength": rng.uniform(0.5, 2), "rate": rng.uniform(0.5, 2)}, 0.5),
        (
            {
                "kind": "fpu",
                "quadratic": 1.0,
                "cubic": rng.uniform(-0.8, 0.8),
                "quartic": rng.uniform(0.3, 1),
            },
            0.7,
        ),
        ({"kind": "morse", "depth": rng.uniform(0.3, 1), "rate": rng.uniform(0.5, 1.5)}, 0.15),
        ({"kind": "lennard_jones", "depth": 0.1, "distance": rng.uniform(1, 3)}, 0.08),
    )[kind - 6]
    viscous = _viscous(rng.choice(["linear", "proportional", "none", "power"]), gamma, beta)
    return {"elastic": elastic, "viscous": viscous}, size * rng.uniform(0.3, 1)


def _viscous(kind, gamma, beta=1.5):
    own = {"none": {}, "power": {"beta": beta, "gamma": gamma}}
    return {"kind": str(kind)} | own.get(kind, {"gamma": gamma})


def random_scene(rng: np.random.Generator) -> dict[str, Any]:
    """Return a scene of the schema, small enough for the reference."""
    law, size = _random_law(rng)
    beads = int(rng.integers(2, 13) if rng.random() < 0.8 else rng.integers(13, 31))
    end = round(10 ** rng.uniform(-1, 1.5), int(rng.integers(1, 4)))
    end = 12.6 if rng.random() < 0.05 else end
    kind = str(rng.choice(["pressure", "pressure", "ring", "piston"]))
    boundary: dict[str, Any] = {"kind": kind}
    if kind == "pressure":
        boundary |= {"left": size * rng.uniform(0.3, 1), "right": size * float(rng.random() < 0.3)}
    elif kind == "piston":
        boundary |= {"velocity": size * rng.uniform(0.3, 1)}
        boundary |= {"ramp": end * rng.uniform(0.05, 1.2)} if rng.random() < 0.5 else {}
    start: dict[str, Any] = {"kind": "rest"}
    if kind == "ring" or rng.random() < 0.4:
        u = size * rng.uniform(-0.3, 1, beads if kind == "ring" else beads - 1)
        velocity = size * rng.uniform(-1, 1, beads)
        if kind == "piston":
            velocity[0] = 0.0 if boundary.get("ramp") else boundary["velocity"]
        start = {
            "kind": "given",
            "relative_displacement": u.tolist(),
            "velocity": velocity.tolist(),
        }
    relative = 10 ** rng.uniform(-12, -3)
    snapshots = {end, *(end * 10 ** rng.uniform(-2, 0, int(rng.integers(1, 4))))}
    record: dict[str, Any] = {"snapshots": sorted(map(float, snapshots)), "extremes": True}
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
    return _touched_and_driven(rng, scene, beads, size)


def _touched_and_driven(rng, scene, beads, size):
    """Return a scene some of whose contacts touch at the start, that is driven, or has sensors."""
    start, boundary, end = scene["start"], scene["boundary"], scene["end_time"]
    if start["kind"] == "given" and rng.random() < 0.5:
        touches = rng.random(len(start["relative_displacement"])) < 0.7
        start["relative_displacement"] = np.where(
            touches, 0.0, start["relative_displacement"]
        ).tolist()
    if boundary["kind"] != "ring" and start["kind"] == "rest" and rng.random() < 0.5:
        key = "velocity" if boundary["kind"] == "piston" else "force"
        drive = _random_drive(rng, size, end, key)
        if boundary["kind"] == "wall":
            scene["boundary"] = {"kind": "wall", "force": drive}
        else:
            held = {"right": boundary.get("right", 0.0)}
            kind = "piston" if key == "velocity" else "force"
            scene["boundary"] = {"kind": kind, key: drive} | held
    if rng.random() < 0.3:
        stop = end * rng.uniform(0.2, 1)
        near = {
            "contacts": [int(rng.integers(1, beads))],
            "beads": [int(rng.integers(1, beads + 1))],
        }
        near |= {"start": 0.0, "stop": stop, "step": stop / int(rng.integers(3, 12))}
        scene["record"]["sensors"] = {"felt": near}
    return scene


def _random_drive(rng, size, end, key):
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


def _unlike_beads(rng, beads, boundary, start, size):
    """Return beads, boundary, contacts, body force and start, where a third of all chains vary."""
    scene = {"beads": beads, "boundary": boundary, "start": start}
    if rng.random() < 0.67:
        return scene

    def drawn(count):
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


def _truths(scene: dict[str, Any], data: xr.Dataset, motion: Motion) -> dict[str, Any]:
    """Return what the variables of a dataset should hold; of events, see `events`."""
    true = {"mass": motion.mass}
    for name in ("", "_grid", *(f"_{probe}" for probe in scene["record"].get("probes", {}))):
        variable = data.get(f"relative_displacement{name}")
        if variable is None:
            continue
        times = data[variable.dims[0]].values
        u, velocity = motion.states(times)
        held = np.full((len(u), motion.beads - u.shape[1]), motion.right)
        whole = np.column_stack([u, held])
        true[f"relative_displacement{name}"] = whole[:, data[variable.dims[1]].values - 1]
        true[f"velocity{name}"] = velocity
        if name == "_grid":
            true["mean_relative_displacement"] = u.sum(axis=1) / motion.beads
            true["total_velocity"] = velocity.sum(axis=1)
    return true | (_felt(scene, data, motion) if "sensors" in scene["record"] else {})


def _felt(scene, data, motion):
    """Return forces, momentum and energy at the sensor; the beads beyond a contact gain them."""
    times = data["t_felt"].values
    contact, bead = (data[f"{place}_felt"].values - 1 for place in ("contact", "bead"))
    u, velocity = motion.states(times)
    ahead = np.zeros_like(velocity)
    ahead[:, : u.shape[1]] = _transmitted(scene["law"], motion, u, velocity)
    if not (motion.ring or motion.wall):
        ahead[:, -1] = motion.held[0][1]
    behind = np.roll(ahead, 1, axis=1)
    if motion.driven == "velocity":
        behind[:, 0] = ahead[:, 0] + motion.mass[0] * motion.drive_rate(times)
    elif motion.driven == "force":
        behind[:, 0] = motion.drive(times)
    elif not motion.ring:
        behind[:, 0] = motion.held[0][0]
    momentum = motion.mass * velocity
    energy = momentum * velocity / 2
    energy[:, : u.shape[1]] += motion.elastic_factor * _stored(scene["law"], motion, u)
    if motion.ring:  # Its last contact counts for neither side.
        energy[:, -1] = momentum[:, -1] * velocity[:, -1] / 2
    beyond = {
        f"transmitted_{name}_felt": of[:, ::-1].cumsum(axis=1)[:, ::-1] - of
        for name, of in (("momentum", momentum), ("energy", energy))
    }
    return {name: (of - of[0])[:, contact] for name, of in beyond.items()} | {
        "contact_force_felt": ahead[:, contact],
        "bead_force_felt": ((ahead + behind) / 2)[:, bead],
        "velocity_felt": velocity[:, bead],
    }


def _transmitted(law, motion, u, velocity):
    """Return the forces of the contacts; one that just touches is on the side it moves to."""
    rate = motion._differences(velocity)
    touches = np.abs(u) <= RESOLVED * motion.size
    near = np.where(touches, np.where(rate < 0, -1e-300, 1e-300), u)
    elastic, viscous = motion.forces(near)
    beta = law.get("beta", law.get("viscous", {}).get("beta"))
    if law.get("elastic", {}).get("kind") == "hertz":
        alpha = law["elastic"]["alpha"]
        kinds = {"simon_hunt_crossley": alpha + 1, "kuwabara_kono": alpha}
        beta = kinds.get(law["viscous"]["kind"], 1.0)
    if beta is None:  # Smooth: a difference quotient of sixth order.
        drag = [motion.forces(u + k * STEP)[1] - motion.forces(u - k * STEP)[1] for k in (1, 2, 3)]
        slope = (45 * drag[0] - 9 * drag[1] + drag[2]) / (60 * STEP)
    else:
        slope = beta * viscous / near
    return motion.elastic_factor * elastic + motion.viscous_factor * slope * rate


def _stored(law, motion, u):
    """Return the elastic energies of the moving contacts over their factors, by Gauss's rule."""
    hertz = law if "alpha" in law else law["elastic"]
    if "alpha" in hertz:
        return u * motion.forces(u)[0] / (1 + hertz["alpha"])
    nodes, weights = np.polynomial.legendre.leggauss(24)
    forces = motion.forces(u[..., None] * (1 + nodes) / 2)[0]
    return u / 2 * (forces @ weights)


def events(scene: dict[str, Any], data: xr.Dataset, motion: Motion) -> dict[str, Any]:
    """Return the arrivals, first peaks, extremes and the first gap.

    Where two extremes are equal within the stated error, time and bead may belong to either; the
    nearer one counts.
    """
    turns, opened = motion.passages(), motion.passages(0.0)
    true: dict[str, Any] = {}
    opens = (opened.direction < 0) & (np.abs(opened.rate) > 1e-15 * motion.size)
    parted, contacts = _parted(motion)
    times = np.concatenate([opened.time[opens], parted])
    beads = np.concatenate([opened.contact[opens], contacts]) + 1
    first = np.lexsort((np.abs(beads - data["first_gap_bead"].item()), times))[:1]
    true["first_gap_time"], true["first_gap_bead"] = (
        of[first[0]] if first.size else np.nan for of in (times, beads)
    )
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


def _parted(motion):
    """Return times and contacts that part from touch, at the start or a break of the drive."""
    starts = np.array([step.start for step in motion.steps])
    u = motion.compression(np.array([step.state for step in motion.steps]))
    moved = np.abs(u) > PARTED * motion.size
    row = moved.argmax(axis=0)
    parts = ~moved[0] & (np.take_along_axis(u, row[None], axis=0)[0] < -PARTED * motion.size)
    contacts = np.flatnonzero(parts)
    breaks = motion.pieces[0] if motion.driven else np.zeros(1)
    before = np.searchsorted(breaks, starts[row[contacts] - 1], side="right") - 1
    return breaks[before], contacts


def _arrivals(scene, motion, turns, start):
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


def judge(scene: dict[str, Any]) -> Iterator[tuple[str, float, float, float, int]]:
    """Name, stated error, true error, largest value and size of every variable of a scene."""
    data = simulate_chain(scene)
    motion = Motion(scene)
    true = _truths(scene, data, motion) | events(scene, data, motion)
    for name, variable in data.data_vars.items():
        found, wanted = np.atleast_1d(variable.values), np.atleast_1d(true[name])
        nothing = np.isnan(found) & np.isnan(wanted)
        if nothing.all():
            continue
        difference = np.where(nothing, 0, np.abs(found - wanted)).astype(float)
        difference[difference < RESOLVED * motion.size] = 0.0
        error = float(np.nan_to_num(difference, nan=np.inf).max())
        largest = float(np.nanmax(np.abs(found), initial=0.0))
        yield name, float(variable.attrs["error_estimate"]), error, largest, found.size


def cases(seed: int, count: int) -> Iterator[tuple[str, float, float, float, int]]:
    """All numbers of some random chains; one that is refused has no numbers, but a sentence."""
    for index in range(count):
        scene = random_scene(np.random.default_rng([seed, index]))
        try:
            for name, *numbers in judge(scene):
                yield f"{name} {index}", *numbers
        except (InputError, SolveError) as error:
            yield f"refused {index}: {error}", np.nan, np.nan, np.nan, 0
