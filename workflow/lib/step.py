"""Run one step of the workflow, started by Snakemake or by hand.

A script holds one function with named, typed arguments and ends with ::

    if __name__ == "__main__":
        run_step(function, globals().get("snakemake"))

Under Snakemake the rule's named input, output and params become the arguments. By hand, ``python
workflow/scripts/<script>.py --help`` lists them: the command line is made from the same function.

The log file of a rule begins with the step and its arguments. It holds all that the step and its
libraries print, and where a step fails its traceback; the last line is then the sentence that the
terminal shows.
"""

import argparse
import fcntl
import gc
import logging
import os
import re
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, redirect_stderr, redirect_stdout, suppress
from datetime import datetime
from inspect import signature
from pathlib import Path
from textwrap import shorten
from typing import Any, TextIO

from granular_fronts.errors import InputError, NoSpaceError, end_with_reader
from granular_fronts.output.files import is_full
from granular_fronts.scenes.yaml_files import parse_yaml, read_yaml

LOGGER = logging.getLogger("granular_fronts")

EXIT_INTERRUPTED = 130  # What a program ends with that Ctrl-C has stopped.
RUN_LOCK = "GRANULAR_FRONTS_RUN_LOCK"  # Names the file that the run holds locked, see common.smk.
SECONDS_BETWEEN_LOOKS = 0.5
LONGEST_ARGUMENT = 80  # Characters that the log file shows of an argument.


def run_step(function: Callable[..., None], snakemake: Any = None) -> None:
    """Call a step function with the workflow's or the command line's values.

    Parameters
    ----------
    function : callable
        The step. A ValueError it raises, or a full disk, ends the run with its sentence alone; the
        log file of the rule also keeps where it came from.
    snakemake : object, optional
        The object Snakemake puts into a script; none on the command line.
    """
    if lock := os.environ.get(RUN_LOCK):
        threading.Thread(target=_end_with_run, args=[Path(lock)], daemon=True).start()
    arguments = from_workflow(function, snakemake) if snakemake else from_command_line(function)
    file = next(iter(snakemake.log), None) if snakemake else None
    with _copied_output(file) as write_to_log, _messages_on_terminal():
        write_to_log(_describe_call(function, arguments))
        try:
            function(**arguments)
        except KeyboardInterrupt:
            write_to_log(traceback.format_exc())
            LOGGER.error("Interrupted: run the same command again to go on.")
            sys.exit(EXIT_INTERRUPTED)
        except (ValueError, OSError) as error:
            write_to_log(traceback.format_exc())
            LOGGER.error("%s", describe_fault(error))
            sys.exit(1)
        except Exception as error:
            mappings = [name for name, value in arguments.items() if isinstance(value, dict)]
            if mappings and not snakemake and isinstance(error, KeyError | TypeError):
                sys.exit(
                    f"{' or '.join(mappings)} is not what {function.__name__} takes ({error}): "
                    "take it from a file, for example config/default.yaml:dotted.key."
                )
            traceback.print_exc()
            LOGGER.error("%s", _describe_unexpected(error))
            sys.exit(1)
    # Python looks for garbage when it ends, without this among all that was imported.
    gc.freeze()


def _end_with_run(lock: Path) -> None:
    """End this process when the run that started it has ended, however it did.

    A job that outlives a killed run could write over what a later run has made for another
    configuration.
    """
    while is_held(lock):
        time.sleep(SECONDS_BETWEEN_LOOKS)
    os._exit(1)


def is_held(lock: Path) -> bool:
    """Whether some process holds a file locked; so it seems where the file is gone."""
    try:
        with lock.open(encoding="utf-8") as file:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except (FileNotFoundError, BlockingIOError):
        return True
    return False


def _describe_call(function: Callable[..., None], arguments: dict[str, Any]) -> str:
    """The first line of a log file: when which step started, and with which arguments."""
    given = (
        f"{name}={shorten(str(value), LONGEST_ARGUMENT, placeholder=' …')}"
        for name, value in arguments.items()
    )
    return f"{datetime.now():%Y-%m-%d %H:%M:%S} {function.__name__}: {', '.join(given)}\n"


def _describe_unexpected(error: Exception) -> str:
    """The sentence for an error that no sentence was written for."""
    reason = " ".join(str(error).split())
    return f"The step failed unexpectedly, {type(error).__name__}: {reason}"


def describe_fault(error: ValueError | OSError) -> str:
    """The sentence for what was given, or for a file that cannot be read or written."""
    if isinstance(error, ValueError | NoSpaceError):
        return str(error)
    if is_full(error):
        return str(NoSpaceError(Path(error.filename or "file").absolute().parent))
    if error.filename is None:
        return _describe_unexpected(error)
    return f"{error.filename} cannot be read or written ({error.strerror}): name another."


def from_workflow(function: Callable[..., None], snakemake: Any) -> dict[str, Any]:
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
        name: convert.get(parameter.annotation, lambda value: value)(given[name])
        for name, parameter in signature(function, eval_str=True).parameters.items()
        if name in given
    }


def from_command_line(function: Callable[..., None]) -> dict[str, Any]:
    """Read the arguments of a step; its signature and docstring make the command line."""
    # Only the command line needs it, and a job should start fast.
    import jsonargparse

    class HelpFormatter(jsonargparse.DefaultHelpFormatter, argparse.RawDescriptionHelpFormatter):
        """Leave the lines of a script's docstring as they are, for the command it shows."""

    end_with_reader()
    jsonargparse.set_loader("yaml_or_leaf", load_yaml_or_leaf, (InputError,))
    parser = jsonargparse.ArgumentParser(
        parser_mode="yaml_or_leaf",
        formatter_class=HelpFormatter,
        description=sys.modules[function.__module__].__doc__,
        epilog="A mapping is given as YAML text, or as file.yaml:dotted.key to take it from there.",
    )
    parser.add_function_arguments(function, as_group=False)
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
def _messages_on_terminal() -> Iterator[None]:
    """Show the project's warnings and errors while the block runs."""
    terminal = logging.StreamHandler()
    LOGGER.addHandler(terminal)
    try:
        yield
    finally:
        LOGGER.removeHandler(terminal)


@contextmanager
def _copied_output(file: str | None) -> Iterator[Callable[[str], None]]:
    """Copy what the block prints into a log file, and give what writes to that file alone.

    What libraries print past Python, to the descriptors 1 and 2, goes into the log file alone.
    """
    if file is None:
        yield lambda text: None
        return
    with ExitStack() as stack:
        log = stack.enter_context(_open_log(file))

        def write_to_log(text: str) -> None:
            with suppress(OSError):
                log.write(text.encode())

        terminals = [os.dup(descriptor) for descriptor in (1, 2)]
        for descriptor, terminal in enumerate(terminals, start=1):
            os.dup2(log.fileno(), descriptor)
            stack.callback(os.close, terminal)
            stack.callback(os.dup2, terminal, descriptor)
        for terminal, redirect in zip(terminals, (redirect_stdout, redirect_stderr), strict=True):
            shown = stack.enter_context(
                open(terminal, "w", encoding="utf-8", buffering=1, closefd=False)
            )
            copying = CopyingStream(shown, write_to_log)
            stack.callback(copying.end_line)
            stack.enter_context(redirect(copying))
        yield write_to_log


def _open_log(file: str) -> Any:
    """Open a log file, or nothing where there is no space for one."""
    try:
        return open(file, "wb", buffering=0)
    except OSError:
        return open(os.devnull, "wb", buffering=0)


class CopyingStream:
    """A stream to the terminal whose lines are copied, of a progress bar its last state."""

    def __init__(self, terminal: TextIO, copy: Callable[[str], None]):
        self._terminal, self._copy, self._line = terminal, copy, ""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._terminal, name)

    def write(self, text: str) -> int:
        """Write to the terminal, and copy the lines that end here."""
        *lines, self._line = (self._line + text).split("\n")
        for line in lines:
            self._copy(line.rpartition("\r")[2] + "\n")
        return self._terminal.write(text)

    def end_line(self) -> None:
        """Copy the line that has not ended."""
        if self._line:
            self._copy(self._line.rpartition("\r")[2] + "\n")
