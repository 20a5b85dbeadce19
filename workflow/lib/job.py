"""What a script does with the rule that runs it: its log, and errors as sentences."""

import gc
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from typing import Any

from granular_fronts.errors import InputError, NoSpaceError, SolveError
from granular_fronts.output.datasets import DatasetError


@contextmanager
def job(snakemake: Any) -> Iterator[None]:
    """Put what a job prints into the log of its rule, and end a failed one with its sentence."""
    with (
        open(snakemake.log[0], "w", encoding="utf-8", buffering=1) as log,
        redirect_stdout(log),
        redirect_stderr(log),
    ):
        try:
            yield
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
