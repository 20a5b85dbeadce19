"""Sections under ``laws`` whose keys are tied together, or whose work the schema does not limit."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.errors import InputError
from granular_fronts.model.materials import material_of
from granular_fronts.scenes.laws import domain_of, law_errors
from granular_fronts.scenes.limits import (
    COLUMNS_PER_ROW,
    NUMBERS_PER_BEAD,
    SECONDS_PER_CROSSING,
    SECONDS_PER_POINT,
    Part,
)
from granular_fronts.scenes.schema import name_entry
from granular_fronts.scenes.sections import TABLE, Need, Section

DENSITIES = 1.0, 30_000.0
"""Densities of solid beads in kg/m³, from foams to beyond osmium (22 590)."""

BEADS_PER_TIME = 1.15
"""Beads that a wave from the compression 1 runs through in a unit of time, with a margin."""

FORMING_TIME = 16.0
"""End of the shortest motion, over 1 + γ, in which a pressed wave passes its own width.

Of α = 1 the width from 90 to 10 per cent grows like 2.56 (γt)^(1/2); it is seen at a quarter too.
"""

THETA_END_ERROR = 1.0e-9
"""Rounding of end_time over a step of the θ-method, relative to end_time."""


def _beads_are_solid(materials: Mapping) -> Iterator[str]:
    """Mass and radius belong to a solid, in SI units, of a known material."""
    for name, bead in materials["beads"].items():
        try:
            material_of(name)
        except InputError as error:
            yield f"beads.{name}: {error}"
        density = 0.75 * bead["mass"] / math.pi / bead["radius"] ** 3
        lightest, heaviest = DENSITIES
        if not lightest <= density <= heaviest:
            yield (
                f"beads.{name}.radius is {bead['radius']} and its mass {bead['mass']}, a density "
                f"of {density:.2g} kg/m³, outside {lightest:g} to {heaviest:g} of solids: give "
                "metres and kilograms."
            )


def _theta_steps_meet_end(section: Mapping) -> Iterator[str]:
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


def _chain_of_half_steps_is_measured(section: Mapping) -> Iterator[str]:
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


def _fronts_of_cases_are_possible(section: Mapping) -> Iterator[str]:
    """Both potentials of every case exist, and a front joins two different states of theirs."""
    for name, case in section["cases"].items():
        key = f"cases.{name}"
        law = {"elastic": case["elastic"], "viscous": case["dissipation"]}
        errors = [*law_errors({"law": law})]
        yield from (f"{key}.{error}" for error in errors)
        low, high = (-math.inf, math.inf) if errors else domain_of(law)
        behind, ahead = case["states"]
        for state in (behind, ahead):
            if not low < state < high:
                yield (
                    f"{key}.states has {state}, but its law holds for strains between {low:g} "
                    f"and {high:g} only: give states between."
                )
        if behind == ahead:
            yield (
                f"{key}.states are {behind} and {ahead}, but a front joins two different states: "
                "change one."
            )
            continue
        for force in ("elastic", "dissipation"):
            if case[force]["kind"] in ("hertz", "power") and min(behind, ahead) >= 0:
                yield (
                    f"{key}.states are {behind} and {ahead}, where the {force} force of Hertz "
                    "vanishes, since no strain is below 0: give a compressed state, below 0."
                )


def _size_of_theta_method(section: Mapping) -> Iterator[Part]:
    """A motion by equal steps for each θ and each step."""
    order, profile = section["order"], section["profile"]
    for name, motion, key, step, motions in [
        ("order", order, "order.steps", min(order["steps"]), len(order["thetas"])),
        ("profile", profile, "profile.step", profile["step"], 1),
    ]:
        work = motions * float(motion["beads"]) * motion["end_time"] / step
        numbers = NUMBERS_PER_BEAD * float(motion["beads"])
        keys = f"{name}.beads", f"{name}.end_time"
        yield Part(keys, (key,), numbers, work * SECONDS_PER_POINT)


def _size_of_half_steps(section: Mapping) -> Iterator[Part]:
    """A motion by equal steps for each law, damping and step, of which every state is held."""
    length = float(section["beads"]) * section["collision_times"]
    counts = section["steps_per_collision"]
    motions = len(section["betas"]) * len(section["gammas"])
    numbers, work = COLUMNS_PER_ROW * length * max(counts), motions * length * sum(counts)
    keys = "beads", "collision_times", "steps_per_collision"
    yield Part(keys, (), numbers, work * SECONDS_PER_POINT)


def _size_of_limiting_cases(section: Mapping) -> Iterator[Part]:
    """Rings of 2ℓ/ε beads over the time τ/(½γε²), with ε = (α − 1)/(αγ) and c = 1."""
    rings = section["rings"]
    cubes = sum((exponent / (exponent - 1.0)) ** 3 for exponent in rings["exponents"])
    crossings = 4.0 * rings["half_length"] * rings["slow_time"] * rings["gamma"] ** 2 * cubes
    keys = "rings.half_length", "rings.slow_time", "rings.gamma"
    yield Part(keys, (), 0.0, crossings * SECONDS_PER_CROSSING)


LAWS = {
    "materials": Section(
        checks=(_beads_are_solid,),
        needs=tuple(Need(f"beads.{name}", TABLE) for name in ("glass", "steel", "cork")),
    ),
    "numerical_damping": Section((_theta_steps_meet_end,), _size_of_theta_method),
    "half_step_damping": Section((_chain_of_half_steps_is_measured,), _size_of_half_steps),
    "jump_conditions": Section((_fronts_of_cases_are_possible,)),
    "limiting_cases": Section((pressed_chains_hold_waves,), _size_of_limiting_cases),
}
