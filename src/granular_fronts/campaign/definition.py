"""Read and check a campaign file, and write its grid out.

First the file is read.  Then every value of its grid is checked, and the law or the scene is made
at all corners.  Each error is a sentence, before any job.
"""

import itertools
import math
import re
from collections.abc import Iterator, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, NamedTuple, get_type_hints

from pydantic import AfterValidator, BeforeValidator, FailFast, Field, create_model
from pydantic_core import PydanticCustomError

from granular_fronts.campaign.file import CampaignFile, Spacing
from granular_fronts.campaign.kinds import KINDS, Kind
from granular_fronts.campaign.numbers import with_numbers
from granular_fronts.errors import InputError, raise_if_any
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.laws import AnyLaw
from granular_fronts.scenes.parts import Part, say
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import read_yaml

NAME = re.compile(r"[a-z][a-z0-9_]{0,99}(?<!_summary)")
"""A campaign's name, which becomes part of file names; x_summary is that of the summary of x."""


class Campaign(NamedTuple):
    """A checked campaign.

    Attributes
    ----------
    name : str
    file : CampaignFile
    given : Mapping
        The contents of the file as they are written, by whose digits points are recognised.
    grid : dict of str to tuple
        Values of every number of a point.  Those that do not vary come first and have one value;
        the last is the fast axis.  For beta, None means β = α.
    axes : dict of str to str
        The numbers that vary, with their meanings.
    """

    name: str
    file: CampaignFile
    given: Mapping[str, Any]
    grid: dict[str, tuple]
    axes: dict[str, str]

    @property
    def kind(self) -> Kind:
        """The kind of problem."""
        return KINDS[self.file.kind]

    @property
    def settings(self) -> dict[str, Any]:
        """What else decides the result of a point."""
        kept = self.file.record.scalars or self.kind.scalars
        return {
            "tolerance": self.file.tolerance,
            "scalars": [name for name in self.kind.scalars if name in kept],
            "profile": self.given.get("record", {}).get("profile"),
        } | {key: self.given[key] for key in ("law", "start", "scene") if self.given.get(key)}

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each number of a point."""
        return tuple(len(values) for values in self.grid.values())

    @property
    def size(self) -> int:
        """Number of points."""
        return math.prod(self.shape)

    def points_per_chunk(self, chunk_seconds: float) -> int:
        """Return the most points of a job that should take so much processor time."""
        usual = max(1, round(chunk_seconds / self.kind.seconds_per_point))
        return self.file.chunk_points or usual


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


def check_campaign(given: Mapping[str, Any], name: str) -> Campaign:
    """Check the contents of a campaign file and write its grid out.

    An InputError has a sentence for each thing that is wrong.
    """
    label = f"Campaign {name}: "
    file = read_part(CampaignFile, given, label)
    axes = {
        axis: values.values() if isinstance(values, Spacing) else [*given["axes"][axis]]
        for axis, values in file.axes.items()
    }
    fixed, inside = given.get("fixed", {}), file.inside
    read_part(_values_of(file), fixed | axes, label)
    numbers = file.point.model_fields
    choices = {*itertools.chain(*KINDS[file.kind].one_of)}
    constant = {
        number: (fixed.get(number, field.default),)
        for number, field in numbers.items()
        if number in fixed or number not in choices.union(axes)
    }
    grid = constant | {inside.get(axis, axis): (*values,) for axis, values in axes.items()}
    raise_if_any([f"{label}{sentence}" for sentence in _corner_problems(file, grid)])
    meanings = {
        inside.get(axis, axis): axis if axis in inside else str(numbers[axis].description)
        for axis in axes
    }
    return Campaign(name, file, given, grid, meanings)


def _increasing(values: tuple) -> tuple:
    for before, after in pairwise(values):
        if after <= before:
            sentence = (
                f"{{key}} has {say(after)} after {say(before)}, but its values must increase: sort "
                "them and name each once."
            )
            raise PydanticCustomError("sentence", sentence)  # type: ignore[misc]
    return values


def _values_of(file: CampaignFile) -> type[Part]:
    """Return the part of the values of every number; one that does not vary needs no list."""
    as_many = BeforeValidator(lambda v: tuple(v) if isinstance(v, list) else (v,))
    hints = get_type_hints(file.point, include_extras=True) | dict.fromkeys(file.inside, float)
    fields: dict[str, Any] = {}
    for name, hint in hints.items():
        known = file.point.model_fields.get(name)
        default = () if known and not known.is_required() else ...
        meaning = known.description if known else "number of the law or the scene"
        values = Annotated[tuple[hint, ...], FailFast(), as_many, AfterValidator(_increasing)]
        fields[name] = values, Field(default, description=meaning)
    return create_model("Values", __base__=Part, __doc__="Values of a grid.", **fields)


class _Law(Part):
    """The law of a point."""

    law: AnyLaw = Field(description="Law of the contacts.")


def _corner_problems(file: CampaignFile, grid: Mapping[str, tuple]) -> Iterator[str]:
    """Say why the law or the scene cannot be made at some corner of the grid."""
    ends = {name: (grid[name][0], grid[name][-1]) for name in file.inside.values()}
    found: dict[str, None] = {}
    for corner in itertools.product(*ends.values()):
        numbers = dict(zip(ends, corner, strict=True))
        try:
            if file.law:
                read_part(_Law, {"law": with_numbers(file.law.plain(), numbers)})
            if file.scene is not None:
                _check_sensor(Chain.read(with_numbers(file.scene, numbers), "of a point"))
        except InputError as error:
            found |= dict.fromkeys(str(error).splitlines())
    yield from found


def _check_sensor(scene: Chain) -> None:
    sensors = [*scene.record.sensors.values()]
    if len(sensors) != 1 or not sensors[0].contacts:
        raise InputError(
            f"scene.record.sensors has {len(sensors)} entries, but must have one, with contacts, "
            "at which numbers are measured: give one sensor with contacts."
        )
