r"""Damping of collisions and fronts at all velocities; James (2021), section 3.1.

In multiples of :math:`v_c`, the velocity at which γ = 1, (29) is :math:`\gamma =
(v_0/v_c)^{2\beta/(\alpha+1)-1}`: damping is weak at small velocities for β above (α + 1)/2, and at
large ones for β below.  For β = (α + 1)/2 it does not depend on the velocity; γ = 1 is then an
example.  Of two beads that collide at :math:`v_0` the restitution follows.  A front behind which
the beads move at :math:`v_0` oscillates below a critical γ, at which the slowest root of its tail
becomes real (`granular_fronts.fronts.linear.critical_damping`; ours).
"""

import numpy as np
import xarray as xr

from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.model.collision import restitution

COLLISION = {
    "error_estimate": 1.0e-12,
    "error_method": "bound on the error of the collision, checked by its tests",
}
ROOT = {"error_estimate": 4e-16, "error_method": "rounding of a root of two equations"}


def evaluate_regimes(alpha, betas, decades, points):
    """Return γ and e against velocity for several exponents β of the viscous force.

    `gamma` and `restitution` on (beta, velocity_ratio), so many decades to both sides of v_c;
    `critical_gamma` on (beta,).
    """
    ratios = np.logspace(-decades, decades, points)
    powers = 2.0 * np.asarray(betas) / (alpha + 1.0) - 1.0
    gamma = ratios ** powers[:, None]
    e = [
        [restitution(one, alpha, beta) for one in row]
        for beta, row in zip(betas, gamma, strict=True)
    ]
    critical = [critical_damping(alpha, beta) for beta in betas]
    rounding = {"error_estimate": 4e-16 * float(gamma.max()), "error_method": "rounding"}
    return xr.Dataset(
        {
            "gamma": (("beta", "velocity_ratio"), gamma, rounding),
            "restitution": (("beta", "velocity_ratio"), e, COLLISION),
            "critical_gamma": ("beta", critical, ROOT),
        },
        {"beta": list(betas), "velocity_ratio": ratios},
    )
