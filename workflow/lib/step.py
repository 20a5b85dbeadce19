"""Run one step of the workflow, started by Snakemake or by hand.

A script holds one function with named, typed arguments and ends with ::

    if __name__ == "__main__":
        run_step(function, globals().get("snakemake"))

Under Snakemake the rule's named input, output and params become the arguments. By hand, ``python
workflow/scripts/<script>.py --help`` lists them: the command line is made from the same function.

The log file of a rule begins with the step and its arguments. It holds all that the step and its
libraries print.  If the step fails it holds the traceback, and its last line is the sentence that
the terminal shows.
"""

import argparse
import gc
import os
import re
import sys
import traceback
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from datetime import datetime
from inspect import signature
from pathlib import Path
from textwrap import shorten
from typing import Any, BinaryIO, TextIO

from granular_fronts.errors import InputError, NoSpaceError, end_with_reader
from granular_fronts.output.files import is_full
from granular_fronts.scenes.yaml_files import parse_yaml, read_yaml

EXIT_INTERRUPTED = 130  # What a program ends with that Ctrl-C has stopped.
LONGEST_ARGUMENT = 80  # Characters that the log file shows of an argument.


def run_step(
    function: Callable[..., None],
    snakemake: Any = None,
    inputs: Mapping[str, Any] | None = None,
    **given: Any,
) -> None:
    """Call a step function with the workflow's or the command line's values.

    Parameters
    ----------
    function : callable
        The step. A ValueError or a full disk ends the run with a sentence only. The log file of the
        rule also keeps the traceback.
    snakemake : object, optional
        The object Snakemake puts into a script; none on the command line.
    inputs : mapping, optional
        Types of further arguments that the step does not name, by their names.
    **given
        Arguments of the step that neither a rule nor the command line gives.
    """
    if snakemake:
        arguments = from_workflow({**argument_types(function), **(inputs or {})}, snakemake)
    else:
        arguments = from_command_line(function, inputs or {}, given)
    file = next(iter(snakemake.log), None) if snakemake else None
    with _copied_output(file) as write_to_log:
        write_to_log(_describe_call(function, arguments))
        try:
            function(**given, **arguments)
        except KeyboardInterrupt:
            write_to_log(traceback.format_exc())
            print("Interrupted: run the same command again to go on.", file=sys.stderr)
            sys.exit(EXIT_INTERRUPTED)
        except (ValueError, OSError) as error:
            write_to_log(traceback.format_exc())
            print(describe_fault(error), file=sys.stderr)
            sys.exit(1)
        except Exception as error:
            mappings = [name for name, value in arguments.items() if isinstance(value, dict)]
            if mappings and not snakemake and isinstance(error, KeyError | TypeError):
                sys.exit(
                    f"{' or '.join(mappings)} is not what {function.__name__} takes ({error}): "
                    "take it from a file, for example config/default.yaml:dotted.key."
                )
            traceback.print_exc()
            print(_describe_unexpected(error), file=sys.stderr)
            sys.exit(1)
    # Python looks for garbage when it ends, without this among all that was imported.
    gc.freeze()


def _describe_call(function: Callable[..., None], arguments: dict[str, Any]) -> str:
    """Return the first line of a log file: when which step started, and with which arguments."""
    given = (
        f"{name}={shorten(str(value), LONGEST_ARGUMENT, placeholder=' …')}"
        for name, value in arguments.items()
    )
    return f"{datetime.now():%Y-%m-%d %H:%M:%S} {function.__name__}: {', '.join(given)}\n"


def _describe_unexpected(error: Exception) -> str:
    """Return the sentence for an error that no sentence was written for."""
    reason = " ".join(str(error).split())
    return f"The step failed unexpectedly, {type(error).__name__}: {reason}"


def describe_fault(error: ValueError | OSError) -> str:
    """Return the sentence for a wrong value, or for a file that cannot be read or written."""
    if isinstance(error, ValueError | NoSpaceError):
        return str(error)
    if is_full(error):
        return str(NoSpaceError(Path(error.filename or "file").absolute().parent))
    if error.filename is None:
        return _describe_unexpected(error)
    return f"{error.filename} cannot be read or written ({error.strerror}): name another."


def argument_types(function: Callable[..., Any]) -> dict[str, Any]:
    """Return the types of the arguments that a function names."""
    parameters = signature(function, eval_str=True).parameters.values()
    return {one.name: one.annotation for one in parameters if one.kind is not one.VAR_KEYWORD}


def from_workflow(types: Mapping[str, Any], snakemake: Any) -> dict[str, Any]:
    """Pick the arguments of a step from a rule's named input, output and params.

    What else the rule lists is there to order and to repeat jobs.
    """
    given = {}
    for group in (snakemake.params, snakemake.input, snakemake.output):
        given.update(group.items())
    # The workflow's file names are text.
    convert: dict[Any, Callable[[Any], Any]] = {
        Path: Path,
        list[Path]: lambda files: [Path(file) for file in files],
    }
    return {
        name: convert.get(kind, lambda value: value)(given[name])
        for name, kind in types.items()
        if name in given
    }


def from_command_line(
    function: Callable[..., None], inputs: Mapping[str, Any], given: Collection[str] = ()
) -> dict[str, Any]:
    """Read the arguments of a step; its signature and docstring make the command line.

    The `inputs` are the types of further arguments by their names; those `given` are left out.
    """
    # Only the command line needs it, and a job should start fast.
    import jsonargparse

    class HelpFormatter(jsonargparse.DefaultHelpFormatter, argparse.RawDescriptionHelpFormatter):
        """Leave the lines of a script's docstring as they are, for the command it shows."""

    end_with_reader()
    jsonargparse.set_loader("yaml_or_leaf", load_yaml_or_leaf, (InputError,))
    parser = jsonargparse.ArgumentParser(
        parser_mode="yaml_or_leaf",
        formatter_class=HelpFormatter,
        description=sys.modules["__main__"].__doc__,
        epilog="A mapping is given as YAML text, or as file.yaml:dotted.key to take it from there.",
    )
    for name, kind in inputs.items():
        parser.add_argument(f"--{name}", type=kind, required=True)
    parser.add_function_arguments(function, as_group=False, skip=set(given))
    return parser.parse_args().as_dict()


def load_yaml_or_leaf(text: str) -> Any:
    """Read YAML text, for example ``{alpha: 1.5}``, or the leaf ``file.yaml:dotted.key`` of a file.

    Raises `argparse.ArgumentError` when there is no such file or no such key in it.
    """
    named = re.fullmatch(r"(?P<file>[^\s{}\[\]]+\.ya?ml):(?P<key>[\w.]+)", text)
    if not named:
        return parse_yaml(text, "the argument")
    file = Path(named["file"])
    if not file.is_file():
        raise argparse.ArgumentError(None, f"There is no file {file}: name one that exists.")
    try:
        value = read_yaml(file)
    except InputError as error:
        raise argparse.ArgumentError(None, str(error)) from None
    for key in named["key"].split("."):
        if not isinstance(value, dict) or key not in value:
            choices = f": choose one of {', '.join(value)}" if isinstance(value, dict) else ""
            raise argparse.ArgumentError(None, f"{text} stops at {key}{choices}.")
        value = value[key]
    return value


@contextmanager
def _copied_output(file: str | None) -> Iterator[Callable[[str], None]]:
    """Copy what the block prints into a log file, and give a function that writes only there."""
    # What libraries print past Python, to the descriptors 1 and 2, goes only into the log file.
    if file is None:
        yield lambda text: None
        return
    terminals = os.dup(1), os.dup(2)
    with (
        _open_log(file) as log,
        open(terminals[0], "w", encoding="utf-8", buffering=1) as output,
        open(terminals[1], "w", encoding="utf-8", buffering=1) as errors,
        redirect_stdout(_CopyingStream(output, log)),
        redirect_stderr(_CopyingStream(errors, log)),
    ):
        for descriptor in (1, 2):
            os.dup2(log.fileno(), descriptor)
        try:
            yield lambda text: _write(log, text)
        finally:
            for descriptor, terminal in enumerate(terminals, start=1):
                os.dup2(terminal, descriptor)


def _open_log(file: str) -> BinaryIO:
    """Open a log file, or nothing where there is no space for one."""
    try:
        return open(file, "wb", buffering=0)
    except OSError:
        return open(os.devnull, "wb", buffering=0)


def _write(log: BinaryIO, text: str) -> None:
    with suppress(OSError):
        log.write(text.encode())


class _CopyingStream:
    """A stream to the terminal that is copied into a log file, progress bars left out."""

    def __init__(self, terminal: TextIO, log: BinaryIO):
        self._terminal, self._log = terminal, log

    def __getattr__(self, name: str) -> Any:
        return getattr(self._terminal, name)

    def write(self, text: str) -> int:
        if "\r" not in text:
            _write(self._log, text)
        return self._terminal.write(text)
