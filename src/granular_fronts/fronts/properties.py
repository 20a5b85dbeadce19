r"""What is measured on a front: velocity, overshoot, width, slope, dissipated power.

Velocity.  In the notation of `profile.equation`

.. math::

    \dot x(\xi) = -cR_a - c\,(R_b - R_a)
        \Bigl[\int_{\xi-1}^{\xi} p(s)\,d\xi' - q(s(\xi)) + q(s(\xi - 1))\Bigr] ,

without a derivative of s.  Without the terms of q it is the generalised velocity w of James (2021),
eq. (31).

Dissipated power.  All contacts together dissipate :math:`\int W''(R)\,(cR')^2 d\xi`, in normalised
variables :math:`c^3 (R_b - R_a)^2 \int q'(s)\, s'^2 d\xi`.  The balance (6) across the front fixes
it, eq. (16), whatever W; for a Hertz chain at rest ahead it is (α − 1)/(2(α + 1)).  The integral is
a sum over the grid, whose error for a smooth function that is constant at both ends is smaller than
any power of h.
"""

import numpy as np

from granular_fronts.fronts.profile.equation import evaluate_slopes
from granular_fronts.fronts.profile.newton import fill_forces, make_forces
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interpolation import (
    derivative,
    find_level,
    interpolate_all,
    largest,
)
from granular_fronts.numerics.quadrature import kernel_weights


def velocity(profile, order):
    """Velocity ẋ at the points of a profile, shape (points,)."""
    problem, site = profile.problem, kernel_weights(profile.spacing, order).site
    width = site.size // 2
    forces = make_forces(profile.s.size, width)
    fill_forces(problem, profile.s, forces)
    q = forces.q[width:-width]
    one_site_back = profile.positions(profile.xi - 1.0)
    before = interpolate_all(q, one_site_back, problem.damping_number, 0.0)
    share = np.correlate(forces.p, site, "valid") - q + before
    return problem.speed * (problem.start + problem.jump * share)


def measure(profile):
    """Overshoot, width, slope and dissipated power of a profile.

    Returns
    -------
    dict
        `overshoot`, by how much the strain passes the state behind, 0 for a monotone front;
        `width_10_90` in sites between 90 % and 10 % of the way to the state behind, the last time
        the strain passes them; `slope`, the steepest on the way from behind; `dissipated_power`.
    """
    spacing = float(profile.spacing)
    return dict(zip(MEASURES, measures(profile.problem, spacing, profile.s), strict=True))


MEASURES = ("overshoot", "width_10_90", "slope", "dissipated_power")


@kernel
def measures(problem, spacing, s):
    """The numbers named in `MEASURES`."""
    jump = abs(problem.jump)
    rise, fall = find_level(s, 0.9, 1.0, 0.0), find_level(s, 0.1, 1.0, 0.0)
    slopes = derivative(s, 1.0, 0.0) / spacing
    stiffness, viscosity = np.empty(s.size), np.empty(s.size)
    evaluate_slopes(problem, s, stiffness, viscosity)
    power = problem.speed**3 * jump**2 * spacing * np.sum(viscosity * slopes**2)
    overshoot = jump * max(largest(s, 1.0, 0.0) - 1.0, 0.0)
    return overshoot, spacing * (fall - rise), jump * largest(-slopes, 0.0, 0.0), power
