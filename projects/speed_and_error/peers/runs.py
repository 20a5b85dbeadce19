"""The result of a run of one method, ours or a peer's."""

import importlib.util
import time
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Run:
    """One run of a method on a problem."""

    # The solution, under the names of the reference; empty without a result.
    fields: Mapping[str, np.ndarray] = field(default_factory=dict)
    seconds: float = np.nan  # wall-clock time of only the solve
    cpu_seconds: float = np.nan  # processor time, likewise
    message: str = ""  # why there is no result or an uncertain one
    absent: bool = False  # whether the method is not installed


class Stopwatch:
    """Times the block it is the context of, in wall-clock and processor seconds."""

    def __enter__(self):
        self._started = time.perf_counter(), time.process_time()
        return self

    def __exit__(self, *_):
        self.seconds = time.perf_counter() - self._started[0]
        self.cpu_seconds = time.process_time() - self._started[1]

    @property
    def times(self):
        """Both times, as `Run` takes them."""
        return {"seconds": self.seconds, "cpu_seconds": self.cpu_seconds}


def missing_package(*names):
    """Return a run that names the first package which is not installed, or None."""
    for name in names:
        if importlib.util.find_spec(name) is None:
            message = f"the package {name} is not installed (see peers-environment.txt)"
            return Run(message=message, absent=True)
    return None
