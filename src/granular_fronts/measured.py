"""What a measurement on a dataset returns; the modules named `properties` hold the measurements."""

from typing import NamedTuple


class Measured(NamedTuple):
    """A value and an estimate of its absolute error, both dimensionless."""

    value: float
    error: float
