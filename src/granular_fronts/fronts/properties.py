r"""What is measured on a front: velocity, overshoot, width, slope, dissipated power.

Velocity.  The momentum law :math:`\ddot x_n = f_{n-1} - f_n` with the contact force
:math:`f = P - \gamma c\,Q'` becomes :math:`c v' = f(\xi) - f(\xi - 1)` and, integrated with v → cr
ahead (James 2021, eq. (12)),

.. math::

    v(\xi) = c r + \frac1c \int_{\xi-1}^{\xi} [P(s) - r^\alpha]\,ds
           - \gamma\,[Q(\xi) - Q(\xi - 1)],

without a derivative of u.  The first two terms are the generalised velocity w of eq. (31).

Dissipated power.  All contacts together dissipate
:math:`\int \beta\gamma u^{\beta-1} (c u')^2 d\xi`.  The balance (6) across the front fixes it: with
the elastic energy :math:`u^{\alpha+1}/(\alpha+1)` it is

.. math::

    c\,\Bigl[\tfrac12 (1 - r)(1 + r^\alpha) - \frac{1 - r^{\alpha+1}}{\alpha+1}\Bigr],

for r = 0 the number (α − 1)/(2(α + 1)), whatever the damping.  The integral is a sum over the grid,
whose error for a smooth function that is constant at both ends is smaller than any power of h.
"""

import numpy as np

from granular_fronts.fronts.profile import newton
from granular_fronts.numerics.compiled import kernel
from granular_fronts.numerics.interpolation import derivative, find_level, interpolate_all, largest
from granular_fronts.numerics.quadrature import kernel_weights


def velocity(profile, order):
    """Velocity at the points of a profile, shape (points,)."""
    law, site = profile.law, kernel_weights(profile.spacing, order).site
    width = site.size // 2
    force, damping = np.empty((2, profile.u.size + 2 * width))
    newton.forces(law, width, profile.u, force, damping)
    generalised = law.speed * law.ahead + np.correlate(force, site, "valid") / law.speed
    damping = damping[width:-width]
    one_site_back = profile.positions(profile.xi - 1.0)
    before = interpolate_all(damping, one_site_back, 1.0 - law.ahead**law.beta, 0.0)
    return generalised - law.gamma * (damping - before)


def measure(profile):
    """Overshoot, width, slope and dissipated power of a profile.

    Returns
    -------
    dict
        `overshoot` max u − 1, 0 for a monotone front; `width_10_90` in sites between 90 % and 10 %
        of the way from r to 1, the last time u passes them; `slope` largest −u';
        `dissipated_power`.
    """
    spacing = float(profile.spacing)
    return dict(zip(MEASURES, measures(profile.law, spacing, profile.u), strict=True))


MEASURES = ("overshoot", "width_10_90", "slope", "dissipated_power")


@kernel
def measures(law, spacing, u):
    """The numbers named in `MEASURES`."""
    jump = 1.0 - law.ahead
    rise = find_level(u, law.ahead + 0.9 * jump, 1.0, law.ahead)
    fall = find_level(u, law.ahead + 0.1 * jump, 1.0, law.ahead)
    slopes = derivative(u, 1.0, law.ahead) / spacing
    stiffness = np.empty(u.size)
    newton.raise_to(law.beta - 1.0, u, stiffness)
    power = law.beta * law.gamma * law.speed**2 * spacing * np.sum(stiffness * slopes**2)
    overshoot = max(largest(u, 1.0, law.ahead) - 1.0, 0.0)
    return overshoot, spacing * (fall - rise), largest(-slopes, 0.0, 0.0), power
