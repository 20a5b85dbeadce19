"""Sections under ``laws`` whose keys are tied together."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.errors import InputError
from granular_fronts.model.laws import make_law
from granular_fronts.model.materials import material_of
from granular_fronts.scenes.parts import name_entry
from granular_fronts.scenes.sections import Check

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
        try:
            law = make_law(elastic=case["elastic"], viscous=case["dissipation"])
        except InputError as error:
            yield f"{key}.law: {error}"
            continue
        low, high = law.domain
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


LAWS: dict[str, tuple[Check, ...]] = {
    "materials": (_beads_are_solid,),
    "numerical_damping": (_theta_steps_meet_end,),
    "half_step_damping": (_chain_of_half_steps_is_measured,),
    "jump_conditions": (_fronts_of_cases_are_possible,),
    "limiting_cases": (pressed_chains_hold_waves,),
}
