"""Constraints of laws: of scenes, and of the sections under ``laws``, beads, states and pistons."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.scenes.laws import decades_of_impact, domain_of, exponent_of, law_errors
from granular_fronts.scenes.scales import MOST_DECADES, absolute_tolerance_errors
from granular_fronts.scenes.schema import name_entry

DENSITIES = 1.0, 30_000.0
"""Densities of solid beads in kg/m³, from foams to beyond osmium (22 590)."""

MODULI = 1.0e4, 2.0e12
"""Young's moduli of solid beads in Pa, from gels to beyond diamond (1.2e12)."""

BEADS_PER_TIME = 1.15
"""Beads that a wave from the compression 1 runs through in a unit of time, with a margin."""

FORMING_TIME = 16.0
"""End of the shortest motion, over 1 + γ, in which a pressed wave passes its own width.

Of α = 1 the width from 90 to 10 per cent grows like 2.56 (γt)^(1/2); it is seen at a quarter too.
"""

HELD_ENDS = {"pressure": {"left", "right"}, "piston": {"right"}, "ring": set()}
"""Ends at which each kind of boundary holds a relative displacement."""

THETA_END_ERROR = 1.0e-9
"""Rounding of end_time over a step of the θ-method, relative to end_time."""


def softening_start_is_compressed(scene: Mapping) -> Iterator[str]:
    """With α < 1 no contact just touches: its stiffness αu^(α − 1) would be infinite."""
    alpha = exponent_of(scene["law"])
    smallest = min(scene["start"].get("relative_displacement", [0.0]), default=math.inf)
    if alpha is not None and alpha < 1 and smallest <= 0:
        yield (
            f"law.alpha is {alpha}, below 1, where the stiffness of an uncompressed contact is "
            f"infinite, and the smallest relative displacement at the start is {smallest}: "
            "take alpha of 1 or more, or a start compressed everywhere."
        )


def ends_of_contacts_are_pressed(scene: Mapping) -> Iterator[str]:
    """No end or piston pulls, and no level of arrival is stretched, where contacts open."""
    if exponent_of(scene["law"]) is None:
        return
    boundary = scene["boundary"]
    found = {f"boundary.{end}": boundary.get(end, 0) for end in ("left", "right")}
    for key, value in found.items():
        if value < 0:
            yield f"{key} is {value}, below its limit 0: give 0 or more."
    velocity = boundary.get("velocity", 1)
    if velocity <= 0:
        yield f"boundary.velocity is {velocity}, but must be above 0: give a number above 0."
    level = scene["record"].get("arrival_level", 1)
    if level <= 0:
        yield f"record.arrival_level is {level}, but must be above 0: give a number above 0."


def strains_lie_in_domain(scene: Mapping) -> Iterator[str]:
    """The law holds for the contacts at the ends that are held, and at the start."""
    low, high = domain_of(scene["law"])
    boundary, start = scene["boundary"], scene["start"]
    held = sorted(HELD_ENDS[boundary["kind"]])
    found = {f"boundary.{end}": boundary.get(end, 0) for end in held}
    if start["kind"] == "rest":
        found["start.relative_displacement of a chain at rest"] = 0
    found |= {
        name_entry("start.relative_displacement", index): u
        for index, u in enumerate(start.get("relative_displacement", []))
    }
    for key, u in found.items():
        if not low < -u < high:
            yield (
                f"{key} is {u}, but the law holds for relative displacements between {-high:g} "
                f"and {-low:g} only: give one between, or another law."
            )


def beads_are_solid(materials: Mapping) -> Iterator[str]:
    """Mass, radius and Young's modulus are those of a solid in SI units."""
    for name, bead in materials["beads"].items():
        density = 0.75 * bead["mass"] / math.pi / bead["radius"] ** 3
        lightest, heaviest = DENSITIES
        if not lightest <= density <= heaviest:
            yield (
                f"beads.{name}.radius is {bead['radius']} and its mass {bead['mass']}, a density "
                f"of {density:.2g} kg/m³, outside {lightest:g} to {heaviest:g} of solids: give "
                "metres and kilograms."
            )
        softest, stiffest = MODULI
        if not softest <= bead["youngs_modulus"] <= stiffest:
            yield (
                f"beads.{name}.youngs_modulus is {bead['youngs_modulus']} Pa, outside "
                f"{softest:g} to {stiffest:g} Pa of solids: give pascals; 70 GPa are 7.0e+10."
            )


def theta_steps_meet_end(section: Mapping) -> Iterator[str]:
    """The end of each motion by the θ-method is a multiple of each of its steps."""
    order, profile = section["order"], section["profile"]
    steps = {name_entry("order.steps", i): (s, order) for i, s in enumerate(order["steps"])}
    for key, (step, motion) in (steps | {"profile.step": (profile["step"], profile)}).items():
        end = motion["end_time"]
        whole = math.floor(end / step + 0.5) if end / step < math.inf else 0
        if whole < 1 or abs(whole * step - end) > THETA_END_ERROR * end:
            yield (
                f"{key} is {step}, and no whole number of such steps ends at end_time {end}: give "
                "a step that divides end_time."
            )


def chain_of_half_steps_is_measured(section: Mapping) -> Iterator[str]:
    """The chain that is shown is one of those that are measured."""
    for name in ("beta", "gamma"):
        value, measured = section["shown"][name], section[f"{name}s"]
        if value not in measured:
            yield (
                f"shown.{name} is {value}, but {name}s are {', '.join(map(str, measured))}: show "
                "one of these, or add it."
            )


def pressed_chains_hold_waves(section: Mapping) -> Iterator[str]:
    """The waves of pressed chains run past their own width, and not to the last bead."""
    beads, end = section["beads"], section["end_time"]
    if beads < BEADS_PER_TIME * end:
        yield (
            f"beads is {beads}, but waves run through about {BEADS_PER_TIME * end:.3g} beads until "
            f"end_time {end:g}: give more beads, or a smaller end_time."
        )
    name = max("weak_gamma", "strong_gamma", key=section.__getitem__)
    least = FORMING_TIME * (1.0 + section[name])
    if end < least:
        yield (
            f"end_time is {end}, but with {name} {section[name]:g} a wave needs {least:.3g} to run "
            f"past its own width: give {least:.3g} or more, or a smaller {name}."
        )


def piston_tolerance_resolves_motion(section: Mapping) -> Iterator[str]:
    """The absolute tolerance suits the compression that the piston makes with each law."""
    for law in section["cases"].values():
        size = decades_of_impact(law, section["velocity"], MOST_DECADES)
        errors = [*absolute_tolerance_errors(section["tolerance"]["absolute"], size)]
        if errors:
            yield from errors
            return


def laws_of_cases_are_possible(section: Mapping) -> Iterator[str]:
    """Both potentials of every case exist, and hold in its states."""
    for name, case in section["cases"].items():
        law = {"elastic": case["elastic"], "viscous": case["dissipation"]}
        errors = [*law_errors({"law": law})]
        yield from (f"cases.{name}.{error}" for error in errors)
        if errors:
            continue
        low, high = domain_of(law)
        for state in case["states"]:
            if not low < state < high:
                yield (
                    f"cases.{name}.states has {state}, but its law holds for strains between "
                    f"{low:g} and {high:g} only: give states between."
                )


def states_are_compressed(section: Mapping) -> Iterator[str]:
    """A force of Hertz acts in one of the two states at the least."""
    for name, case in section["cases"].items():
        behind, ahead = case["states"]
        for force in ("elastic", "dissipation"):
            is_contact = case[force]["kind"] in ("hertz", "power")
            if is_contact and behind != ahead and min(behind, ahead) >= 0:
                yield (
                    f"cases.{name}.states are {behind} and {ahead}, where the {force} force of "
                    "Hertz vanishes, since no strain is below 0: give a compressed state, below 0."
                )


def states_differ(section: Mapping) -> Iterator[str]:
    """The two states that a front joins are not the same."""
    for name, case in section["cases"].items():
        behind, ahead = case["states"]
        if behind == ahead:
            yield (
                f"cases.{name}.states are {behind} and {ahead}, but a front joins two different "
                "states: change one."
            )
