"""Memory and time that a section of the configuration takes at the least.

The estimates are lower bounds by orders of magnitude, since they decide only what is refused: what
can be computed is never refused, and what no computer finishes is refused before it starts.

A motion of a chain is followed in *crossings*: a front of height δ runs through a bead in the time
1/c, c = δ^((α − 1)/2), so that N beads over a time t ask for ctN crossings, or half of (ct)² while
the front has not reached the last bead.  Each crossing takes several steps of the integrator, and a
step of one bead about 1e-8 s at the least.

Every function below yields a `Part` for each key that decides on the size of a section.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from granular_fronts.scenes.constraints import decades_of_displacement
from granular_fronts.slow_scales import scaling_of

MOST_MEMORY = 16 * 2**30
"""Bytes that one job may hold."""

LONGEST_TIME = 30 * 86400.0
"""Seconds on one core that one job may take."""

BYTES_PER_NUMBER = 8

NUMBERS_PER_BEAD = 64
"""State and stages of the integrator, and what is followed at each bead."""

COLUMNS_PER_ROW = 4
"""Numbers kept for each bead and time: two fields, and the arrays that they are made from."""

SECONDS_PER_CROSSING = 5.0e-7
SECONDS_PER_POINT = 1.0e-9
"""Of a grid, for each step in time or each evaluation."""

SECONDS_PER_FRONT = 1.0e-4
"""An exact front, found by continuation from its neighbour."""

LARGEST = 1.0e300
"""Stands for what overflows."""


class Part(NamedTuple):
    """What one key contributes to the size of a section.

    Attributes
    ----------
    key : str
        Dotted key inside the section.
    numbers : float
        Numbers held at once.
    seconds : float
        Time on one core.
    remedy : str
        What to do with the key.
    """

    key: str
    numbers: float
    seconds: float = 0.0
    remedy: str = "give less"


def size_errors(path: str, section: Mapping) -> Iterator[str]:
    """Compare the size of a section with `MOST_MEMORY` and `LONGEST_TIME`.

    Parameters
    ----------
    path : str
        Of the section in the configuration, with ``*`` for a name, as in `SIZES`.
    section : Mapping
        One that obeys the schema and its constraints.

    Yields
    ------
    str
        One sentence if it is too large: the key that contributes most, and the size.
    """
    yield from part_errors(section, list(SIZES.get(path, _no_parts)(section)))


def part_errors(section: Mapping, parts: list[Part]) -> Iterator[str]:
    """Compare the sum of some parts with the limits; see `size_errors`."""
    memory = BYTES_PER_NUMBER * sum(_capped(part.numbers) for part in parts)
    seconds = sum(_capped(part.seconds) for part in parts)
    if memory <= MOST_MEMORY and seconds <= LONGEST_TIME:
        return
    largest = max(
        parts,
        key=lambda part: max(
            BYTES_PER_NUMBER * part.numbers / MOST_MEMORY, part.seconds / LONGEST_TIME
        ),
    )
    yield (
        f"{largest.key} is {_look_up(section, largest.key)}, which takes at least "
        f"{show_memory(memory)} of memory and {show_time(seconds)} on one core, above the limit of "
        f"{show_memory(MOST_MEMORY)} or {show_time(LONGEST_TIME)}: {largest.remedy}."
    )


def show_memory(memory: float) -> str:
    """Bytes in words, for example ``16 GiB``."""
    for unit in ("bytes", "KiB", "MiB"):
        if memory < 1000.0:
            return f"{memory:.0f} {unit}"
        memory /= 1024.0
    return f"{_show_number(memory)} GiB"


def show_time(seconds: float) -> str:
    """A duration in words, for example ``30 days``."""
    for unit, length in [("years", 365.25 * 86400.0), ("days", 86400.0), ("hours", 3600.0)]:
        if seconds >= 2.0 * length:
            return f"{_show_number(seconds / length)} {unit}"
    return f"{seconds:.0f} seconds"


def _show_number(value):
    return f"{value:,.0f}" if value < 1e6 else f"{value:.0e}"


def _look_up(section, key):
    for name in key.split("."):
        section = section[name]
    return section


def _no_parts(_section):
    return ()


def _capped(value):
    return min(value, LARGEST)


# Scenes.


def size_of_chain(scene: Mapping) -> Iterator[Part]:
    """A motion of `beads` beads up to `end_time`, and its record."""
    beads, record = float(scene["beads"]), scene["record"]
    yield Part("beads", NUMBERS_PER_BEAD * beads)
    yield Part("end_time", 0.0, _crossing_time(scene, beads))
    yield Part("record.snapshots", COLUMNS_PER_ROW * len(record["snapshots"]) * beads)
    for name, probe in record.get("probes", {}).items():
        samples = _points(probe) * len(probe["beads"])
        yield Part(f"record.probes.{name}.step", COLUMNS_PER_ROW * samples, 0.0, "give more")
    if "grid" in record:
        rows = scene["end_time"] / record["grid"]["step"]
        yield Part("record.grid.step", COLUMNS_PER_ROW * rows * beads, 0.0, "give more")


def size_of_orbits(scene: Mapping) -> Iterator[Part]:
    """Heteroclinic orbits, with a profile for each damping; the well and the portrait."""
    profile, orbits = scene["profile"], len(scene["mu"])
    yield _step_part("profile.step", COLUMNS_PER_ROW * orbits * _points(profile))
    if "well" in scene:
        well = scene["well"]
        yield _step_part("well.step", COLUMNS_PER_ROW * 2.0 * well["limit"] / well["step"])
    if "portrait" in scene:
        portrait = scene["portrait"]
        points = len(portrait["starts"]) * 2.0 * portrait["span"] / portrait["step"]
        yield _step_part("portrait.step", COLUMNS_PER_ROW * points)


def size_of_ring(scene: Mapping) -> Iterator[Part]:
    """A ring of 2p − 1 beads, and its amplitude equations on their grids."""
    beads, end, scaling = 2.0 * scene["half_beads"], scene["end_time"], scaling_of(scene)
    equations, rows = scene["equations"], end / scene["record"]["grid"]["step"]
    slow_end = scaling.slow_rate * end
    points = float(equations["upwind"]["points"])
    per_length = points / (2.0 * scaling.half_length(scene["half_beads"]))
    steps = slow_end * per_length * per_length
    yield Part("half_beads", NUMBERS_PER_BEAD * beads)
    yield Part("end_time", 0.0, scaling.speed * end * beads * SECONDS_PER_CROSSING)
    yield Part("record.grid.step", 3.0 * COLUMNS_PER_ROW * rows * beads, 0.0, "give more")
    for name in ("logarithmic", "unlimited"):
        cells = float(equations[name]["cells"])
        yield Part(f"equations.{name}.cells", NUMBERS_PER_BEAD * cells)
    yield Part(
        "equations.upwind.points", NUMBERS_PER_BEAD * points, points * steps * SECONDS_PER_POINT
    )


def size_of_front(scene: Mapping) -> Iterator[Part]:
    """An exact front on a window, and a chain driven up to a bead."""
    bead = float(scene["driven_bead"])
    yield _step_part("window.step", 6.0 * COLUMNS_PER_ROW * _points(scene["window"]))
    yield Part("driven_bead", NUMBERS_PER_BEAD * bead, 0.5 * bead**2 * SECONDS_PER_CROSSING)


# Many exact fronts.


def size_of_survey(section: Mapping) -> Iterator[Part]:
    """A front for each exponent and each damping."""
    yield _front_part("gamma.num", len(section["alpha"]) * float(section["gamma"]["num"]))


def size_of_damping_map(section: Mapping) -> Iterator[Part]:
    """A front for each point of the plane."""
    exponents, dampings = float(section["alpha"]["num"]), float(section["gamma"]["num"])
    largest = "alpha.num" if exponents > dampings else "gamma.num"
    yield _front_part(largest, exponents * dampings)


def size_of_multipliers(section: Mapping) -> Iterator[Part]:
    """A dense matrix of two rows a bead, and its eigenvalues, for each front and window."""
    rows = 2.0 * max(section["beads_behind"])
    flops = 25.0 * rows**3 * len(section["fronts"])
    yield Part("beads_behind", 3.0 * rows**2, 1.0e-10 * flops)


# Contact laws at work.


def size_of_regimes(section: Mapping) -> Iterator[Part]:
    """A front and a collision for each law and each velocity."""
    points = float(section["points"]) * len(section["betas"])
    yield Part("points", COLUMNS_PER_ROW * points, points * SECONDS_PER_FRONT)


def size_of_theta_method(section: Mapping) -> Iterator[Part]:
    """A motion by equal steps for each θ and each step."""
    order, profile = section["order"], section["profile"]
    for name, motion, steps, motions in [
        ("order", order, order["steps"], len(order["thetas"])),
        ("profile", profile, [profile["step"]], 1),
    ]:
        beads = float(motion["beads"])
        work = motions * beads * motion["end_time"] / min(steps)
        yield Part(f"{name}.beads", NUMBERS_PER_BEAD * beads)
        yield Part(f"{name}.end_time", 0.0, work * SECONDS_PER_POINT, "give less, or larger steps")


def size_of_driven_fronts(section: Mapping) -> Iterator[Part]:
    """Fronts that run through `beads` beads, one for each law (and each ramp of a piston)."""
    fronts, beads = len(section["cases"]) * len(section.get("ramps", [0])), float(section["beads"])
    yield Part("beads", NUMBERS_PER_BEAD * beads, 0.5 * fronts * beads**2 * SECONDS_PER_CROSSING)


# Measurements of speed.


def size_of_repeated_runs(problem: Mapping) -> Iterator[Part]:
    """Every method at every tolerance, some times over."""
    runs = len(problem["methods"]) * len(problem["tolerances"])
    seconds = 420.0 * 0.56 * problem.get("end_time", 1.0) * SECONDS_PER_CROSSING
    yield Part("end_time" if "end_time" in problem else "repeats", 0.0, runs * seconds)
    yield Part("repeats", 0.0, runs * problem["repeats"] * 1.0e-4)


def size_of_log_burgers(problem: Mapping) -> Iterator[Part]:
    """Every scheme on every grid, some times over."""
    reference = problem["reference"]
    for key, cells in [
        ("upwind_points", max(problem["upwind_points"])),
        ("cells", max(problem["cells"])),
        ("reference.cells", reference["cells"]),
        ("reference.points", reference["points"]),
    ]:
        yield Part(key, NUMBERS_PER_BEAD * float(cells), 1.0e-4 * cells * SECONDS_PER_POINT)
    upwind = float(max(problem["upwind_points"]))
    yield Part("upwind_points", 0.0, 1.0e-4 * upwind**3 * SECONDS_PER_POINT)
    for key, step in [
        ("reference.longest_step", reference["longest_step"]),
        ("longest_steps", min(problem["longest_steps"])),
    ]:
        yield Part(key, 0.0, reference["points"] / step * SECONDS_PER_POINT, "give more")
    yield Part("repeats", 0.0, problem["repeats"] * 1.0e-3)


def size_of_stiff_damping(section: Mapping) -> Iterator[Part]:
    """One motion for each damping and tolerance, some times over."""
    runs = len(section["gammas"]) * len(section["relative_tolerances"])
    motion = {
        "law": {"alpha": 1.5},
        "boundary": {"left": section["displacement"]},
        "start": {},
        "end_time": section["end_time"],
    }
    beads = float(section["beads"])
    seconds = runs * _crossing_time(motion, beads)
    yield Part("beads", NUMBERS_PER_BEAD * beads)
    yield Part("end_time", 0.0, seconds)
    yield Part("repeats", 0.0, runs * section["repeats"] * 1.0e-4)


SIZES: dict[str, Callable[[Mapping], Iterator[Part]]] = {
    "scenes.chain.*": size_of_chain,
    "scenes.heteroclinic.*": size_of_orbits,
    "scenes.periodic.*": size_of_ring,
    "scenes.front.*": size_of_front,
    "exact_fronts.survey": size_of_survey,
    "exact_fronts.critical_damping": size_of_damping_map,
    "exact_fronts.multipliers": size_of_multipliers,
    "laws.damping_regimes": size_of_regimes,
    "laws.numerical_damping": size_of_theta_method,
    "laws.jump_conditions": size_of_driven_fronts,
    "laws.piston": size_of_driven_fronts,
    "precision.chain.*": size_of_repeated_runs,
    "precision.ring.*": size_of_repeated_runs,
    "precision.heteroclinic.*": size_of_repeated_runs,
    "precision.fronts.*": size_of_repeated_runs,
    "precision.log_burgers.*": size_of_log_burgers,
    "stiff_damping": size_of_stiff_damping,
}
"""Sizes by the path of a section in the configuration; ``*`` stands for a name."""


def _points(axis):
    return (axis["stop"] - axis["start"]) / axis["step"]


def _step_part(key, numbers):
    return Part(key, numbers, numbers * SECONDS_PER_POINT, "give more")


def _front_part(key, fronts):
    return Part(key, NUMBERS_PER_BEAD * fronts, fronts * SECONDS_PER_FRONT)


def _crossing_time(scene, beads):
    """Time that the crossings of a motion take."""
    decades = decades_of_displacement(scene)
    if not math.isfinite(decades):
        return 0.0
    speed = 10.0 ** (0.5 * (scene["law"]["alpha"] - 1.0) * decades)
    distance = speed * scene["end_time"]
    return distance * (beads if distance > beads else 0.5 * distance) * SECONDS_PER_CROSSING
