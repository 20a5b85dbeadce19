r"""Damping of real beads; James (2021), Remark 6.

The remark turns measured coefficients of restitution e at the impact velocity :math:`v_0` into γ,
and prints γ, not e.  Its linear rule :math:`\gamma \approx 0.438\,(1 - e)` gives e back; the exact
collision of two beads with this e then has another γ, the larger the damping the more.

Fronts.  A Kuwabara-Kono front behind which the beads move at :math:`v_p` has, normalised to δ = c =
1, :math:`\gamma = \gamma(v_0)\,(v_p/v_0)^{(\alpha-1)/(\alpha+1)}` (29), whatever the mass and the
stiffness.  For a given force behind it :math:`v_p \propto F^{(\alpha+1)/(2\alpha)}\,m^{-1/2}
k^{-1/(2\alpha)}` needs both, but γ only to the power −1/15 of k for α = 3/2.  A front oscillates
below the critical damping of its tail (`fronts.linear.critical_damping`), which is lower than in
the long-wave limit, where :math:`\mu = 2\sqrt3\,\gamma\,(1 - 1/\alpha)^{-1/2} = 2` (54).
"""

import numpy as np
import xarray as xr

from granular_fronts.continuum.log_kdv_burgers.equation import amplitude_of_chain
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.model.collision import damping_for_restitution, restitution, weak_damping_slope
from granular_fronts.model.materials import material_of
from granular_fronts.model.scaling import (
    Scaling,
    damping_from_restitution,
    sphere_stiffness,
    velocity_of_force,
)

ALPHA = 1.5
"""Spheres."""

RELATIVE_ERROR = 1.0e-12
ERROR_METHOD = "bound on the relative error of the collision, checked by its tests"
UNITS = {"contact_damping": "s", "stiffness": "N m-1.5"}
ROOT = {"error_estimate": 4e-16, "error_method": "rounding of a root of two equations"}


def evaluate_materials(beads, impact_velocity, piston_velocities, forces):
    """Return the restitution, damping and fronts of beads of several materials, all in SI units.

    Each has `gamma` as printed for impacts at v₀, `mass` and `radius`, under the name of its
    material.  On (material,) there are `gamma_printed`, `restitution` by the linear rule,
    `gamma` of the exact collision, `restitution_exact` of the printed γ, `contact_damping` γ₀ and
    `stiffness` k.  On (material, piston_velocity) and (material, force) there are `gamma_front_…`
    and `mu_front_…`.  Below `critical_gamma` these fronts oscillate.
    """
    rows = [
        _evaluate(name, bead, impact_velocity, piston_velocities, forces)
        for name, bead in beads.items()
    ]
    dims = {"piston": "piston_velocity", "force": "force"}
    variables = {}
    for name in rows[0]:
        values = np.array([row[name] for row in rows])
        kind = dims.get(name.rpartition("_")[2])
        estimate = RELATIVE_ERROR * float(np.abs(values).max())
        attributes = {"error_estimate": estimate, "error_method": ERROR_METHOD}
        if name in UNITS:
            attributes["units"] = UNITS[name]
        variables[name] = (("material", kind) if kind else "material", values, attributes)
    variables["critical_gamma"] = ((), critical_damping(ALPHA), ROOT)
    return xr.Dataset(
        variables,
        {
            "material": list(beads),
            "piston_velocity": ("piston_velocity", list(piston_velocities), {"units": "m s-1"}),
            "force": ("force", list(forces), {"units": "N"}),
        },
        {"alpha": ALPHA},
    )


def _evaluate(name, bead, impact_velocity, piston_velocities, forces):
    """Return everything of one material, by the name of the variable."""
    mass = bead["mass"]
    _, modulus, ratio, _ = material_of(name)
    stiffness = sphere_stiffness(bead["radius"], modulus, ratio)
    e = 1.0 - bead["gamma"] / weak_damping_slope(ALPHA)
    damping = damping_from_restitution(e, impact_velocity, mass, stiffness, ALPHA)

    def front_gamma(velocity):
        return Scaling(mass, stiffness, damping, velocity, ALPHA).gamma

    pushed = [front_gamma(velocity) for velocity in piston_velocities]
    pressed = [front_gamma(velocity_of_force(force, mass, stiffness, ALPHA)) for force in forces]
    return {
        "gamma_printed": bead["gamma"],
        "restitution": e,
        "gamma": damping_for_restitution(e, ALPHA),
        "restitution_exact": restitution(bead["gamma"], ALPHA),
        "contact_damping": damping,
        "stiffness": stiffness,
        "gamma_front_piston": pushed,
        "mu_front_piston": [amplitude_of_chain(ALPHA, gamma).mu for gamma in pushed],
        "gamma_front_force": pressed,
        "mu_front_force": [amplitude_of_chain(ALPHA, gamma).mu for gamma in pressed],
    }
