"""Constraints that tie two keys of a section together, and so stand in no schema.

Each constraint is a function of one section of the configuration, a scene for example, that obeys
the schema.  It yields a sentence for each violation, which begins with the key inside the section
and names the value, the limit and the way out.  `CONSTRAINTS` lists them by the path of a section
in the configuration; ``*`` stands for any name.

This module imports neither numpy nor numba: the workflow checks its configuration at each start.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from granular_fronts.model.amplitude_scaling import scaling_of
from granular_fronts.scenes.law_constraints import (
    beads_are_solid,
    chain_of_half_steps_is_measured,
    ends_of_contacts_are_pressed,
    laws_of_cases_are_possible,
    piston_tolerance_resolves_motion,
    pressed_chains_hold_waves,
    softening_start_is_compressed,
    states_are_compressed,
    states_differ,
    strains_lie_in_domain,
    theta_steps_meet_end,
)
from granular_fronts.scenes.proof_constraints import parts_increase, shown_front_is_proved
from granular_fronts.scenes.scales import (
    absolute_tolerance_errors,
    decades,
    decades_of_displacement,
)
from granular_fronts.scenes.schema import name_entry

RELATIVE_TOLERANCE_FLOOR = 1.0e-15
"""Smallest relative tolerance the solver can honour: a few units of double-precision round-off."""

EQUATION_TOLERANCE_FLOOR = 1.0e-13
"""Smallest error per step that the rounding of a rescaled variable of order 1 lets through."""

SOLVED_EQUATIONS = ("logarithmic", "unlimited", "dispersive")
"""Keys of the amplitude equations that have cells and a tolerance of their own."""

LARGEST_OVERSHOOT = 10.0
"""Compression that no chain at rest comes to, over the largest relative displacement driving it.

Chains of 2 to 21 beads without damping, pressed or pushed from both ends, stay below 3.5 for α of 1
to 1.5.
"""

CELLS_PER_EDGE = 2
"""Fewest cells over a unit of ξ, the width of the falling edge of eq. (49)."""

SMALLEST_DAMPING = 1.0e-280
"""Smallest μ > 0: below it the energy of the orbit, which is of order μ, loses digits."""

GAUSSIAN_CENTRE = -2.0 * math.sqrt(0.5 + math.log(2.0))
"""The s of the maximum of the orbit for μ = 0, y = exp(½ − (s − centre)²/4) with y(0) = ½."""

GAUSSIAN_HALF_WIDTH = 2.0 * math.sqrt(0.5 - math.log(5e-324))
"""Distance in s from that centre at which this orbit is below the smallest double."""

LATER_UNDERFLOW = 7.0
"""Bound on how much later, over μ, the other orbits underflow: ln(745/ln 2) ≈ 6.98 for large μ."""

# Any section.


def ranges_increase(section: Mapping) -> Iterator[str]:
    """Every range starts before it stops."""
    for key, mapping in _mappings(section):
        if {"start", "stop"} <= mapping.keys() and _is_empty(mapping["start"], mapping["stop"]):
            yield (
                f"{key}.start is {mapping['start']}, but must come before its stop "
                f"{mapping['stop']}: lower start or raise stop."
            )


def _is_empty(start: Any, stop: Any) -> bool:
    return not isinstance(start, Mapping) and start >= stop


def steps_fit_ranges(section: Mapping) -> Iterator[str]:
    """No step is longer than the range that it divides."""
    for key, mapping in _mappings(section):
        # A probe may be called start or step.
        own = {name: value for name, value in mapping.items() if not isinstance(value, Mapping)}
        if {"start", "stop", "step"} <= own.keys():
            length, limits = own["stop"] - own["start"], "from start to stop"
        else:
            limits = "span" if "span" in own else "limit"
            length = own.get(limits, math.inf)
        if 0 < length < own.get("step", 0.0):
            yield (
                f"{key}.step is {own['step']}, longer than the range of {length:g} that it "
                f"divides ({limits}): give {length:g} or less."
            )


def relative_tolerance_above_floor(section: Mapping) -> Iterator[str]:
    """No solver in double precision honours less."""
    relative = section["tolerance"]["relative"]
    if relative < RELATIVE_TOLERANCE_FLOOR:
        yield (
            f"tolerance.relative is {relative}, under the solver's floor of "
            f"{RELATIVE_TOLERANCE_FLOOR}, which double precision sets: "
            "ask for the floor or more."
        )


# Chains.


def absolute_tolerance_resolves_motion(scene: Mapping) -> Iterator[str]:
    """The absolute tolerance lies between rounding and the size of the motion."""
    yield from absolute_tolerance_errors(
        scene["tolerance"]["absolute"], decades_of_displacement(scene)
    )


def ring_is_set_in_motion(scene: Mapping) -> Iterator[str]:
    """A ring has a given start, since nothing pushes it."""
    if scene["boundary"]["kind"] == "ring" and scene["start"]["kind"] != "given":
        yield (
            f"start.kind is {scene['start']['kind']}, but nothing sets a ring in motion: "
            "use kind given, with relative_displacement and velocity."
        )


def start_lists_every_bead(scene: Mapping) -> Iterator[str]:
    """A given start lists a number for each bead and each contact."""
    if scene["start"]["kind"] != "given":
        return
    beads = scene["beads"]
    contacts = beads if scene["boundary"]["kind"] == "ring" else beads - 1
    for key, expected in [("relative_displacement", contacts), ("velocity", beads)]:
        found = len(scene["start"][key])
        if found != expected:
            yield (
                f"start.{key} has {found} numbers, but {beads} beads with boundary "
                f"{scene['boundary']['kind']} need {expected}: give one for each."
            )


def start_agrees_with_piston(scene: Mapping) -> Iterator[str]:
    """The given velocity of bead 1 is the one its piston begins with."""
    boundary, start = scene["boundary"], scene["start"]
    if boundary["kind"] != "piston" or start["kind"] != "given":
        return
    begins = 0 if boundary.get("ramp") else boundary["velocity"]
    found = start["velocity"][0] if start["velocity"] else begins
    if found != begins:
        yield (
            f"start.velocity begins with {found}, but bead 1 is a piston that begins at the "
            f"velocity {begins}: give {begins} first."
        )


def probes_are_on_chain(scene: Mapping) -> Iterator[str]:
    """Every probe stands on a bead, under a name that no other record has."""
    for name, probe in scene["record"].get("probes", {}).items():
        if name == "grid":
            yield (
                "record.probes.grid has the name of the record of the space–time grid: give the "
                "probe another name."
            )
        for bead in probe["beads"]:
            if bead > scene["beads"]:
                yield (
                    f"record.probes.{name}.beads names bead {bead}, but the chain has "
                    f"{scene['beads']} beads: choose one of 1 to {scene['beads']}."
                )


def arrival_level_can_be_met(scene: Mapping) -> Iterator[str]:
    """A chain at rest comes to the level at which a front has arrived."""
    level, size = scene["record"].get("arrival_level", 0.0), decades_of_displacement(scene)
    if scene["start"]["kind"] != "rest" or not math.isfinite(size):
        return
    if decades(level) > size + math.log10(LARGEST_OVERSHOOT):
        driving = 10.0**size
        yield (
            f"record.arrival_level is {level}, but relative displacements stay below "
            f"{LARGEST_OVERSHOOT * driving:.3g} where about {driving:.3g} drives them: give "
            f"{0.5 * driving:.3g}, half of a front."
        )


def record_ends_with_motion(scene: Mapping) -> Iterator[str]:
    """Nothing is recorded after the motion."""
    record, end_time = scene["record"], scene["end_time"]
    times = {f"record.probes.{n}.stop": p["stop"] for n, p in record.get("probes", {}).items()}
    times |= {name_entry("record.snapshots", i): t for i, t in enumerate(record["snapshots"])}
    if "grid" in record:
        times["record.grid.step"] = record["grid"]["step"]
    for key, time in times.items():
        if time > end_time:
            yield (
                f"{key} is {time}, beyond the end of the motion at end_time {end_time}: "
                f"give {end_time} or less, or raise end_time."
            )


# Heteroclinic orbits.


def dampings_are_normal(scene: Mapping) -> Iterator[str]:
    """A damping is 0 or leaves the energy of the orbit its digits."""
    for index, mu in enumerate(scene["mu"]):
        if 0 < mu < SMALLEST_DAMPING:
            yield (
                f"{name_entry('mu', index)} is {mu}, where the energy of the orbit loses its "
                f"digits: give 0, or {SMALLEST_DAMPING} or more."
            )


def profile_ends_before_underflow(scene: Mapping) -> Iterator[str]:
    """The fronts are kept where y is a double above zero."""
    profile, mu = scene["profile"], min(scene["mu"])
    last = GAUSSIAN_CENTRE + GAUSSIAN_HALF_WIDTH + LATER_UNDERFLOW * mu
    first = GAUSSIAN_CENTRE - GAUSSIAN_HALF_WIDTH if mu == 0 else -math.inf
    for key, found, beyond, limit in [
        ("stop", profile["stop"], profile["stop"] > last, last),
        ("start", profile["start"], profile["start"] < first, first),
    ]:
        if beyond:
            yield (
                f"profile.{key} is {found}, but for mu = {mu} y falls below the smallest double at "
                f"s = {limit:.2f}: end the profile before."
            )


def portrait_leaves_equilibria(scene: Mapping) -> Iterator[str]:
    """No trajectory of the plane starts in an equilibrium, where it would stay."""
    for index, (y, z) in enumerate(scene.get("portrait", {}).get("starts", [])):
        if z == 0 and y in (-1, 0, 1):
            yield (
                f"{name_entry('portrait.starts', index)} is [{y}, {z}], an equilibrium, where "
                "nothing moves: start beside it."
            )


def portrait_has_its_orbit(scene: Mapping) -> Iterator[str]:
    """The damping of a portrait is one of those whose orbit is computed."""
    mu = scene.get("portrait", {}).get("mu")
    if mu is not None and mu not in scene["mu"]:
        yield (
            f"portrait.mu is {mu}, but the orbit shown in the portrait is one of mu "
            f"{scene['mu']}: choose one of these, or add {mu} to mu."
        )


# Rings.


def start_does_not_pull(scene: Mapping) -> Iterator[str]:
    """A rescaled force is not negative, since no contact pulls."""
    smallest = min(scene["start"].get("rescaled_force", [0.0]))
    if smallest < 0:
        yield (
            f"start.rescaled_force has {smallest} as its smallest value, but a contact cannot "
            "pull: give values of 0 or more."
        )


def start_is_periodic(scene: Mapping) -> Iterator[str]:
    """The values at −ℓ and ℓ are equal, since these are one point of the ring."""
    first, *_, last = scene["start"].get("rescaled_force", [0.0, 0.0])
    if first != last:
        yield (
            f"start.rescaled_force begins with {first} and ends with {last}, but on a ring both "
            "ends are one point: give a periodic start."
        )


def plateau_fits_ring(scene: Mapping) -> Iterator[str]:
    """A start (49) falls to its floor within −ℓ ≤ ξ ≤ ℓ."""
    half_length = scaling_of(scene).half_length(scene["half_beads"])
    half_width = scene["start"].get("half_width", -1.0)
    if half_width + 1.0 > half_length:
        yield (
            f"start.half_width is {half_width}, and with its edge of width 1 the plateau exceeds "
            f"half the ring, ℓ = (p − 1/2) ε = {half_length:.6g}: lower it or raise half_beads."
        )


def grids_hold_edge(scene: Mapping) -> Iterator[str]:
    """Cells are no wider than the edge of a wave allows."""
    length = 2.0 * scaling_of(scene).half_length(scene["half_beads"])
    needed = math.ceil(CELLS_PER_EDGE * length)
    equations = scene["equations"]
    counts = {f"{name}.cells": equations[name]["cells"] for name in SOLVED_EQUATIONS}
    for name, found in (counts | {"upwind.points": equations["upwind"]["points"]}).items():
        if found < needed:
            yield (
                f"equations.{name} is {found}, too coarse to hold the edge of the wave, of width 1 "
                f"on a ring of length 2ℓ = {length:.6g}: give {needed} or more."
            )


def equation_tolerances_above_floor(scene: Mapping) -> Iterator[str]:
    """No error per step drowns in rounding."""
    for name in SOLVED_EQUATIONS:
        tolerance = scene["equations"][name]["tolerance"]
        if tolerance < EQUATION_TOLERANCE_FLOOR:
            yield (
                f"equations.{name}.tolerance is {tolerance}, under the solver's floor of "
                f"{EQUATION_TOLERANCE_FLOOR}: ask for the floor or more."
            )


Constraint = Callable[[Mapping], Iterator[str]]

CONSTRAINTS: dict[str, tuple[Constraint, ...]] = {
    "scenes.chain.*": (
        relative_tolerance_above_floor,
        absolute_tolerance_resolves_motion,
        ring_is_set_in_motion,
        start_lists_every_bead,
        start_agrees_with_piston,
        ends_of_contacts_are_pressed,
        strains_lie_in_domain,
        softening_start_is_compressed,
        probes_are_on_chain,
        arrival_level_can_be_met,
        record_ends_with_motion,
    ),
    "scenes.heteroclinic.*": (
        dampings_are_normal,
        profile_ends_before_underflow,
        portrait_leaves_equilibria,
        portrait_has_its_orbit,
    ),
    "scenes.periodic.*": (
        relative_tolerance_above_floor,
        absolute_tolerance_resolves_motion,
        start_does_not_pull,
        start_is_periodic,
        plateau_fits_ring,
        grids_hold_edge,
        equation_tolerances_above_floor,
        record_ends_with_motion,
    ),
    "scenes.front.*": (),
    "exact_fronts.survey": (),
    "exact_fronts.critical_damping": (),
    "exact_fronts.multipliers": (),
    "exact_fronts.trends": (),
    "laws.materials": (beads_are_solid,),
    "laws.damping_regimes": (),
    "laws.numerical_damping": (theta_steps_meet_end,),
    "laws.half_step_damping": (chain_of_half_steps_is_measured,),
    "laws.jump_conditions": (
        laws_of_cases_are_possible,
        states_differ,
        states_are_compressed,
    ),
    "laws.choice_of_variables": (),
    "laws.limiting_cases": (pressed_chains_hold_waves,),
    "laws.piston": (relative_tolerance_above_floor, piston_tolerance_resolves_motion),
    "precision.log_burgers.*": (),
    "precision.chain.*": (),
    "precision.ring.*": (),
    "precision.heteroclinic.*": (),
    "precision.fronts.*": (),
    "honesty.*": (),
    "explorer": (),
    "proofs": (shown_front_is_proved, parts_increase),
}
"""Constraints by the path of a section.

`ranges_increase`, `steps_fit_ranges` and `energies_are_representable` bind every section.
"""


def _mappings(value: object, key: str = "") -> Iterator[tuple[str, Mapping]]:
    """Every mapping inside a value, with its dotted key."""
    if isinstance(value, Mapping):
        yield key, value
        for name, item in value.items():
            yield from _mappings(item, f"{key}.{name}" if key else name)
