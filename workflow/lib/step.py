"""Run one step of the workflow, a function with named, typed arguments.

A script holds one such function, which can be imported and called, and ends with ::

    if __name__ == "__main__":
        run_step(function, globals()["snakemake"])

The rule's named input, output and params become its arguments.  The log file of the rule holds what
the step prints.  If the step fails, it ends with the sentence of the error.
"""

import gc
import sys
import traceback
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from inspect import signature
from pathlib import Path
from typing import Any

from granular_fronts.errors import InputError, NoSpaceError, SolveError
from granular_fronts.output.datasets import DatasetError


def run_step(function: Callable[..., None], snakemake: Any, **given: Any) -> None:
    """Call a step function with the values of its rule.

    Parameters
    ----------
    function : callable
        The step. The sentence of a wrong value or a full disk ends it; any other error shows where
        it is.
    snakemake : object
        The object Snakemake puts into a script.
    **given
        Arguments of the step that the rule does not give.
    """
    with (
        open(snakemake.log[0], "w", encoding="utf-8", buffering=1) as log,
        redirect_stdout(log),
        redirect_stderr(log),
    ):
        try:
            function(**given, **arguments_of(function, snakemake))
        except KeyboardInterrupt:
            sys.exit(130)
        except (InputError, SolveError, DatasetError, NoSpaceError) as error:
            print(error)
            sys.exit(1)
        except Exception:
            traceback.print_exc()
            sys.exit(1)
    # Python looks for garbage when it ends, without this among all that was imported.
    gc.freeze()


def arguments_of(function: Callable[..., Any], snakemake: Any) -> dict[str, Any]:
    """Pick the arguments of a function from a rule's named input, output and params.

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
        one.name: convert.get(one.annotation, lambda value: value)(given[one.name])
        for one in signature(function, eval_str=True).parameters.values()
        if one.name in given
    }
