"""Traveling fronts in dissipative granular chains, after James (2021).

The calls that matter most, where `gf` is this package:

======================  ===================================================================
`gf.solve_front`        the steady front of given α and damping, to round-off
`gf.sweep_fronts`       the same for many dampings
`gf.simulate_chain`     the motion of a chain that is pressed, pushed or struck
`gf.jump_conditions`    speed of a front, velocities and dissipation, from its two states
`gf.critical_damping`   the damping above which a front no longer oscillates
`gf.front_multipliers`  whether a front returns after a small kick
`gf.Scaling`            γ and the units of a chain of real beads
`gf.restitution`        restitution of two beads; back: `gf.damping_for_restitution`
`gf.make_law`           any other force between beads
`gf.plot`               pictures: ``gf.plot.front(front)``, ``gf.plot.chain(motion)``
======================  ===================================================================

For example:

>>> front = gf.solve_front(alpha=1.5, gamma=0.05)
>>> print(f"overshoot {front.attrs['overshoot']:.6f}")
overshoot 0.320675

Numbers are dimensionless.  The damping of `gf.solve_front` is γc, in units of the front; for a
chain with damping γ that is compressed by δ it is γ δ^((α − 1)/2) where β = α.  Results are xarray
datasets with errors beside the numbers: ``front.attrs["overshoot_error"]``, and `error_estimate`
among the attributes of each variable.  ``help(gf.solve_front)`` explains one call.
"""

# A public name is imported at its first use.  So a check of a configuration, or a help text, does
# not wait for numba.

from importlib import import_module

__version__ = "0.2.0"

_HOME_OF = {
    "Chain": "granular_fronts.scenes.chain",
    "Front": "granular_fronts.scenes.front",
    "Potential": "granular_fronts.model.potentials",
    "Ring": "granular_fronts.scenes.ring",
    "Scaling": "granular_fronts.model.scaling",
    "check_certificate": "granular_fronts.proofs.checker",
    "critical_damping": "granular_fronts.fronts.linear.critical_damping",
    "damping_for_restitution": "granular_fronts.model.collision",
    "contact_stiffness": "granular_fronts.model.materials",
    "damping_from_restitution": "granular_fronts.model.scaling",
    "evaluate_front": "granular_fronts.fronts.solve",
    "evolve_log_burgers": "granular_fronts.continuum.evolution",
    "evolve_log_kdv_burgers": "granular_fronts.continuum.evolution",
    "front_multipliers": "granular_fronts.fronts.linear.floquet",
    "heteroclinic": "granular_fronts.continuum.log_kdv_burgers.heteroclinic",
    "jump_conditions": "granular_fronts.model.jump_conditions",
    "log_burgers_front": "granular_fronts.continuum.log_burgers.equation",
    "make_law": "granular_fronts.model.laws",
    "prove_front": "granular_fronts.proofs.certificate",
    "pulses": "granular_fronts.chain.experiment",
    "restitution": "granular_fronts.model.collision",
    "simulate_chain": "granular_fronts.chain.simulate",
    "solve_front": "granular_fronts.fronts.solve",
    "sphere_stiffness": "granular_fronts.model.scaling",
    "sweep_fronts": "granular_fronts.fronts.sweep",
    "tail_roots": "granular_fronts.fronts.linear.tails",
}

_MODULES = {"plot": "granular_fronts.output.plot"}

__all__ = sorted([*_HOME_OF, *_MODULES])


def __getattr__(name: str) -> object:
    """Import a public name from its module (PEP 562)."""
    if name in _MODULES:
        return import_module(_MODULES[name])
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOME_OF[name]), name)


def __dir__() -> list[str]:
    return __all__
