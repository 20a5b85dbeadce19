"""Scenes of the family ``chain``: motions of a finite chain of beads, section 3.3."""

import math
from collections.abc import Iterator, Mapping

from granular_fronts.scenes.beads import bead_count, contact_count, has_materials, patterns_fit
from granular_fronts.scenes.drives import (
    key_of_drive,
    value_at_start,
)
from granular_fronts.scenes.laws import (
    absolute_tolerance_errors,
    decades,
    decades_of_displacement,
    exponent_of,
    made_law,
)
from granular_fronts.scenes.schema import name_entry
from granular_fronts.scenes.sections import Check

RELATIVE_TOLERANCE_FLOOR = 1.0e-15
"""Smallest relative tolerance the solver can honour: a few units of double-precision round-off."""

LARGEST_OVERSHOOT = 10.0
"""Compression that no chain at rest reaches, over the largest relative displacement that drives it.

Chains of 2 to 21 beads without damping, pressed or pushed from both ends, stay below 3.5 for α of 1
to 1.5.
"""

HELD_ENDS = {
    "pressure": {"left", "right"},
    "force": {"right"},
    "piston": {"right"},
    "ring": set(),
    "wall": {"left"},
}
"""Ends at which each kind of boundary holds a relative displacement."""


def relative_tolerance_above_floor(section: Mapping) -> Iterator[str]:
    """No solver in double precision honours less."""
    relative = section["tolerance"]["relative"]
    if relative < RELATIVE_TOLERANCE_FLOOR:
        yield (
            f"tolerance.relative is {relative}, under the solver's floor of "
            f"{RELATIVE_TOLERANCE_FLOOR}, which double precision sets: "
            "ask for the floor or more."
        )


def absolute_tolerance_resolves_motion(scene: Mapping) -> Iterator[str]:
    """The absolute tolerance lies between rounding and the size of the motion."""
    absolute = scene["tolerance"]["absolute"]
    yield from absolute_tolerance_errors(absolute, decades_of_displacement(scene))


def _ring_is_set_in_motion(scene: Mapping) -> Iterator[str]:
    """A ring has a given start, since nothing pushes it."""
    if scene["boundary"]["kind"] == "ring" and scene["start"]["kind"] != "given":
        yield (
            f"start.kind is {scene['start']['kind']}, but nothing sets a ring in motion: "
            "use kind given, with relative_displacement and velocity."
        )


def _start_lists_every_bead(scene: Mapping) -> Iterator[str]:
    """A given start lists a number for each bead and each contact."""
    if scene["start"]["kind"] != "given":
        return
    beads, contacts = bead_count(scene), contact_count(scene)
    for key, expected in [("relative_displacement", contacts), ("velocity", beads)]:
        found = len(scene["start"][key])
        if found != expected:
            yield (
                f"start.{key} has {found} numbers, but {beads} beads with boundary "
                f"{scene['boundary']['kind']} need {expected}: give one for each."
            )


def _start_agrees_with_piston(scene: Mapping) -> Iterator[str]:
    """The given velocity of bead 1 is the one its piston begins with."""
    boundary, start = scene["boundary"], scene["start"]
    if boundary["kind"] != "piston" or start["kind"] != "given":
        return
    begins = value_at_start(boundary)
    found = start["velocity"][0] if start["velocity"] else begins
    if found != begins:
        yield (
            f"start.velocity begins with {found}, but bead 1 is a piston that begins at the "
            f"velocity {begins:.17g}: give {begins:.17g} first."
        )


def _ends_of_contacts_are_pressed(scene: Mapping) -> Iterator[str]:
    """No end or piston pulls, and no level of arrival is stretched, where contacts open."""
    if exponent_of(scene["law"]) is None:
        return
    boundary = scene["boundary"]
    for end in ("left", "right"):
        if boundary.get(end, 0) < 0:
            yield f"boundary.{end} is {boundary[end]}, below its limit 0: give 0 or more."
    velocity = boundary.get("velocity", 0)
    # A function of time may retreat for a while.
    if not isinstance(velocity, Mapping) and velocity < 0:
        yield (
            f"boundary.velocity is {velocity}, below its limit 0: give 0, a wall, or a number "
            "above 0."
        )
    if (level := scene["record"].get("arrival_level", 1)) <= 0:
        yield f"record.arrival_level is {level}, but must be above 0: give a number above 0."


def _strains_lie_in_domain(scene: Mapping) -> Iterator[str]:
    """The law holds for the contacts at the ends that are held, and at the start."""
    low, high = made_law(scene["law"]).domain
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


def _materials_touch_by_hertz(scene: Mapping) -> Iterator[str]:
    """The exponent of spheres is 3/2."""
    if has_materials(scene) and (alpha := exponent_of(scene["law"]) or 0.0) != 1.5:
        yield (
            f"beads names materials, which touch by Hertz's law, but law.alpha is {alpha}: give "
            "alpha 1.5, or masses."
        )


def _ends_bear_the_start(scene: Mapping) -> Iterator[str]:
    """A chain in equilibrium is held by what bears its weight; a body force needs such an end."""
    boundary, kind, gravity = scene["boundary"], scene["start"]["kind"], scene.get("gravity", 0.0)
    driven = boundary["kind"] in ("force", "piston")
    if gravity and boundary["kind"] in ("ring", "piston"):
        yield (
            f"gravity is {gravity}, but boundary.kind is {boundary['kind']}: take pressure at both "
            "ends, a force or a wall."
        )
    if kind not in ("equilibrium", "striker"):
        return
    if boundary["kind"] == "ring" or (boundary["kind"] == "piston" and kind == "striker"):
        yield f"start.kind is {kind}, but boundary.kind is {boundary['kind']}: take a wall."
    elif driven and gravity:
        yield (
            f"start.kind is {kind}, but gravity is {gravity} and boundary.kind {boundary['kind']}, "
            "which do not balance: take a wall."
        )
    elif boundary["kind"] == "pressure" and (gravity or boundary["left"] != boundary["right"]):
        yield (
            f"start.kind is {kind}, but boundary.left is {boundary['left']}, boundary.right "
            f"{boundary['right']} and gravity {gravity}, which do not balance: take a wall, or "
            "equal ends without gravity."
        )
    elif boundary.get("left", 0.0) < 0.0:
        yield (
            f"start.kind is {kind}, but boundary.left is {boundary['left']}, which pulls: give 0 "
            "or more."
        )
    elif gravity < 0.0:
        yield (f"gravity is {gravity}, away from the wall that bears the chain: give 0 or more.")


def _striker_hits(scene: Mapping) -> Iterator[str]:
    """The striker moves, and leaves beads to hit."""
    start = scene["start"]
    if start["kind"] != "striker":
        return
    if start["velocity"] == 0.0:
        yield "start.velocity is 0, but a striker moves: give another velocity."
    if start["beads"] >= bead_count(scene):
        yield (
            f"start.beads is {start['beads']}, but the chain has {bead_count(scene)} beads: give "
            f"{bead_count(scene) - 1} or fewer."
        )


def _softening_start_is_compressed(scene: Mapping) -> Iterator[str]:
    """With α < 1 no contact just touches: its stiffness αu^(α − 1) would be infinite."""
    alpha = exponent_of(scene["law"])
    start, least = scene["start"], 0.0
    if start["kind"] in ("equilibrium", "striker"):
        # The first contact bears the least.
        boundary = scene["boundary"]
        driven = boundary["kind"] == "wall" and key_of_drive(boundary)
        pressed = value_at_start(boundary) if driven else 0.0
        pressed = boundary.get("left", boundary.get("right", pressed))
        least = pressed + max(scene.get("gravity", 0.0), 0.0)
    smallest = min(start.get("relative_displacement", [least]), default=math.inf)
    if alpha is not None and alpha < 1 and smallest <= 0:
        yield (
            f"law.alpha is {alpha}, below 1, where contacts are infinitely stiff at the smallest "
            f"relative displacement, {smallest}: take alpha of 1 or more, or compress all."
        )


def _series(scene: Mapping) -> dict[str, Mapping]:
    """Return every probe set and sensor by its key."""
    record = scene["record"]
    return {
        f"record.{kind}.{name}": entry
        for kind in ("probes", "sensors")
        for name, entry in record.get(kind, {}).items()
    }


def _series_are_on_chain(scene: Mapping) -> Iterator[str]:
    """Every probe and sensor is on the chain, and its name is its own."""
    limits = {"beads": bead_count(scene), "contacts": contact_count(scene)}
    named = {"grid": "of the record of the space–time grid"}
    for key, entry in _series(scene).items():
        name = key.rpartition(".")[2]
        if name in named:
            yield f"{key} has the name {named[name]}: give it another name."
        named[name] = f"of {key}"
        if not limits.keys() & entry.keys():
            yield f"{key} has neither contacts nor beads: say where it is."
        for places, most in limits.items():
            for number in entry.get(places, []):
                if number > most:
                    yield (
                        f"{key}.{places} names {places[:-1]} {number}, but the chain has {most} "
                        f"{places}: choose one of 1 to {most}."
                    )


def _arrival_level_can_be_met(scene: Mapping) -> Iterator[str]:
    """A chain of equal beads at rest comes to the level at which a front has arrived."""
    level, size = scene["record"].get("arrival_level", 0.0), decades_of_displacement(scene)
    unlike = isinstance(scene["beads"], Mapping) or "contacts" in scene
    if scene["start"]["kind"] != "rest" or unlike or not math.isfinite(size):
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
    times = {f"{key}.stop": entry["stop"] for key, entry in _series(scene).items()}
    times |= {name_entry("record.snapshots", i): t for i, t in enumerate(record["snapshots"])}
    if "grid" in record:
        times["record.grid.step"] = record["grid"]["step"]
    for key, time in times.items():
        if time > end_time:
            yield (
                f"{key} is {time}, beyond the end of the motion at end_time {end_time}: "
                f"give {end_time} or less, or raise end_time."
            )


CHAIN: tuple[Check, ...] = (
    relative_tolerance_above_floor,
    absolute_tolerance_resolves_motion,
    _ring_is_set_in_motion,
    _start_lists_every_bead,
    _start_agrees_with_piston,
    _ends_of_contacts_are_pressed,
    _strains_lie_in_domain,
    patterns_fit,
    _materials_touch_by_hertz,
    _ends_bear_the_start,
    _striker_hits,
    _softening_start_is_compressed,
    _series_are_on_chain,
    _arrival_level_can_be_met,
    record_ends_with_motion,
)
