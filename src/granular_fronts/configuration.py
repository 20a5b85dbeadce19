"""Read and check what a user asks for, before anything is computed.

The schema in ``workflow/schemas`` says which keys exist, what each means in the paper and in which
range it lies. The functions ``refuse_...`` below add what a schema cannot express, because it ties
two keys together. Whatever is impossible ends as a sentence that names the scene, the key, its
value, the limit and the way out.

This module imports neither numpy nor numba: the workflow checks its configuration at each start.
"""

import functools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

import yaml

from granular_fronts.errors import InputError
from granular_fronts.schema import name_entry, tell_violations
from granular_fronts.slow_scales import scaling_of

RELATIVE_TOLERANCE_FLOOR = 1.0e-15
"""Smallest relative tolerance the solver can honour: a few units of double-precision round-off."""

EQUATION_TOLERANCE_FLOOR = 1.0e-13
"""Smallest error per step that the rounding of a rescaled variable of order 1 lets through."""

CELLS_PER_EDGE = 2
"""Fewest cells over a unit of ξ, the width of the falling edge of eq. (49)."""


class ConfigurationError(InputError):
    """A configuration or a scene that cannot be computed; the message is for people."""


def load_configuration(*files: Path | str) -> dict:
    """Read YAML files and lay each over the ones before it.

    Parameters
    ----------
    *files : Path or str
        The first holds the defaults, each later one overrides single keys.

    Returns
    -------
    dict
        The merged configuration, not yet checked.
    """
    layers = [yaml.safe_load(Path(file).read_text(encoding="utf-8")) or {} for file in files]
    return functools.reduce(merge, layers, {})


def merge(below: Mapping, above: Mapping) -> dict:
    """Lay one mapping over another, key by key at any depth.

    Parameters
    ----------
    below, above : Mapping
        Where both hold a mapping under a key, the two are merged; otherwise `above` wins. A list
        is replaced as a whole. This is how Snakemake merges its configuration files.

    Returns
    -------
    dict
        The merged mapping; the arguments are left alone.
    """
    merged = dict(below)
    for key, value in above.items():
        both_mappings = isinstance(value, Mapping) and isinstance(below.get(key), Mapping)
        merged[key] = merge(below[key], value) if both_mappings else value
    return merged


def check_configuration(configuration: Mapping) -> None:
    """Refuse a configuration that cannot be computed.

    Parameters
    ----------
    configuration : Mapping
        The merged configuration.

    Raises
    ------
    ConfigurationError
        With one sentence for each thing that is wrong.
    """
    sentences = [*tell_violations(configuration)]
    if not sentences:
        for family, refusals in REFUSALS.items():
            for name, scene in configuration["scenes"][family].items():
                sentences += _tell_impossibilities(scene, name, refusals)
    _raise_if_any(sentences)


def check_scene(family: str, scene: Mapping, name: str) -> dict:
    """Refuse a scene that cannot be computed.

    Parameters
    ----------
    family : str
        Key under ``scenes`` of the configuration, for example ``chain``.
    scene : Mapping
        One entry of that family; numpy arrays and numbers are welcome.
    name : str
        What the sentences call the scene.

    Returns
    -------
    dict
        The scene in plain Python values, as a configuration file would hold it.

    Raises
    ------
    ConfigurationError
        With one sentence for each thing that is wrong.
    """
    scene = _plain(scene)
    place = ("scenes", family, name)
    sentences = [*tell_violations(scene, definition=f"{family}_scene", place=place)]
    if not sentences:
        sentences = _tell_impossibilities(scene, name, REFUSALS[family])
    _raise_if_any(sentences)
    return scene


def _raise_if_any(sentences: Sequence[str]) -> None:
    if sentences:
        raise ConfigurationError("\n".join(sentences))


def _plain(value: object) -> object:
    """Turn numpy values and mappings into what YAML would have given."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value


# What ties two keys together, and so stands in no schema.


def refuse_non_finite_numbers(scene: Mapping) -> Iterator[str]:
    """Refuse .nan and .inf, which YAML reads and every comparison lets pass."""
    for key, value in _leaves(scene):
        if isinstance(value, float) and not math.isfinite(value):
            yield f"{key} is {value}, but must be finite: give a number."


def refuse_relative_tolerance_below_floor(scene: Mapping) -> Iterator[str]:
    """Refuse what no solver in double precision honours."""
    relative = scene["tolerance"]["relative"]
    if relative < RELATIVE_TOLERANCE_FLOOR:
        yield (
            f"tolerance.relative is {relative}, under the solver's floor of "
            f"{RELATIVE_TOLERANCE_FLOOR}, which double precision sets: "
            "ask for the floor or more."
        )


def refuse_ring_at_rest(scene: Mapping) -> Iterator[str]:
    """Refuse a ring without a given start, since nothing pushes it."""
    if scene["boundary"]["kind"] == "ring" and scene["start"]["kind"] != "given":
        yield (
            f"start.kind is {scene['start']['kind']}, but nothing sets a ring in motion: "
            "use kind given, with relative_displacement and velocity."
        )


def refuse_start_of_wrong_length(scene: Mapping) -> Iterator[str]:
    """Refuse a start that does not list a number for each bead and each contact."""
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


def refuse_start_against_piston(scene: Mapping) -> Iterator[str]:
    """Refuse a given velocity of bead 1 that is not the one its piston begins with."""
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


def refuse_uncompressed_start_below_linear(scene: Mapping) -> Iterator[str]:
    """Refuse α < 1 from contacts that just touch: their stiffness αu^(α − 1) is infinite."""
    alpha = scene["law"]["alpha"]
    smallest = min(scene["start"].get("relative_displacement", [0.0]), default=math.inf)
    if alpha < 1 and smallest <= 0:
        yield (
            f"law.alpha is {alpha}, below 1, where the stiffness of an uncompressed contact is "
            f"infinite, and the smallest relative displacement at the start is {smallest}: "
            "take alpha of 1 or more, or a start compressed everywhere."
        )


def refuse_probe_beyond_chain(scene: Mapping) -> Iterator[str]:
    """Refuse a probe that stands on no bead."""
    for name, probe in scene["record"].get("probes", {}).items():
        for bead in probe["beads"]:
            if bead > scene["beads"]:
                yield (
                    f"record.probes.{name}.beads names bead {bead}, but the chain has "
                    f"{scene['beads']} beads: choose one of 1 to {scene['beads']}."
                )


def refuse_empty_probe_window(scene: Mapping) -> Iterator[str]:
    """Refuse a probe that stops before it begins."""
    for name, probe in scene["record"].get("probes", {}).items():
        if probe["start"] >= probe["stop"]:
            yield (
                f"record.probes.{name}.start is {probe['start']}, but must come before its stop "
                f"{probe['stop']}: start earlier or stop later."
            )


def refuse_record_after_end(scene: Mapping) -> Iterator[str]:
    """Refuse to record what comes after the motion."""
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


def refuse_empty_profile(scene: Mapping) -> Iterator[str]:
    """Refuse a profile that stops before it begins."""
    start, stop = scene["profile"]["start"], scene["profile"]["stop"]
    if start >= stop:
        yield (
            f"profile.start is {start}, but must come before its stop {stop}: "
            "start earlier or stop later."
        )


def refuse_damping_listed_twice(scene: Mapping) -> Iterator[str]:
    """Refuse to name one orbit twice, since the data are found by their μ."""
    for index, mu in enumerate(scene["mu"]):
        if mu in scene["mu"][:index]:
            yield (
                f"{name_entry('mu', index)} is {mu}, which stands before it already: list it once."
            )


def refuse_start_at_rest(scene: Mapping) -> Iterator[str]:
    """Refuse trajectories that start in an equilibrium of the plane and never leave it."""
    for index, (y, z) in enumerate(scene.get("portrait", {}).get("starts", [])):
        if z == 0 and y in (-1, 0, 1):
            yield (
                f"{name_entry('portrait.starts', index)} is [{y}, {z}], an equilibrium, where "
                "nothing moves: start beside it."
            )


def refuse_start_that_pulls(scene: Mapping) -> Iterator[str]:
    """Refuse a negative rescaled force, which no contact carries."""
    smallest = min(scene["start"].get("rescaled_force", [0.0]))
    if smallest < 0:
        yield (
            f"start.rescaled_force has {smallest} as its smallest value, but a contact cannot "
            "pull: give values of 0 or more."
        )


def refuse_start_that_is_not_periodic(scene: Mapping) -> Iterator[str]:
    """Refuse values that differ at −ℓ and ℓ, which are one point of the ring."""
    first, *_, last = scene["start"].get("rescaled_force", [0.0, 0.0])
    if first != last:
        yield (
            f"start.rescaled_force begins with {first} and ends with {last}, but on a ring both "
            "ends are one point: give a periodic start."
        )


def refuse_plateau_wider_than_ring(scene: Mapping) -> Iterator[str]:
    """Refuse a start (49) that does not fall to its floor within −ℓ ≤ ξ ≤ ℓ."""
    half_length = scaling_of(scene).half_length(scene["half_beads"])
    half_width = scene["start"].get("half_width", -1.0)
    if half_width + 1.0 > half_length:
        yield (
            f"start.half_width is {half_width}, and with its edge of width 1 the plateau exceeds "
            f"half the ring, ℓ = (p − 1/2) ε = {half_length:.6g}: lower it or raise half_beads."
        )


def refuse_grid_too_coarse_for_edge(scene: Mapping) -> Iterator[str]:
    """Refuse cells that are wider than the edge of a wave allows."""
    length = 2.0 * scaling_of(scene).half_length(scene["half_beads"])
    needed = math.ceil(CELLS_PER_EDGE * length)
    equations = scene["equations"]
    counts = {f"{name}.cells": equations[name]["cells"] for name in ("logarithmic", "unlimited")}
    for name, found in (counts | {"upwind.points": equations["upwind"]["points"]}).items():
        if found < needed:
            yield (
                f"equations.{name} is {found}, too coarse to hold the edge of the wave, of width 1 "
                f"on a ring of length 2ℓ = {length:.6g}: give {needed} or more."
            )


def refuse_equation_tolerance_below_floor(scene: Mapping) -> Iterator[str]:
    """Refuse an error per step that drowns in rounding."""
    for name in ("logarithmic", "unlimited"):
        tolerance = scene["equations"][name]["tolerance"]
        if tolerance < EQUATION_TOLERANCE_FLOOR:
            yield (
                f"equations.{name}.tolerance is {tolerance}, under the solver's floor of "
                f"{EQUATION_TOLERANCE_FLOOR}: ask for the floor or more."
            )


Refusal = Callable[[Mapping], Iterator[str]]

REFUSALS: dict[str, tuple[Refusal, ...]] = {
    "chain": (
        refuse_relative_tolerance_below_floor,
        refuse_ring_at_rest,
        refuse_start_of_wrong_length,
        refuse_start_against_piston,
        refuse_uncompressed_start_below_linear,
        refuse_probe_beyond_chain,
        refuse_empty_probe_window,
        refuse_record_after_end,
    ),
    "heteroclinic": (
        refuse_empty_profile,
        refuse_damping_listed_twice,
        refuse_start_at_rest,
    ),
    "front": (),
    "periodic": (
        refuse_relative_tolerance_below_floor,
        refuse_start_that_pulls,
        refuse_start_that_is_not_periodic,
        refuse_plateau_wider_than_ring,
        refuse_grid_too_coarse_for_edge,
        refuse_equation_tolerance_below_floor,
        refuse_record_after_end,
    ),
}


def _tell_impossibilities(scene: Mapping, name: str, refusals: Sequence[Refusal]) -> list[str]:
    """Say what is wrong with a scene that obeys the schema."""
    # The comparisons of the other refusals mean nothing for .nan.
    problems = [*refuse_non_finite_numbers(scene)] or [
        problem for refuse in refusals for problem in refuse(scene)
    ]
    return [f"Scene {name}: {problem}" for problem in problems]


def _leaves(value: object, key: str = "") -> Iterator[tuple[str, object]]:
    """Walk through the values of a nested mapping, each with its dotted key."""
    if isinstance(value, Mapping):
        for name, item in value.items():
            yield from _leaves(item, f"{key}.{name}" if key else name)
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _leaves(item, name_entry(key, index))
    else:
        yield key, value
