"""The power law (28) as the compiled flow of one bead knows it."""

from typing import NamedTuple

HERTZ, POWER, PAIR = 0, 1, 2


class PowerLaw(NamedTuple):
    """Kernel kind, exponents α and β, damping γ, all dimensionless."""

    kind: int
    alpha: float
    beta: float
    gamma: float


def make_power_law(alpha, beta, gamma):
    """Choose the cheapest kernel that is exact for the exponents.

    Parameters
    ----------
    alpha, beta, gamma : float
        Exponents and damping of the contact law, James (2021), eq. (28).

    Returns
    -------
    PowerLaw
    """
    one_nonlinearity = beta == alpha or gamma == 0.0
    kind = PAIR if not one_nonlinearity else HERTZ if alpha == 1.5 else POWER
    return PowerLaw(kind, float(alpha), float(beta), float(gamma))
