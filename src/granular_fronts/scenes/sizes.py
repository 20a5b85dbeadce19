"""Memory and time that a section of the configuration takes at the least.

The estimates are lower bounds, mostly by orders of magnitude, since they decide only what is
refused: what ends within half a day is not refused, and what takes days is, before it starts.

A front of height δ runs through a bead in the time 1/c, c = δ^((α − 1)/2): N beads over a time t
ask for ctN *crossings*, or half of (ct)² while the front has not reached the last bead.

A step of a chain resolves waves and damping; the time t takes at least t (c/3 + 4G'/20) of them,
with the slope G' of the viscous force at δ.  Twenty scenes with γ from 0 to 1e6 and 10 to 420 beads
took 0.6 to 180 times this estimate, which leaves out that fronts and contacts that open need short
steps.

Every function below yields a `Part` for each key that decides on the size of a section.
"""

import math
from collections.abc import Callable, Iterator, Mapping

from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.scenes.laws import damping_rate, front_speed, is_short
from granular_fronts.scenes.limits import Part, part_errors
from granular_fronts.scenes.scales import decades_of_displacement

NUMBERS_PER_BEAD = 64
"""State and stages of the integrator, and what is followed at each bead."""

COLUMNS_PER_ROW = 4
"""Numbers kept for each bead and time: two fields, and the arrays that they are made from."""

NUMBERS_PER_FRONT = 16
"""Properties of an exact front that are kept."""

SECONDS_PER_CROSSING = 5.0e-8

STEPS_PER_CROSSING, STEPS_PER_DAMPING_TIME = 1.0 / 3.0, 1.0 / 20.0

CROSSINGS_BEFORE_FLIGHT = 10.0
"""A piston has thrown all beads off a free end after so many crossings of the chain."""

SECONDS_PER_STEP, SECONDS_PER_BEAD = 5.0e-7, 1.0e-8
"""A step of a chain, and in addition of each bead that moves."""

SECONDS_PER_POINT = 5.0e-9
"""Of a grid, for each step in time or each evaluation."""

SECONDS_PER_FRONT = 1.0e-4
"""An exact front, found by continuation from its neighbour."""

SECONDS_PER_COLLECTED_FRONT = 1.0e-2
"""An exact front with its tail roots and multipliers."""

SECONDS_PER_PROBLEM = 0.3
"""A random chain in extended precision; fronts take longer."""

SECONDS_PER_RUN = 1.0e-4
"""The shortest run whose time is measured."""

SECONDS_PER_OPERATION = 1.0e-10
"""Of dense linear algebra."""

FEWEST_BEADS_OF_WINDOW, USUAL_CELLS = 10.0, 20
"""Of the matrix in the certificate of a front; see `proofs.right_inverse`."""

BEADS_OF_PROBLEMS = 100.0
"""Beads that move on the average in the problems whose solution is stored."""


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
        One sentence if it is too large: the keys that contribute most, and the size.
    """
    yield from part_errors(section, list(SIZES[path](section)))


# Scenes.


def size_of_chain(scene: Mapping) -> Iterator[Part]:
    """A motion of `beads` beads up to `end_time`, and its record."""
    beads, end, record = float(scene["beads"]), scene["end_time"], scene["record"]
    yield Part(("beads",), (), NUMBERS_PER_BEAD * beads)
    damped = ("law.gamma",) if is_short(scene["law"]) and scene["law"]["gamma"] > 1.0 else ()
    yield Part(("beads", "end_time", *damped), (), 0.0, _motion_time(scene, beads))
    yield Part(("beads",), (), COLUMNS_PER_ROW * len(record["snapshots"]) * beads)
    for name, probe in record.get("probes", {}).items():
        key, samples = f"record.probes.{name}", _points(probe) * len(probe["beads"])
        yield _grid_part((f"{key}.stop",), (f"{key}.step",), COLUMNS_PER_ROW * samples)
    if "grid" in record:
        rows = end / record["grid"]["step"]
        numbers = COLUMNS_PER_ROW * rows * beads
        yield _grid_part(("beads", "end_time"), ("record.grid.step",), numbers)


def size_of_orbits(scene: Mapping) -> Iterator[Part]:
    """Heteroclinic orbits, with a profile for each damping; the well and the portrait."""
    numbers = COLUMNS_PER_ROW * len(scene["mu"]) * _points(scene["profile"])
    yield _grid_part(("profile.stop",), ("profile.step",), numbers)
    if "well" in scene:
        points = 2.0 * scene["well"]["limit"] / scene["well"]["step"]
        yield _grid_part(("well.limit",), ("well.step",), COLUMNS_PER_ROW * points)
    if "portrait" in scene:
        portrait = scene["portrait"]
        points = len(portrait["starts"]) * 2.0 * portrait["span"] / portrait["step"]
        yield _grid_part(("portrait.span",), ("portrait.step",), COLUMNS_PER_ROW * points)


def size_of_ring(scene: Mapping) -> Iterator[Part]:
    """A ring of 2p − 1 beads, and its amplitude equations on their grids."""
    beads, end, scaling = 2.0 * scene["half_beads"], scene["end_time"], scaling_of(scene)
    equations, rows = scene["equations"], end / scene["record"]["grid"]["step"]
    yield Part(
        ("half_beads", "end_time"),
        (),
        NUMBERS_PER_BEAD * beads,
        scaling.speed * end * beads * SECONDS_PER_CROSSING,
    )
    numbers = 3.0 * COLUMNS_PER_ROW * rows * beads
    yield _grid_part(("half_beads", "end_time"), ("record.grid.step",), numbers)
    for name in ("logarithmic", "unlimited", "dispersive"):
        cells = float(equations[name]["cells"])
        yield _grid_part((f"equations.{name}.cells",), (), NUMBERS_PER_BEAD * cells)
    points = float(equations["upwind"]["points"])
    per_length = points / (2.0 * scaling.half_length(scene["half_beads"]))
    seconds = points * per_length * per_length * scaling.slow_rate * end * SECONDS_PER_POINT
    yield Part(("equations.upwind.points", "end_time"), (), NUMBERS_PER_BEAD * points, seconds)


def size_of_front(scene: Mapping) -> Iterator[Part]:
    """An exact front on a window, and a chain driven up to a bead."""
    numbers, bead = 6.0 * COLUMNS_PER_ROW * _points(scene["window"]), float(scene["driven_bead"])
    yield _grid_part(("window.stop",), ("window.step",), numbers)
    yield Part(
        ("driven_bead",), (), NUMBERS_PER_BEAD * bead, 0.5 * bead * bead * SECONDS_PER_CROSSING
    )


# Many exact fronts.


def size_of_survey(section: Mapping) -> Iterator[Part]:
    """A front for each exponent and each damping."""
    yield _front_part(("gamma.num",), len(section["alpha"]) * float(section["gamma"]["num"]))


def size_of_collection(section: Mapping) -> Iterator[Part]:
    """A front with tail roots and multipliers for each exponent and each damping."""
    fronts = len(section["alpha"]) * float(section["gamma"]["num"])
    numbers, seconds = NUMBERS_PER_FRONT * fronts, fronts * SECONDS_PER_COLLECTED_FRONT
    yield Part(("gamma.num",), (), numbers, seconds)


def size_of_random_problems(section: Mapping) -> Iterator[Part]:
    """Some twenty numbers of each problem."""
    yield Part(("count",), (), 20.0 * section["count"], section["count"] * SECONDS_PER_PROBLEM)


def size_of_damping_map(section: Mapping) -> Iterator[Part]:
    """A front for each point of the plane."""
    fronts = float(section["alpha"]["num"]) * section["gamma"]["num"]
    yield _front_part(("alpha.num", "gamma.num"), fronts)


def size_of_multipliers(section: Mapping) -> Iterator[Part]:
    """A dense matrix of two rows a bead, and its eigenvalues, for each front and window."""
    rows = 2.0 * max(section["beads_behind"])
    operations = 25.0 * rows * rows * rows * len(section["fronts"])
    yield Part(("beads_behind",), (), 3.0 * rows * rows, operations * SECONDS_PER_OPERATION)


def size_of_trends(section: Mapping) -> Iterator[Part]:
    """A front for each pressure and each exponent, a tail for each velocity."""
    tails = float(len(section["betas"])) * len(section["piston_velocities"])
    yield _front_part(("betas", "piston_velocities"), tails)
    for key in ("displacements", "exponents"):
        yield _front_part((key,), float(len(section[key])))


# Contact laws at work.


def size_of_materials(section: Mapping) -> Iterator[Part]:
    """A front for each material, velocity and force."""
    fronts = float(len(section["piston_velocities"]) + len(section["forces"]))
    yield _front_part(("piston_velocities", "forces"), len(section["beads"]) * fronts)


def size_of_regimes(section: Mapping) -> Iterator[Part]:
    """A front and a collision for each law and each velocity."""
    yield _front_part(("points",), float(section["points"]) * len(section["betas"]))


def size_of_theta_method(section: Mapping) -> Iterator[Part]:
    """A motion by equal steps for each θ and each step."""
    order, profile = section["order"], section["profile"]
    for name, motion, step_key, steps, motions in [
        ("order", order, "order.steps", order["steps"], len(order["thetas"])),
        ("profile", profile, "profile.step", [profile["step"]], 1),
    ]:
        beads = float(motion["beads"])
        work = motions * beads * motion["end_time"] / min(steps)
        yield Part(
            (f"{name}.beads", f"{name}.end_time"),
            (step_key,),
            NUMBERS_PER_BEAD * beads,
            work * SECONDS_PER_POINT,
        )


def size_of_half_steps(section: Mapping) -> Iterator[Part]:
    """A motion by equal steps for each law, damping and step, of which every state is held."""
    beads, longest = float(section["beads"]), float(section["collision_times"])
    motions = len(section["betas"]) * len(section["gammas"])
    counts = section["steps_per_collision"]
    yield Part(
        ("beads", "collision_times", "steps_per_collision"),
        (),
        COLUMNS_PER_ROW * beads * longest * max(counts),
        motions * beads * longest * sum(counts) * SECONDS_PER_POINT,
    )


def size_of_driven_fronts(section: Mapping) -> Iterator[Part]:
    """Fronts that run through `beads` beads, one for each law (and each ramp of a piston)."""
    fronts, beads = len(section["cases"]) * len(section.get("ramps", [0])), float(section["beads"])
    seconds = 0.5 * fronts * beads * beads * SECONDS_PER_CROSSING
    yield Part(("beads",), (), NUMBERS_PER_BEAD * beads, seconds)


def size_of_variables(section: Mapping) -> Iterator[Part]:
    """A difference quotient for each exponent."""
    yield Part(("betas",), (), 0.0, len(section["betas"]) * SECONDS_PER_RUN)


def size_of_limiting_cases(section: Mapping) -> Iterator[Part]:
    """Pressed chains, and a ring for each exponent."""
    beads, end, rings = float(section["beads"]), section["end_time"], section["rings"]
    seconds = 4.0 * _crossing_time(beads, end)
    yield Part(("beads", "end_time"), (), NUMBERS_PER_BEAD * beads, seconds)
    for exponent in rings["exponents"]:
        # Beads 2ℓ/ε times the time τ/(½γε²), with ε = (α − 1)/(αγ) and c = 1.
        crossings = 4.0 * rings["half_length"] * rings["slow_time"]
        crossings *= rings["gamma"] * rings["gamma"] * (exponent / (exponent - 1.0)) ** 3
        yield Part(
            ("rings.half_length", "rings.slow_time"), (), 0.0, crossings * SECONDS_PER_CROSSING
        )


# Measurements of speed.


def size_of_repeated_runs(problem: Mapping) -> Iterator[Part]:
    """Every method at every tolerance, some times over."""
    runs = len(problem["methods"]) * len(problem["tolerances"])
    yield Part(("repeats",), (), 0.0, runs * problem["repeats"] * SECONDS_PER_RUN)
    if "end_time" in problem:
        crossings = runs * BEADS_OF_PROBLEMS * float(problem["end_time"])
        yield Part(("end_time",), (), 0.0, crossings * SECONDS_PER_CROSSING)


def size_of_log_burgers(problem: Mapping) -> Iterator[Part]:
    """Every scheme on every grid, some times over."""
    reference = problem["reference"]
    for key, cells in [
        ("upwind_points", max(problem["upwind_points"])),
        ("cells", max(problem["cells"])),
        ("reference.cells", reference["cells"]),
        ("reference.points", reference["points"]),
    ]:
        yield _grid_part((key,), (), NUMBERS_PER_BEAD * float(cells))
    for key, step in [
        ("reference.longest_step", reference["longest_step"]),
        ("longest_steps", min(problem["longest_steps"])),
    ]:
        yield Part((), (key,), 0.0, reference["points"] / step * SECONDS_PER_POINT)
    yield Part(("repeats",), (), 0.0, problem["repeats"] * SECONDS_PER_RUN)


def size_of_proofs(section: Mapping) -> Iterator[Part]:
    """A dense matrix for each certificate, and at least one certificate for each chunk."""
    for name, family in section["intervals"].items():
        for part in family["parts"]:
            unknowns = FEWEST_BEADS_OF_WINDOW * float(part.get("cells", USUAL_CELLS))
            seconds = part["chunks"] * unknowns**3 * SECONDS_PER_OPERATION
            yield Part((f"intervals.{name}.parts",), (), unknowns**2, seconds)


SIZES: dict[str, Callable[[Mapping], Iterator[Part]]] = {
    "scenes.chain.*": size_of_chain,
    "scenes.heteroclinic.*": size_of_orbits,
    "scenes.periodic.*": size_of_ring,
    "scenes.front.*": size_of_front,
    "exact_fronts.survey": size_of_survey,
    "exact_fronts.critical_damping": size_of_damping_map,
    "exact_fronts.multipliers": size_of_multipliers,
    "exact_fronts.trends": size_of_trends,
    "laws.materials": size_of_materials,
    "laws.damping_regimes": size_of_regimes,
    "laws.numerical_damping": size_of_theta_method,
    "laws.half_step_damping": size_of_half_steps,
    "laws.jump_conditions": size_of_driven_fronts,
    "laws.choice_of_variables": size_of_variables,
    "laws.limiting_cases": size_of_limiting_cases,
    "laws.piston": size_of_driven_fronts,
    "precision.chain.*": size_of_repeated_runs,
    "precision.ring.*": size_of_repeated_runs,
    "precision.heteroclinic.*": size_of_repeated_runs,
    "precision.fronts.*": size_of_repeated_runs,
    "precision.log_burgers.*": size_of_log_burgers,
    "honesty.*": size_of_random_problems,
    "explorer": size_of_collection,
    "proofs": size_of_proofs,
}
"""Sizes by the path of a section in the configuration; ``*`` stands for a name."""


def _points(axis: Mapping) -> float:
    return (axis["stop"] - axis["start"]) / axis["step"]


def _grid_part(large: tuple[str, ...], small: tuple[str, ...], numbers: float) -> Part:
    return Part(large, small, numbers, numbers * SECONDS_PER_POINT)


def _front_part(keys: tuple[str, ...], fronts: float) -> Part:
    return Part(keys, (), NUMBERS_PER_FRONT * fronts, fronts * SECONDS_PER_FRONT)


def _motion_time(scene: Mapping, beads: float) -> float:
    """Time that the steps of a motion take."""
    size, boundary = decades_of_displacement(scene), scene["boundary"]
    # Beads that nothing holds fly apart, and long steps follow them.
    flies_apart = boundary["kind"] == "pressure" and not (boundary["left"] or boundary["right"])
    thrown = boundary["kind"] == "piston" and not boundary.get("right", 0.0)
    if flies_apart or not math.isfinite(size):
        return 0.0
    law, end = scene["law"], scene["end_time"]
    speed, damping = front_speed(law, size), damping_rate(law, size)
    if thrown and speed > 0.0:
        end = min(end, CROSSINGS_BEFORE_FLIGHT * beads / speed)
    steps = end * (STEPS_PER_CROSSING * speed + STEPS_PER_DAMPING_TIME * damping)
    moving = min(beads, 0.5 * speed * end)
    return steps * (SECONDS_PER_STEP + SECONDS_PER_BEAD * moving)


def _crossing_time(beads: float, distance: float) -> float:
    """Time that the crossings of a front take on its way of so many beads."""
    return distance * (beads if distance > beads else 0.5 * distance) * SECONDS_PER_CROSSING
