"""Run one step of the workflow, started by Snakemake or by hand.

A script holds one function with named, typed arguments and ends with ::

    if __name__ == "__main__":
        run_step(function, globals().get("snakemake"))

Under Snakemake the rule's named input, output and params become the arguments. By hand, ``python
workflow/scripts/<script>.py --help`` lists them: the command line is made from the same function.
"""

import argparse
import logging
import re
import sys
from collections.abc import Callable
from inspect import signature
from pathlib import Path
from typing import Any

import yaml

LOGGER = logging.getLogger("granular_fronts")


def run_step(function: Callable[..., None], snakemake: Any = None) -> None:
    """Call a step function with the workflow's or the command line's values.

    Parameters
    ----------
    function : callable
        The step. A ValueError it raises ends the run with its sentence alone; the log file of
        the rule also keeps where it came from.
    snakemake : object, optional
        The object Snakemake puts into a script; none on the command line.
    """
    arguments = from_workflow(function, snakemake) if snakemake else from_command_line(function)
    start_log(next(iter(snakemake.log), None) if snakemake else None)
    try:
        function(**arguments)
    except ValueError as error:
        LOGGER.error("%s", error)
        LOGGER.debug("The sentence above was raised here:", exc_info=True)
        sys.exit(1)
    except Exception:
        LOGGER.exception("The step failed unexpectedly.")
        sys.exit(1)


def from_workflow(function: Callable[..., None], snakemake: Any) -> dict[str, Any]:
    """Pick the arguments of a step from a rule's named input, output and params.

    Parameters
    ----------
    function : callable
        The step.
    snakemake : object
        The object Snakemake puts into a script.

    Returns
    -------
    dict
        A value for each parameter that the rule names; what else the rule lists is there to
        order and to repeat jobs.
    """
    given = {}
    for group in (snakemake.params, snakemake.input, snakemake.output):
        given.update(group.items())
    return {
        name: convert(given[name], parameter.annotation)
        for name, parameter in signature(function, eval_str=True).parameters.items()
        if name in given
    }


def convert(value: Any, annotation: Any) -> Any:
    """Give the workflow's file names, which are text, the type the step asks for.

    Parameters
    ----------
    value : object
        What the rule names.
    annotation : type
        What the step function asks for.

    Returns
    -------
    object
        A path or a list of paths where these are asked for, otherwise `value`.
    """
    if annotation is Path:
        return Path(value)
    if annotation == list[Path]:
        return [Path(file) for file in value]
    return value


def from_command_line(function: Callable[..., None]) -> dict[str, Any]:
    """Read the arguments of a step from the command line.

    Parameters
    ----------
    function : callable
        The step; its signature and docstring make the command line and its help.

    Returns
    -------
    dict
        A value for each parameter.
    """
    # Only the command line needs it, and a job should start fast.
    import jsonargparse

    class HelpFormatter(jsonargparse.DefaultHelpFormatter, argparse.RawDescriptionHelpFormatter):
        """Leave the lines of a script's docstring as they are, for the command it shows."""

    jsonargparse.set_loader("yaml_or_leaf", load_yaml_or_leaf, (yaml.YAMLError,))
    parser = jsonargparse.ArgumentParser(
        parser_mode="yaml_or_leaf",
        formatter_class=HelpFormatter,
        description=sys.modules[function.__module__].__doc__,
        epilog="A mapping is given as YAML text, or as file.yaml:dotted.key to take it from there.",
    )
    parser.add_function_arguments(function, as_group=False)
    return parser.parse_args().as_dict()


def load_yaml_or_leaf(text: str) -> Any:
    """Read YAML text, or the leaf of a YAML file named as ``file.yaml:dotted.key``.

    Parameters
    ----------
    text : str
        For example ``{alpha: 1.5}`` or
        ``config/default.yaml:scenes.chain.initiation_underdamped``.

    Returns
    -------
    object
        The value.

    Raises
    ------
    argparse.ArgumentError
        When there is no such file or no such key in it.
    """
    named = re.fullmatch(r"(?P<file>[^\s{}\[\]]+\.ya?ml):(?P<key>[\w.]+)", text)
    if not named:
        return yaml.safe_load(text)
    file = Path(named["file"])
    if not file.is_file():
        raise argparse.ArgumentError(None, f"There is no file {file}: name one that exists.")
    value = yaml.safe_load(file.read_text(encoding="utf-8"))
    for key in named["key"].split("."):
        if key not in value:
            raise argparse.ArgumentError(
                None, f"{text} stops at {key}: choose one of {', '.join(value)}."
            )
        value = value[key]
    return value


def start_log(file: str | None) -> None:
    """Send the project's messages to the terminal and to the log file of the rule.

    Parameters
    ----------
    file : str or None
        The log file; none on the command line.
    """
    LOGGER.setLevel(logging.DEBUG)
    terminal = logging.StreamHandler()
    terminal.setLevel(logging.WARNING if file else logging.INFO)
    LOGGER.addHandler(terminal)
    if file:
        LOGGER.addHandler(logging.FileHandler(file, mode="w", encoding="utf-8"))
