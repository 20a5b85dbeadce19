"""Problems at the edge of what the solvers can do, each with an answer known some other way."""

from typing import NamedTuple


class HardCase(NamedTuple):
    """One problem, solved."""

    problem: str  # in words
    expected: str  # what the solution must do
    criterion: str  # what `error` is the distance from, or the defect of
    quantity: str  # what `measured` is
    measured: float  # a number of the solution
    error: float  # largest distance from the answer known another way
    limit: float  # the case has passed if `error` is at most this

    @property
    def passed(self):
        """Whether the error is within the limit; NaN is not."""
        return bool(self.error <= self.limit)
