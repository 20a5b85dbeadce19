"""The logarithmic KdV–Burgers equation by central differences and Radau's method of SciPy.

No scheme is shared with the package: conservative differences of sixth order on a ring, and
implicit steps of fifth order with the exact Jacobian.
"""

import numpy as np
from scipy import sparse
from scipy.integrate import solve_ivp

REACH = {1: 3, 2: 3, 3: 4}


def difference(points, spacing, derivative):
    """Central difference of sixth order for a derivative on a ring, as a sparse matrix."""
    offsets = np.arange(-REACH[derivative], REACH[derivative] + 1)
    powers = np.vander(offsets, increasing=True).T.astype(float)
    right = np.zeros(offsets.size)
    right[derivative] = np.prod(np.arange(1, derivative + 1)) / spacing**derivative
    weights = np.linalg.solve(powers, right)
    rows = np.arange(points)
    return sum(
        sparse.csr_array((np.full(points, w), (rows, (rows + k) % points)), (points, points))
        for w, k in zip(weights, offsets, strict=True)
    )


def evolve_differences(values, half_length, dispersion, end, tolerance=1.0e-9):
    """Values of y on −ℓ + 2ℓ j/M at the slow time `end`, from those at 0, with diffusion 1."""
    spacing = 2.0 * half_length / values.size
    first, second, third = (difference(values.size, spacing, order) for order in (1, 2, 3))
    linear = second - dispersion * third

    def rates(_, y):
        return linear @ y - first @ (y * np.log(np.abs(y)))

    def jacobian(_, y):
        return (linear - first @ sparse.diags_array(np.log(np.abs(y)) + 1.0)).tocsc()

    steps = {"rtol": tolerance, "atol": tolerance, "jac": jacobian}
    return solve_ivp(rates, (0.0, end), values, method="Radau", **steps).y[:, -1]
