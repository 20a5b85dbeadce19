r"""How fronts change with velocity, pressure and exponent; James (2021), sections 1 and 3.3.

Velocity.  A front behind which the beads move at :math:`v_p` has, normalised,
:math:`\gamma \propto v_p^{2\beta/(\alpha+1)-1}` (29).  With γ critical at :math:`v_p = 1`, the
slowest exponent of its tail is complex on one side of this velocity and real on the other.

Pressure.  The tail of a front of any lattice from the compression δ into rest obeys

.. math:: c^2\lambda^2 = \bigl(V''(-\delta) - cW''(-\delta)\lambda\bigr)(2\cosh\lambda - 2)

with the c of (14).  The γ at which its slowest exponent ceases to be complex is found by bisection.

Exponent.  At fixed μ (54) the width of fronts grows like the scale of s, :math:`(1 -
1/\alpha)^{-1/2}`, as α → 1; at a fixed γ and α it stays finite as δ → 0.  Solitary waves become
Gaussian (see `solitary_waves`).
"""

import numpy as np
import xarray as xr

from granular_fronts.accuracy import Estimate, estimated_variable, with_refinement
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.fronts.solitary_waves import (
    POINTS_PER_BEAD,
    SETTLED,
    gaussian,
    solitary_wave,
)
from granular_fronts.model.jump_conditions import jump_conditions
from granular_fronts.model.potentials import make_potential
from granular_fronts.studies.front_survey import solve_converged

BISECTIONS = 45
ROOTS = {"error_estimate": 1.0e-14, "error_method": "a few units of the last digit"}
FRONT_METHOD = "difference of the front to a refined one"
WAVE_METHOD = "change on a grid of twice the points"
WIDTH = "width of a front in beads"
PEAK = "largest compression of a solitary wave"
DISTANCE = "distance of a solitary wave to the Gaussian, over the peak"
EXPONENT = "exponent of both forces"
BISECTION = {"error_estimate": 1.0e-11, "error_method": "width of the last interval"}


def follow_trends(alpha, betas, piston_velocities, displacements, gamma, exponents, mu):
    """Return the tails, critical dampings, widths and solitary waves along families of fronts.

    `tail_frequency` on (beta, piston_velocity), velocities over the one of critical damping, is 0
    for a monotone tail.  `critical_gamma` and `width_of_displacement`, for β = α and a fixed γ, are
    on (displacement,); `width_of_exponent` at a fixed μ, `solitary_peak`, the largest u, and
    `gaussian_distance`, over the peak, on (exponent,).  Raises NoFrontError.
    """
    frequencies = [
        [tail_frequency(alpha, beta, velocity) for velocity in piston_velocities] for beta in betas
    ]
    critical = [critical_gamma(alpha, displacement) for displacement in displacements]
    normalised = [gamma * displacement ** ((alpha - 1.0) / 2.0) for displacement in displacements]
    thin = [front_width(alpha, damping) for damping in normalised]
    wide = [front_width(a, mu * np.sqrt((1.0 - 1.0 / a) / 12.0)) for a in exponents]
    peaks, distances = zip(*(solitary_shape(a) for a in exponents), strict=True)
    variables = {
        "tail_frequency": (("beta", "piston_velocity"), frequencies, ROOTS),
        "critical_gamma": ("displacement", critical, BISECTION),
    }
    for name, axis, estimates, method, meaning in (
        ("width_of_displacement", "displacement", thin, FRONT_METHOD, WIDTH),
        ("width_of_exponent", "exponent", wide, FRONT_METHOD, WIDTH),
        ("solitary_peak", "exponent", peaks, WAVE_METHOD, PEAK),
        ("gaussian_distance", "exponent", distances, WAVE_METHOD, DISTANCE),
    ):
        variables[name] = estimated_variable(axis, estimates, method, long_name=meaning)
    behind, power = ({"long_name": what} for what in ("compression behind the front", EXPONENT))
    return xr.Dataset(
        variables,
        {
            "beta": list(betas),
            "piston_velocity": list(piston_velocities),
            "displacement": ("displacement", list(displacements), behind),
            "exponent": ("exponent", list(exponents), power),
        },
    )


def tail_frequency(alpha, beta, velocity):
    """Return Im λ of the slowest exponent of a tail, with critical damping at the velocity 1."""
    gamma = critical_damping(alpha, beta) * velocity ** (2.0 * beta / (alpha + 1.0) - 1.0)
    return float(tail_roots(alpha, gamma, beta, count=1)[0].imag)


def critical_gamma(alpha, displacement):
    """Return γ of (28), β = α, at which the tail of a front from δ to rest stops oscillating."""
    elastic = make_potential("hertz", alpha=alpha)
    behind = np.array([-displacement])
    speed = jump_conditions(elastic, -displacement, 0.0).speed
    stiffness = float(elastic.second(behind)[0])

    def oscillates(gamma):
        viscosity = float(make_potential("hertz", alpha=alpha, stiffness=gamma).second(behind)[0])
        slope = speed * viscosity / stiffness
        # The exponent and damping of the normalised chain with this tail.
        return tail_roots(stiffness / speed**2, slope, count=1)[0].imag > 0.0

    low, high = 1.0e-3 / speed, 1.0e3 / speed
    for _ in range(BISECTIONS):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if oscillates(middle) else (low, middle)
    return float(np.sqrt(low * high))


def front_width(alpha, gamma):
    """Return the distance from 90 to 10 per cent of an exact front, in beads, and its error."""
    front = solve_converged(alpha, gamma)
    return Estimate(front.attrs["width_10_90"], front.attrs["width_10_90_error"])


def solitary_shape(alpha):
    """Return the peak of a solitary wave and its distance to the Gaussian, each with its error."""
    waves = with_refinement(
        lambda points: solitary_wave(alpha, points), POINTS_PER_BEAD, 2 * POINTS_PER_BEAD
    )

    def distance(wave):
        exact = gaussian(alpha, wave.xi)
        return np.abs(wave.u / wave.u.max() - exact / exact.max()).max()

    settled = Estimate(0.0, SETTLED)
    return waves.estimate(lambda wave: wave.u.max()) + settled, waves.estimate(distance) + settled
