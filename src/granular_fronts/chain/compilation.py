"""Compile every kernel of the chain once, on motions as short as can be."""

from granular_fronts.chain.simulate import simulate_chain

# Hertz's exponent, another one, and two at once.
EXPONENTS = ((1.5, 1.5), (1.2, 1.2), (1.5, 1.0))


def compile_kernels():
    """Compile every kernel, so that jobs which run side by side find them in the cache."""
    for alpha, beta in EXPONENTS:
        scene = {
            "law": {"alpha": alpha, "beta": beta, "gamma": 0.1},
            "beads": 4,
            "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
            "start": {"kind": "rest"},
            "end_time": 1.0,
            "tolerance": {"relative": 1.0e-6, "absolute": 1.0e-8},
            "record": {"snapshots": [1.0], "balances": True, "extremes": True},
        }
        simulate_chain(scene, "that compiles the chain")
