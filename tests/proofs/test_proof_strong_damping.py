"""Why the proof does not reach γ = ∞: norms of inverses grow, though the fronts themselves settle.

With x = ξ/γ the equation tends to u = P − dP/dx.  Its front is u^(α−1) = 1 − e^((α−1)x/α), and 0
ahead.
"""

import numpy as np
import pytest
from scipy import integrate

from granular_fronts.fronts.solve import evaluate_front, solve_front
from granular_fronts.proofs import right_inverse

# ∫ |k''| for the heat kernel k at time t is this over t.  Behind, −u' is nearly γ Δ P: a rough
# source spreads like heat on the lattice for times from 1/γ to 1, so norms grow by it times ln γ.
GROWTH = 2 * np.exp(-0.5) / np.sqrt(2 * np.pi)


def norm_of_inverse(alpha, gamma, per_bead):
    """1 + ‖G‖₁ for δ + G, the inverse of δ − α K, with cells of 1/(per_bead γ) beads."""
    n = per_bead * gamma
    middles, whole = (alpha * f for f in right_inverse.kernel(gamma, 0.0, n))
    inverse = right_inverse.periodic_inverse(middles, whole, n, span=30 * gamma)
    return 1 + abs(inverse).sum() / n


def limit(alpha, x):
    """The front of γ = ∞, shifted so that it is 1/2 at 0."""
    start = np.log(1 - 0.5 ** (alpha - 1)) * alpha / (alpha - 1)
    return np.maximum(-np.expm1((alpha - 1) / alpha * (x + start)), 0) ** (1 / (alpha - 1))


def force_from_limit(alpha, gamma):
    edge = -np.log(1 - 0.5 ** (alpha - 1)) * alpha / (alpha - 1)
    xi = np.linspace(-15 * gamma, edge * gamma + 8, 100_001)
    u = np.maximum(evaluate_front(solve_front(alpha, float(gamma)), xi), 0)
    return abs(u**alpha - limit(alpha, xi / gamma) ** alpha).max()


def test_norm_of_the_inverse_behind_grows_with_the_logarithm_of_damping():
    norms = [norm_of_inverse(1.5, gamma, 16) for gamma in (1, 4, 16, 64)]
    finer = norm_of_inverse(1.5, 16, 32)
    assert norms == pytest.approx([4.45, 5.21, 5.99, 6.73], abs=0.01)
    assert norms[2] == pytest.approx(finer, abs=0.003)
    rates = np.diff(norms) / np.log(4)
    assert (rates > GROWTH).all()
    assert rates[-1] < rates[-2] < 1.2 * GROWTH


@pytest.mark.parametrize(("alpha", "order"), [(1.5, 2.0), (3.0, 1.5)])
def test_fronts_tend_to_that_of_a_differential_equation(alpha, order):
    """By γ^(−2) behind, and by γ^(−α/(α−1)) where the limit ends."""
    distances = [force_from_limit(alpha, gamma) for gamma in (16, 32, 64)]
    assert np.log2(distances[0] / distances[1]) == pytest.approx(order, abs=0.05)
    assert np.log2(distances[1] / distances[2]) == pytest.approx(order, abs=0.01)


@pytest.mark.parametrize("gamma", [0.3, 1.0, 8.0])
def test_damping_takes_the_same_energy_from_all_fronts(gamma):
    """γ ∫ α u^(α−1) u'² = (α − 1)/(2(α + 1)), by the jump of energy."""
    front = solve_front(1.5, gamma)
    xi = np.linspace(-40 * max(gamma, 1), 8 + 4 * gamma, 400_001)
    u = np.maximum(evaluate_front(front, xi), 0)
    slope = np.gradient(u, xi)
    lost = gamma * integrate.simpson(1.5 * u**0.5 * slope**2, x=xi)
    assert lost == pytest.approx(0.1, rel=1e-6)
