"""What config/referee.yaml asks for, checked before anything is computed.

The schema ``workflow/schemas/referee.schema.yaml`` says which keys there are; what ties two keys
together is checked here.  Each error is a sentence.
"""

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

from granular_fronts.errors import InputError
from granular_fronts.scenes.limits import Part, part_errors
from granular_fronts.scenes.schema import name_entry, violations
from granular_fronts.scenes.yaml_files import read_yaml

SAME = 1.0e-9
"""Relative distance of a quotient from a whole number that counts as none."""

NUMBERS_OF_A_BEAD = 4
"""Held of each state: relative displacement and velocity, of the solution and of its refinement."""


def read_settings(file: Path | str) -> dict[str, Any]:
    """Read the section ``referee`` of a file.

    Parameters
    ----------
    file : Path or str
        Usually config/referee.yaml.

    Returns
    -------
    dict
        What `load_problems` takes.

    Raises
    ------
    InputError
        With a sentence for each thing that is wrong: the file's YAML, its keys and values.
    """
    given = read_yaml(file)
    raise_if_any(violations(given, schema="referee"))
    return given["referee"]


def check_settings(settings: Mapping[str, Any]) -> None:
    """Check a section ``referee``.

    Parameters
    ----------
    settings : mapping

    Raises
    ------
    InputError
        With a sentence for each thing that is wrong.
    """
    raise_if_any(violations(settings, definition="settings", schema="referee"))
    raise_if_any([*factor_errors(settings["factors"]), *motion_errors(settings)])


def raise_if_any(sentences: Iterable[str]) -> None:
    """Raise an InputError of some sentences about the settings, one a line, if there are any."""
    errors = [f"config/referee.yaml: {sentence}" for sentence in sentences]
    if errors:
        raise InputError("\n".join(errors))


def factor_errors(factors: list[float]) -> Iterator[str]:
    """A damping is read off a table that increases and holds the problem's own."""
    for place, (before, factor) in enumerate(pairwise(factors), 1):
        if factor <= before:
            yield (
                f"{name_entry('factors', place)} is {factor}, not above {before} before it: list "
                "them in increasing order."
            )
    if 1 not in factors:
        yield "factors does not hold 1, the damping of the problem itself: add 1."


def motion_errors(settings: Mapping[str, Any]) -> Iterator[str]:
    """Motions have known dampings, end at a state, collide in pairs, and fit into memory."""
    for motion, chain in settings["motions"].items():
        for damping in chain["dampings"]:
            if damping not in settings["dampings"]:
                yield (
                    f"motions.{motion}.dampings names {damping!r}, which is unknown: choose from "
                    f"{', '.join(settings['dampings'])}."
                )
        intervals = chain["end_time"] / settings["interval"]
        if abs(intervals - round(intervals)) > SAME * intervals:
            yield (
                f"motions.{motion}.end_time is {chain['end_time']}, no multiple of interval "
                f"{settings['interval']}, so that no state is compared at the end: change one."
            )
        if motion == "collision" and chain["beads"] != 2:
            yield f"motions.collision.beads is {chain['beads']}, but two beads collide: write 2."
        states = NUMBERS_OF_A_BEAD * chain["beads"] * intervals
        size = Part(("beads", "end_time"), ("interval",), numbers=states)
        for sentence in part_errors({**chain, "interval": settings["interval"]}, [size]):
            yield f"motions.{motion}: {sentence}"
