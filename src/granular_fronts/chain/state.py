"""What a compiled chain works on: its law, its size, and its arrays in memory."""

import math
from typing import NamedTuple

import numpy as np

from granular_fronts.numerics.runge_kutta import SLOPES

HERTZ, POWER, PAIR = 0, 1, 2


class Law(NamedTuple):
    """Contact law (28): kernel kind, exponents α and β, damping γ, all dimensionless."""

    kind: int
    alpha: float
    beta: float
    gamma: float


class State(NamedTuple):
    r"""Arrays of one chain; index n = 0 … N + 1 is the bead number, stages come first.

    Attributes
    ----------
    u, d : ndarray, shape (columns,)
        State at the start of the step.
    new_u, new_d : ndarray, shape (columns,)
        State at its end.
    force, damping : ndarray, shape (columns,)
        :math:`u_+^\alpha` and :math:`u_+^\beta` of the last stage, boundary values included.
    k, g : ndarray, shape (16, columns)
        Slopes of the stages.
    """

    u: np.ndarray
    d: np.ndarray
    new_u: np.ndarray
    new_d: np.ndarray
    force: np.ndarray
    damping: np.ndarray
    k: np.ndarray
    g: np.ndarray


class Size(NamedTuple):
    """Number of beads N, of moving contacts (N − 1, or N on a ring), and what closes bead 1.

    Attributes
    ----------
    beads, contacts : int
    piston : bool
        Whether bead 1 is a piston.
    acceleration : float
        That of the piston now.
    """

    beads: int
    contacts: int
    piston: bool = False
    acceleration: float = 0.0


def make_law(alpha, beta, gamma):
    """Choose the cheapest kernel that is exact for the exponents.

    Parameters
    ----------
    alpha, beta, gamma : float
        Exponents and damping of the contact law, James (2021), eq. (28).

    Returns
    -------
    Law
    """
    one_nonlinearity = beta == alpha or gamma == 0.0
    kind = PAIR if not one_nonlinearity else HERTZ if alpha == 1.5 else POWER
    return Law(kind, float(alpha), float(beta), float(gamma))


def make_state(beads):
    """Allocate the arrays of a chain of `beads` beads, all zero."""
    columns = _columns(beads)
    vectors = _aligned_zeros((6, columns))
    return State(*vectors, _aligned_zeros((SLOPES, columns)), _aligned_zeros((SLOPES, columns)))


def _columns(beads):
    """Row length: whole cache lines, but no multiple of 4096 bytes, which makes rows collide."""
    columns = 8 * math.ceil((beads + 2) / 8)
    return columns + 8 if columns % 512 == 0 else columns


def _aligned_zeros(shape):
    """Zeros whose column 1, the first bead, starts a 64-byte cache line."""
    size = math.prod(shape)
    buffer = np.zeros(size + 16)
    offset = next(i for i in range(8) if (buffer.ctypes.data + 8 * (i + 1)) % 64 == 0)
    return buffer[offset : offset + size].reshape(shape)
