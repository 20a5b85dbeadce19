"""Validate a whole configuration, as the workflow does at each start.

First its scenes and sections are checked one by one.  Then no two results may have one name.  The
results need a folder that can be written, and no key may be ignored.
"""

import copy
import difflib
import functools
import operator
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import Field

from granular_fronts.errors import InputError
from granular_fronts.scenes.hard_cases import HardCases
from granular_fronts.scenes.honesty import Honesty
from granular_fronts.scenes.law import LAWS
from granular_fronts.scenes.parts import Part
from granular_fronts.scenes.precision import Precision
from granular_fronts.scenes.proofs import Proofs
from granular_fronts.scenes.schema import load_schema, violations
from granular_fronts.scenes.sections import Check, section_errors
from granular_fronts.scenes.sentences import LONGEST_SHOWN, read_part
from granular_fronts.scenes.study import studies
from granular_fronts.scenes.validation import SCENES, check_scene, raise_if_any


class OnDemand(Part):
    """Sections of what is made only if its target is named."""

    precision: Precision
    honesty: Honesty
    hard_cases: HardCases = Field(description="Problems at the edge of what the solvers can do.")
    proofs: Proofs


SECTIONS: dict[str, tuple[Check, ...]] = {
    **{study["section"]: () for study in studies().values()},
    **{f"laws.{name}": section for name, section in LAWS.items()},
}
"""Checks of the sections of studies by their path in the configuration."""


def whole_schema() -> dict[str, Any]:
    """Return the JSON schema of a configuration with its parts, for editors and the manual."""
    schema = copy.deepcopy(load_schema("config"))
    families = schema["properties"]["scenes"]["properties"]
    for family, part in SCENES.items():
        rules = part.model_json_schema()
        rules["description"] = rules["description"].partition("\n\n")[0]
        schema["$defs"] |= rules.pop("$defs") | {part.__name__: rules}
        families[family]["additionalProperties"] = {"$ref": f"#/$defs/{part.__name__}"}
    sections = OnDemand.model_json_schema()
    schema["$defs"] |= sections["$defs"]
    for name, rules in sections["properties"].items():
        schema["properties"][name] = rules | schema["properties"][name]
    return schema


UNUSABLE = *"{}<>*?|\"'\n\t\\$", "://"
"""Parts of a folder's name that Snakemake, a shell or a reader takes for something else."""


def validate_configuration(
    configuration: Mapping,
    arguments: Mapping | None = None,
    writes: bool = True,
) -> None:
    """Validate a merged configuration, and what the command line gave (``--config``).

    `writes` says whether results will be written.  An InputError has one sentence for each thing
    that is wrong.
    """
    raise_if_any([*_argument_errors(arguments or {})])
    check_configuration(configuration)
    raise_if_any([*folder_errors(configuration["results"], writes)])


def check_configuration(configuration: Mapping) -> None:
    """Validate the contents of a merged configuration; as `validate_configuration` otherwise."""
    raise_if_any(
        [*violations(configuration), *_scene_errors(configuration), *_part_errors(configuration)]
        or [*_section_errors(configuration)]
    )


def _argument_errors(arguments: Mapping) -> Iterator[str]:
    """Find mappings and lists after ``--config``, whose values all arrive as text."""
    for key, value in arguments.items():
        if isinstance(value, Mapping | list):
            yield (
                f"--config {key}=… holds a mapping or a list, whose numbers arrive as text: write "
                f"it into a file, say mine.yaml, and give --configfile mine.yaml."
            )


def folder_errors(results: str, writes: bool = True) -> Iterator[str]:
    """Find out whether a folder, relative to the working one, can receive results."""
    found = "".join(part for part in UNUSABLE if part in results)
    if results.startswith("~"):
        yield (
            f"results is {results}, where ~ would be a folder of that name: write "
            f"{os.path.expanduser(results)}."
        )
    elif found or results != results.strip():
        yield (
            f"results is {results!r}, and no folder of results may have {found!r} or blanks around "
            "its name: use letters, digits, underscores and slashes."
        )
    else:
        paths = [Path(results), *Path(results).absolute().parents]
        try:
            existing = next(path for path in paths if path.exists())
        except OSError as error:
            begin = results[:LONGEST_SHOWN]
            yield f"results is {begin} …, no folder ({error.strerror}): shorten it."
            return
        if not existing.is_dir():
            yield f"results is {results}, but {existing} is a file: name a folder."
        elif writes and not os.access(existing, os.W_OK | os.X_OK):
            yield (
                f"results is {results}, but nothing can be written into {existing}: name a folder "
                "of your own."
            )


def _scene_errors(configuration: Mapping) -> Iterator[str]:
    """Say what is wrong with scenes whose families the schema knows."""
    families = configuration.get("scenes") if isinstance(configuration, Mapping) else None
    for family in SCENES:
        scenes: Any = families.get(family) if isinstance(families, Mapping) else None
        for name, scene in scenes.items() if isinstance(scenes, Mapping) else ():
            try:
                check_scene(family, scene, name)
            except InputError as error:
                misspelt = _misspelt_name(family, name, scenes)
                yield from [misspelt] if misspelt else str(error).splitlines()


def _misspelt_name(family: str, name: str, scenes: Mapping) -> str | None:
    """Say that a scene without most of its keys may belong to another one with such a name."""
    fields = SCENES[family].model_fields
    required = [key for key, field in fields.items() if field.is_required()]
    missing = {
        str(other): [key for key in required if key not in scene]
        for other, scene in scenes.items()
        if isinstance(scene, Mapping)
    }
    lacks = missing.pop(str(name), [])
    whole = [other for other, keys in missing.items() if not keys]
    near = difflib.get_close_matches(str(name), whole, n=1)
    if not near or 2 * len(lacks) < len(required):
        return None
    return f"Scene {name} lacks {', '.join(lacks)}: did you mean {near[0]}?"


def _part_errors(configuration: Mapping) -> Iterator[str]:
    """Say what is wrong with sections that are parts; the schema names those that are missing."""
    names = OnDemand.model_fields.keys()
    if isinstance(configuration, Mapping) and names <= configuration.keys():
        try:
            read_part(OnDemand, {name: configuration[name] for name in names})
        except InputError as error:
            yield from str(error).splitlines()


def _section_errors(configuration: Mapping) -> Iterator[str]:
    """Say what is wrong with the sections of a configuration that obeys the schema."""
    for path, checks in SECTIONS.items():
        given: object = functools.reduce(operator.getitem, path.split("."), configuration)
        if isinstance(given, Mapping):
            yield from (f"{path}.{error}" for error in section_errors(given, checks))
    yield from _name_errors(configuration)


def _name_errors(configuration: Mapping) -> Iterator[str]:
    """Find scenes that share a name with another or with a dataset, and entries of no scene."""
    owners = {name: f"the study {name}" for name in studies()}
    for family, scenes in configuration["scenes"].items():
        for name in scenes:
            if name in owners:
                yield (
                    f"scenes.{family}.{name} has the name of {owners[name]}, but a name belongs to "
                    "one result only: rename a scene."
                )
            owners.setdefault(name, f"scenes.{family}.{name}")
    rings = configuration["scenes"]["periodic"]
    for name in configuration["precision"]["log_burgers"]:
        if name not in rings:
            yield (
                f"precision.log_burgers.{name} names no periodic scene: choose one of "
                f"{', '.join(rings)}."
            )
