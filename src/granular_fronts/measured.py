"""What a measurement on a dataset returns; the modules named `measures` hold the measurements."""

from typing import NamedTuple


class Measured(NamedTuple):
    """A value and an estimate of its absolute error."""

    value: float
    error: float
