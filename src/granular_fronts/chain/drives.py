r"""A force on bead 1, or its velocity, that is a given function of time between break points.

A drive is a sequence of pieces.  Piece k holds from its start :math:`t_k` to that of the next one,
and the last goes on for ever:

.. math:: f(t) = a_k + b_k s + c_k \sin(\omega_k s + \varphi_k), \qquad s = t - t_k .

That covers a pulse, a half sine, a harmonic, and a table of values with straight lines between
them.  The derivative of a piece is one too, with :math:`b_k` for the constant, :math:`c_k\omega_k`
for the amplitude and :math:`\varphi_k + \pi/2` for the phase; and

.. math::

    \int_{t_k}^t f\,dt' = a_k s + \tfrac12 b_k s^2 + c_k\, s \sin(\varphi_k + \tfrac12\omega_k s)\,
        \frac{\sin\tfrac12\omega_k s}{\tfrac12\omega_k s} .
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from granular_fronts.chain.state import DRIVE
from granular_fronts.scenes.drives import Piece


class Drive(NamedTuple):
    """A piecewise smooth function of time; `pieces` are records of type `state.DRIVE`, first at 0.

    Examples
    --------
    >>> from granular_fronts.chain.drives import make_drive
    >>> from granular_fronts.scenes.drives import Pulse
    >>> drive = make_drive(Pulse(height=2.0, duration=3.0).pieces())
    >>> drive.value([1.0, 4.0]).tolist(), drive.integral(4.0).item()
    ([2.0, 0.0], 6.0)
    """

    pieces: np.ndarray

    @property
    def breaks(self) -> np.ndarray:
        """Times at which the drive or its slope jumps."""
        return self.pieces["start"][1:]

    @property
    def is_constant(self) -> bool:
        """Whether the drive is a single constant."""
        first = self.pieces[0]
        return len(self.pieces) == 1 and not (first["rate"] or first["amplitude"])

    def value(self, t: npt.ArrayLike) -> np.ndarray:
        """Return f(t), elementwise; at a break point that of the later piece."""
        piece = self.pieces[np.searchsorted(self.breaks, t, side="right")]
        s = np.asarray(t) - piece["start"]
        oscillation = np.sin(piece["frequency"] * s + piece["phase"])
        return piece["constant"] + piece["rate"] * s + piece["amplitude"] * oscillation

    def integral(self, t: float) -> np.ndarray:
        """Return the integral of f from 0 to t."""
        piece, ends = self.pieces, np.append(self.breaks, np.inf)
        s = np.maximum(np.minimum(ends, t) - piece["start"], 0.0)
        half = 0.5 * piece["frequency"] * s
        mean = np.sin(piece["phase"] + half) * np.sinc(half / np.pi)
        slope = 0.5 * piece["rate"] * s
        return np.sum(s * (piece["constant"] + slope + piece["amplitude"] * mean))

    def derivative(self) -> "Drive":
        """Return f′ inside the pieces, as a drive."""
        pieces = self.pieces.copy()
        pieces["constant"], pieces["rate"] = self.pieces["rate"], 0.0
        pieces["amplitude"] *= pieces["frequency"]
        pieces["phase"] += 0.5 * np.pi
        return Drive(pieces)


def make_drive(pieces: list[Piece]) -> Drive | None:
    """Return the drive of these pieces, None without any: then the left end is held."""
    return Drive(np.array(pieces, DRIVE)) if pieces else None
