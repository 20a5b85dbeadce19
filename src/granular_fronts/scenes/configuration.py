"""Validate a whole configuration, as the workflow does at each start."""

import difflib
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, get_args

from pydantic import Field

from granular_fronts.errors import InputError, raise_if_any
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.front import Front
from granular_fronts.scenes.orbit import Orbits
from granular_fronts.scenes.parts import Listed, Named, Part, Positive
from granular_fronts.scenes.ring import Ring
from granular_fronts.scenes.sentences import LONGEST_SHOWN, Scene, read_part
from granular_fronts.scenes.studies import ExactFronts, Exponent, Laws


class Scenes(Part):
    """What is simulated; one mapping for each family of problems."""

    chain: Named[Chain] = Field(
        description="Motions of a finite chain of beads, section 3.3; the key of a scene names its "
        "data file."
    )
    heteroclinic: Named[Orbits] = Field(
        description="Stationary fronts of the logarithmic KdV–Burgers equation, section 5.2; the "
        "key of a scene names its data file."
    )
    periodic: Named[Ring] = Field(
        description="Localised waves on a ring of beads, compared with the amplitude equations of "
        "section 4; the key of a scene names its data file."
    )
    front: Named[Front] = Field(
        description="Exact travelling fronts of the lattice and what approximates them, section 6; "
        "the key of a scene names its data file."
    )


SCENES: dict[str, type[Scene]] = {
    family: get_args(field.annotation)[1] for family, field in Scenes.model_fields.items()
}
"""What a scene is, by its family."""


class Configuration(Part):
    """What the workflow computes; mass and stiffness are 1 (section 3.1) unless a unit is named."""

    results: str = Field(
        min_length=1,
        description="Folder that receives every file the workflow makes, relative to the project.",
    )
    campaign: str | None = Field(
        None,
        min_length=1,
        description="Name of a file in config/campaigns, for the target campaign.",
    )
    chunk_seconds: Positive = Field(
        description="Processor time in seconds (SI) that one job of a campaign should take, long "
        "against the start of a job."
    )
    front_exponents: Listed[Exponent] = Field(
        max_length=2, description="Exponents α whose fluxes and fronts (46) are drawn in figure 4."
    )
    scenes: Scenes
    exact_fronts: ExactFronts
    laws: Laws
    projects: dict[str, dict[str, Any]] = Field(
        {}, description="Settings of projects by their names, laid over the config.yaml of each."
    )

    def problems(self) -> Iterator[str]:
        """No two results have one name."""
        studies = "log_burgers_fronts", *ExactFronts.model_fields, *Laws.model_fields
        owners = {name: f"the study {name}" for name in studies}
        for family, scenes in self.scenes:
            for name in scenes:
                if name in owners:
                    yield (
                        f"scenes.{family}.{name} has the name of {owners[name]}, but a name "
                        "belongs to one result only: rename a scene."
                    )
                owners.setdefault(name, f"scenes.{family}.{name}")


UNUSABLE = *"{}<>*?|\"'\n\t\\$", "://"
"""Parts of a folder's name that Snakemake, a shell or a reader takes for something else."""

IN_SCENE = re.compile(r"^scenes\.\w+\.(\w+)\.", re.MULTILINE)
"""Beginning of a sentence on something inside a scene."""


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


def check_configuration(configuration: object) -> None:
    """Validate the contents of a merged configuration; as `validate_configuration` otherwise."""
    raise_if_any([*_misspelt_scenes(configuration)])
    try:
        read_part(Configuration, configuration)
    except InputError as error:
        raise InputError(IN_SCENE.sub(r"Scene \1: ", str(error))) from None


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


def _misspelt_scenes(configuration: Any) -> Iterator[str]:
    """Say that a scene without most of its keys may belong to another one with such a name."""
    for family, kind in SCENES.items():
        try:
            scenes = configuration["scenes"][family].items()
        except (TypeError, KeyError, AttributeError):
            continue  # There are no scenes, which the reading says.
        required = [key for key, field in kind.model_fields.items() if field.is_required()]
        lacking = {
            str(name): [key for key in required if key not in scene]
            for name, scene in scenes
            if isinstance(scene, Mapping)
        }
        whole = [name for name, lacks in lacking.items() if not lacks]
        for name, lacks in lacking.items():
            near = difflib.get_close_matches(name, whole, n=1)
            if near and 2 * len(lacks) >= len(required):
                yield f"Scene {name} lacks {', '.join(lacks)}: did you mean {near[0]}?"
