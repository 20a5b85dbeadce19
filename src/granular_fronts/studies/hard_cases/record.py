"""The record of a hard case, and when it has passed."""

from typing import NamedTuple


class HardCase(NamedTuple):
    """One problem, solved.

    Attributes
    ----------
    problem : str
        The problem in words.
    expected : str
        What the solution must do.
    criterion : str
        What `error` is the distance from, or the defect of.
    quantity : str
        What `measured` is.
    measured : float
        A number of the solution.
    error : float
        Largest distance from the answer known another way.
    limit : float
        The case has passed if `error` is at most this.
    """

    problem: str
    expected: str
    criterion: str
    quantity: str
    measured: float
    error: float
    limit: float

    @property
    def passed(self):
        """Whether the error is within the limit; NaN is not."""
        return bool(self.error <= self.limit)
