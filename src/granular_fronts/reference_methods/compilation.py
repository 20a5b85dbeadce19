"""Compile the kernels of the upwind scheme, the reference that scenes of the workflow need."""

from granular_fronts.reference_methods.upwind import evolve_upwind


def compile_kernels():
    """Compile every kernel, so that jobs which run side by side find them in the cache."""
    evolve_upwind([0.5] * 8, 1.0, 1.0e-3)
