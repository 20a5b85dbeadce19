"""Validate a whole configuration, as the workflow does at each start.

Beside its scenes and sections one by one (`granular_fronts.scenes.validation`), a configuration
must not give two results one name, must record what the figures draw, must name a folder that can
receive the results, and must be written so that no key is ignored.
"""

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from granular_fronts.scenes.constraints import CONSTRAINTS
from granular_fronts.scenes.dataset_names import name_errors
from granular_fronts.scenes.figure_needs import need_errors
from granular_fronts.scenes.schema import LONGEST_SHOWN, violations
from granular_fronts.scenes.validation import raise_if_any, section_errors, section_label
from granular_fronts.scenes.yaml_files import yaml_errors

UNUSABLE = *"{}<>*?|\"'\n\t\\$", "://"
"""Parts of a folder's name that Snakemake, a shell or a reader takes for something else."""


def validate_configuration(
    configuration: Mapping,
    files: Sequence[Path | str] = (),
    arguments: Mapping | None = None,
    writes: bool = True,
) -> None:
    """Validate a configuration and the way in which it was given.

    Parameters
    ----------
    configuration : Mapping
        The merged configuration.
    files : sequence of Path or str, optional
        The files it was merged from.
    arguments : Mapping, optional
        What the command line gave after ``--config``.
    writes : bool, optional
        Whether results will be written.

    Raises
    ------
    InputError
        With one sentence for each thing that is wrong.
    """
    raise_if_any([*yaml_errors(files), *argument_errors(arguments or {})])
    check_configuration(configuration)
    raise_if_any([*folder_errors(configuration["results"], writes)])


def check_configuration(configuration: Mapping) -> None:
    """Validate the contents of a configuration.

    Parameters
    ----------
    configuration : Mapping
        The merged configuration.

    Raises
    ------
    InputError
        With one sentence for each thing that is wrong.
    """
    raise_if_any(
        [*violations(configuration)]
        or [
            *(error for path in CONSTRAINTS for error in _errors_at(path, configuration)),
            *name_errors(configuration),
            *need_errors(configuration),
        ]
    )


def argument_errors(arguments: Mapping) -> Iterator[str]:
    """Find mappings and lists after ``--config``, whose values all arrive as text.

    Parameters
    ----------
    arguments : Mapping
        What Snakemake read after ``--config``.

    Yields
    ------
    str
        A sentence for each.
    """
    for key, value in arguments.items():
        if isinstance(value, Mapping | list):
            yield (
                f"--config {key}=… holds a mapping or a list, whose numbers arrive as text: write "
                f"it into a file, for example mine.yaml, and give --configfile mine.yaml."
            )


def folder_errors(results: str, writes: bool = True) -> Iterator[str]:
    """Find out whether a folder can receive results; nothing is written.

    Parameters
    ----------
    results : str
        The folder, relative to the working directory.
    writes : bool, optional
        Whether anything will be written there.

    Yields
    ------
    str
        One sentence if it cannot.
    """
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


def _errors_at(path: str, configuration: Mapping) -> Iterator[str]:
    """Say what is wrong with the sections at a path of `CONSTRAINTS`."""
    *parents, last = path.split(".")
    node = configuration
    for parent in parents:
        node = node[parent]
    for name, section in node.items() if last == "*" else [(last, node[last])]:
        label = section_label(".".join([*parents, name]))
        yield from (label + error for error in section_errors(path, section))
