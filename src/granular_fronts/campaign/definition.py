"""Read and check a campaign file, and write its axes out.

The schema ``workflow/schemas/campaign.schema.yaml`` says which keys there are.  This module checks
what depends on the kind or ties two keys together.  Each error is a sentence, before any job.

The values of an axis are a list, or evenly or logarithmically spaced from start to stop.  Spaced
values are rounded to `DIGITS` significant digits, since a point is recognised by its values.  So
``linspace: [0, 1, 21]`` holds the values of ``[0, 1, 11]`` to the last bit.
"""

import difflib
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

from granular_fronts.campaign.kinds import KINDS, Kind
from granular_fronts.campaign.laws import PREFIX, errors_of_law, name_of, varied_numbers
from granular_fronts.campaign.motion_scenes import name_in_grid, point_errors, scene_errors
from granular_fronts.errors import InputError
from granular_fronts.scenes.memory import NUMBERS_PER_BEAD, Held, memory_problems
from granular_fronts.scenes.schema import violations
from granular_fronts.scenes.sections import ranges_increase
from granular_fronts.scenes.validation import raise_if_any
from granular_fronts.scenes.yaml_files import read_yaml

NAME = re.compile(r"[a-z][a-z0-9_]{0,99}(?<!_summary)")
"""A campaign's name, which becomes part of file names; x_summary is that of the summary of x."""

NUMBERS_PER_VALUE = 4
"""Memory of a value of an axis while it is written out, in numbers."""

MOST_POINTS = 1_000_000
"""Points of a campaign that need not be asked for with ``allow_large: true``."""

DEFAULT_TOLERANCE = 1.0e-9
DIGITS = 12


class Campaign(NamedTuple):
    """A checked campaign.

    Attributes
    ----------
    name, kind_name : str
    kind : Kind
        The kind with the parameters of this campaign.
    given : Mapping
        The contents of the campaign file.
    grid : dict of str to tuple
        Values of every parameter of the kind.  Parameters that do not vary come first and have one
        value; the last is the fast axis.  For beta, None means β = α.
    axes : tuple of str
        The parameters that vary.
    settings : dict
        What else decides the result of a point: `tolerance`, `scalars`, `profile` (or None); `law`,
        `start` and `scene` if the campaign gives them.
    chunk_points : int or None
        Most points of a chunk; None to choose it from what a point of the kind costs.
    """

    name: str
    kind_name: str
    kind: Kind
    given: Mapping
    grid: dict[str, tuple]
    axes: tuple[str, ...]
    settings: dict
    chunk_points: int | None

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each parameter of the grid."""
        return tuple(len(values) for values in self.grid.values())

    @property
    def size(self) -> int:
        """Number of points."""
        return math.prod(self.shape)

    def points_per_chunk(self, chunk_seconds: float) -> int:
        """Return the most points of a job that should take so much processor time."""
        usual = max(1, round(chunk_seconds / self.kind.seconds_per_point))
        return self.chunk_points or usual


def load_campaign(folder: Path | str, name: str) -> Campaign:
    """Read and check the campaign file of a name in a folder; as `check_campaign` otherwise."""
    files = {path.stem: path for path in sorted(Path(folder).glob("*.yaml"))}
    if name not in files:
        raise InputError(
            f"There is no campaign {name} in {folder}: choose one of {', '.join(files)}, or write "
            f"{folder}/{name}.yaml."
        )
    if not NAME.fullmatch(name):
        raise InputError(
            f"Campaign {name}: a name has lower-case letters, digits and underscores only, 100 at "
            f"most, a letter first and no _summary last: rename {files[name]}."
        )
    return check_campaign(read_yaml(files[name]), name)


def check_campaign(given: Mapping, name: str) -> Campaign:
    """Check the contents of a campaign file and write its axes out.

    An InputError has a sentence for each thing that is wrong.
    """
    _raise_if_any(name, violations(given, schema="campaign"))
    for check in (_form_errors, _choice_errors, _start_errors):
        _raise_if_any(name, check(given))
    law, fixed, record = given.get("law"), given.get("fixed", {}), given.get("record", {})
    rename = name_of if law else name_in_grid
    axes = {rename(axis): values for axis, values in given["axes"].items()}
    kind = KINDS[given["kind"]].of_start(given.get("start")).of_choice([*axes, *fixed])
    if law:
        kind = kind.of_law(varied_numbers(axes))
    if kind.of_scene:
        _raise_if_any(name, scene_errors(given))
        kind = kind.of_numbers(dict(zip(axes, given["axes"], strict=True)))
    for errors in (
        _name_errors(given["kind"], kind, axes, fixed, record),
        ranges_increase(given),
        _profile_errors(kind, record),
        (error for axis, values in axes.items() for error in _spacing_errors(axis, values)),
        _size_errors(kind, {**given, "axes": axes}),
    ):
        _raise_if_any(name, errors)
    varied = {axis: tuple(expand_axis(values)) for axis, values in axes.items()}
    constant = {
        parameter: (fixed.get(parameter, described.default),)
        for parameter, described in kind.parameters.items()
        if parameter not in varied
    }
    grid = constant | varied
    _raise_if_any(name, _count_errors(grid, given))
    _raise_if_any(name, _value_errors(kind, grid, varied))
    if kind.of_scene:
        _raise_if_any(name, point_errors(given["scene"], grid))
    elif law:
        _raise_if_any(name, errors_of_law(law, grid))
    scalars = record.get("scalars", list(kind.scalars))
    return Campaign(
        name=name,
        kind_name=given["kind"],
        kind=kind,
        given=given,
        grid=grid,
        axes=tuple(varied),
        settings={
            "tolerance": given.get("tolerance", DEFAULT_TOLERANCE),
            "scalars": sorted(scalars, key=list(kind.scalars).index),
            "profile": record.get("profile"),
        }
        | {key: given[key] for key in ("law", "start", "scene") if key in given},
        chunk_points=given.get("chunk_points"),
    )


def _raise_if_any(name: str, sentences: Iterator[str]) -> None:
    raise_if_any([f"Campaign {name}: {sentence}" for sentence in sentences])


def expand_axis(given: Sequence[float] | Mapping) -> list[float]:
    """Write out the values of an axis: a list, or a spacing with start, stop and count."""
    if not isinstance(given, Mapping):
        return [*given]
    [(spacing, (start, stop, count))] = given.items()
    fractions = [index / max(count - 1, 1) for index in range(count)]
    if spacing == "linspace":
        return [_round_value(start * (1.0 - f) + stop * f) for f in fractions]
    return [_round_value(start * (stop / start) ** f) for f in fractions]


def _round_value(value: float) -> float:
    """Round to `DIGITS` significant digits; a whole number stays one."""
    return value if isinstance(value, int) else float(f"{value:.{DIGITS}g}")


def _count_values(given: Sequence[float] | Mapping) -> int:
    if not isinstance(given, Mapping):
        return len(given)
    [(_, _, count)] = given.values()
    return count


def _spacing_errors(name: str, given: Sequence[float] | Mapping) -> Iterator[str]:
    """Say why an axis cannot be written out."""
    if not isinstance(given, Mapping):
        return
    [(spacing, (start, stop, count))] = given.items()
    if not (isinstance(count, int) and count >= 1):
        yield (
            f"axes.{name}.{spacing} asks for {count} values, but needs a whole number of 1 or "
            "more: write [start, stop, count]."
        )
    if spacing == "logspace" and min(start, stop) <= 0:
        yield (
            f"axes.{name}.logspace runs from {start} to {stop}, but a logarithmic axis needs "
            "both above 0: raise them, or use linspace."
        )


def _order_errors(name: str, values: Sequence[float]) -> Iterator[str]:
    """Say where the values of an axis do not increase, for the first such place."""
    for before, after in pairwise(values):
        if after <= before:
            yield (
                f"axes.{name} has {after:g} after {before:g}, but its values must increase: "
                "sort them and name each once."
            )
            return


def _count_errors(grid: Mapping[str, tuple], given: Mapping) -> Iterator[str]:
    """Say that a campaign above `MOST_POINTS` does not say that it is meant."""
    size = math.prod(map(len, grid.values()))
    if size > MOST_POINTS and not given.get("allow_large", False):
        yield (
            f"its axes make {size:,} points, above {MOST_POINTS:,}: shorten an axis, or write "
            "allow_large: true."
        )


def _form_errors(given) -> Iterator[str]:
    """Say that a kind has no law, or an axis none to vary; or that a scene is missing or idle."""
    if KINDS[given["kind"]].of_scene != ("scene" in given):
        advice = "leave it out" if "scene" in given else "give the scene whose numbers vary"
        yield (
            f"scene is {'given' if 'scene' in given else 'missing'}, but of all kinds motion alone "
            f"has one, and kind is {given['kind']}: {advice}."
        )
        return
    if "law" in given:
        if KINDS[given["kind"]].beside_law is None:
            yield f"law is given, but kind {given['kind']} has no law: leave it out."
        return
    for axis in given["axes"]:
        if axis.startswith(PREFIX):
            yield (
                f"axes.{axis} varies a number of the law, but law is missing: give it with its "
                "elastic potential."
            )


def _choice_errors(given) -> Iterator[str]:
    """Say which parameters are given twice over or not at all."""
    for group in KINDS[given["kind"]].one_of:
        found = [name for name in group if name in given["axes"] or name in given.get("fixed", {})]
        if len(found) != 1:
            yield (
                f"kind {given['kind']} needs exactly one of {', '.join(group)}, and "
                f"{' and '.join(found) or 'none'} {'are' if len(found) > 1 else 'is'} given: "
                f"{'keep one' if found else 'give one under axes or under fixed'}."
            )


def _start_errors(given) -> Iterator[str]:
    """Say that a start is missing, not a wave, or not what its profile says."""
    starts, start = KINDS[given["kind"]].starts, given.get("start")
    if start and not starts:
        yield f"start is given, but kind {given['kind']} has only one: leave it out."
    if starts and not start:
        yield (
            f"start is missing: kind {given['kind']} starts from profile "
            f"{', '.join(starts[:-1])} or {starts[-1]}."
        )
    if start and ("rescaled_force" in start) != (start["profile"] == "given"):
        yield (
            f"start has profile {start['profile']}, but rescaled_force belongs only to profile "
            "given: give both or neither."
        )
    if start and "rescaled_force" in start:
        first, *_, last = start["rescaled_force"]
        if min(start["rescaled_force"]) == max(start["rescaled_force"]):
            yield "start.rescaled_force has one value throughout, which is no wave: vary it."
        if first != last:
            yield (
                f"start.rescaled_force begins with {first:g} and ends with {last:g}, but the ring "
                "closes: repeat the first value at the end."
            )


def _size_errors(kind, given) -> Iterator[str]:
    """Say that the points, or the beads of one, do not fit into memory."""
    record, axes = given.get("record", {}), given["axes"]
    kept = len(record.get("scalars", kind.scalars)) + record.get("profile", {}).get("count", 0)
    counts = {f"axes.{axis}": float(_count_values(values)) for axis, values in axes.items()}
    asked = {f"axes.{axis}": values for axis, values in axes.items()}
    held = [Held({axis: asked[axis]}, NUMBERS_PER_VALUE * n) for axis, n in counts.items()]
    held.append(Held(asked, math.prod(counts.values()) * kept))
    if "beads" in given.get("fixed", {}):
        beads = given["fixed"]["beads"]
        held.append(Held({"fixed.beads": beads}, NUMBERS_PER_BEAD * float(beads)))
    if "beads" in axes:
        values = axes["beads"]
        most = next(iter(values.values()))[1] if isinstance(values, Mapping) else values[-1]
        held.append(Held({"axes.beads": values}, NUMBERS_PER_BEAD * float(most)))
    yield from memory_problems(held)


def _name_errors(kind_name, kind, axes, fixed, record) -> Iterator[str]:
    """Say which axes, fixed parameters and scalars the kind does not have, or lacks."""
    for place, names in (("axes", axes), ("fixed", fixed)):
        for name in names:
            if name not in kind.parameters:
                yield (
                    f"{place}.{name} is given, but kind {kind_name} has no parameter {name}: "
                    f"{_advice(name, kind.parameters)}"
                )
    for name in fixed:
        if name in axes:
            yield f"{name} is given under axes and under fixed: leave one out."
    for name, parameter in kind.parameters.items():
        if parameter.default is ... and name not in axes and name not in fixed:
            yield f"{name} is missing: give it under axes or under fixed ({parameter.meaning})."
    for name in record.get("scalars", []):
        if name not in kind.scalars:
            yield (
                f"record.scalars names {name}, which kind {kind_name} does not record: "
                f"{_advice(name, kind.scalars)}"
            )


def _profile_errors(kind, record) -> Iterator[str]:
    """Say that a profile keeps a bead twice."""
    if "profile" not in record:
        return
    start, stop, count = (record["profile"][key] for key in ("start", "stop", "count"))
    beads = math.floor(stop) - math.ceil(start) + 1
    if kind.profile_counts and count > beads:
        yield (
            f"record.profile.count is {count}, but from {start} to {stop} there are {beads} "
            "beads: ask for no more points than beads."
        )


def _value_errors(kind, grid, varied) -> Iterator[str]:
    """Say which values are disordered, out of range or not whole."""
    for name, values in grid.items():
        if values == (None,):
            continue
        place = f"{'axes' if name in varied else 'fixed'}.{name}"
        yield from _order_errors(name, values)
        parameter = kind.parameters[name]
        least = min(values)
        if least < parameter.least or (parameter.above and least == parameter.least):
            limit = f"{'above ' if parameter.above else ''}{parameter.least:g}"
            yield (
                f"{place} reaches down to {least:g}, but {name} ({parameter.meaning}) must be "
                f"{limit}{'' if parameter.above else ' or more'}: raise it."
            )
        if max(values) > parameter.most:
            yield (
                f"{place} reaches up to {max(values):g}, but {name} ({parameter.meaning}) must be "
                f"{parameter.most:g} or less: lower it."
            )
        if parameter.whole and not all(float(value).is_integer() for value in values):
            broken = next(value for value in values if not float(value).is_integer())
            yield f"{place} holds {broken:g}, but {name} counts: give whole numbers."


def _advice(name, known) -> str:
    near = difflib.get_close_matches(str(name), known, n=1)
    return f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}."
