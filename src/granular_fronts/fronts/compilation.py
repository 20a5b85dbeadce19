"""Compile every kernel of the exact fronts once, on fronts as short as can be.

Those of the multipliers are compiled by the one study that needs them.
"""

from granular_fronts.fronts.solve import METHODS, solve_front
from granular_fronts.fronts.sweep import sweep_fronts

# Hertz's exponent and another one, with one nonlinearity and with two.
LAWS = ((1.5, 0.5, 1.5), (1.4, 0.5, 1.4), (1.5, 0.5, 1.0))


def compile_kernels():
    """Compile every kernel, so that jobs which run side by side find them in the cache."""
    for law in LAWS:
        for method in METHODS:
            solve_front(*law, method=method)
    sweep_fronts(alpha=1.5, gammas=[0.5, 0.49])
