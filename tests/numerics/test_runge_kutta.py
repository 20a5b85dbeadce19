"""Algebraic identities of what is derived from SciPy's pair and its continuous extension."""

import numpy as np
import pytest

from granular_fronts.numerics import runge_kutta as rk

A, B, C = rk.A[: rk.STAGES, : rk.STAGES], rk.B[: rk.STAGES], rk.C[: rk.STAGES]
ROUNDING = 5.0e-15


def test_order_conditions_of_the_squared_matrix():
    """Σ b_i (A²)_ij c_j^{m-1} = 1/(m (m + 1) (m + 2)): the weights that the strain form uses."""
    squared = rk.A_SQUARED[: rk.STAGES, : rk.STAGES]
    for m in range(1, 7):
        exact = 1.0 / (m * (m + 1) * (m + 2))
        assert B @ (squared @ C ** (m - 1)) == pytest.approx(exact, abs=ROUNDING)


def test_windows_hold_the_rows_of_the_matrix_and_of_its_square():
    """All the slopes that a stage uses lie in its window, and the others have weight 0."""
    for row in range(1, rk.STAGES):
        first, terms = rk.FIRST_SLOT[row], rk.TERMS[row]
        for windows, matrix in ((rk.A_WINDOWS, rk.A), (rk.A_SQUARED_WINDOWS, rk.A @ rk.A)):
            slots = np.zeros(rk.SLOPES)
            slots[first : first + terms] = windows[row, :terms]
            np.testing.assert_allclose(slots[rk.SLOT], matrix[row], rtol=0, atol=ROUNDING)
            assert not windows[row, terms:].any()


def test_slots_hold_every_row():
    np.testing.assert_array_equal(rk.A_SLOTS[:, rk.SLOT], rk.A)
    np.testing.assert_allclose(rk.A_SQUARED_SLOTS[:, rk.SLOT], rk.A @ rk.A, rtol=0, atol=ROUNDING)
    np.testing.assert_array_equal(rk.CONTINUOUS_OF_SLOT[rk.SLOT].T, rk.CONTINUOUS)
    assert sorted(rk.SLOT) == list(range(rk.SLOPES))


@pytest.mark.parametrize(
    ("final", "weights"),
    [
        (rk.FINAL_B, rk.B),
        (rk.FINAL_B_A, rk.B @ rk.A),
        (rk.FINAL_5, rk.ERROR_5),
        (np.add(rk.FINAL_3_LESS_B, rk.FINAL_B), rk.ERROR_3),
    ],
)
def test_final_stages_hold_all_that_the_new_state_needs(final, weights):
    full = np.zeros(rk.SLOPES)
    full[list(rk.FINAL_STAGES)] = final
    np.testing.assert_allclose(full, weights, rtol=0, atol=ROUNDING)


def continuous(theta):
    return theta ** np.arange(rk.DEGREE + 1) @ rk.CONTINUOUS


def continuous_rate(theta):
    powers = np.arange(1, rk.DEGREE + 1)
    return (powers * theta ** (powers - 1)) @ rk.CONTINUOUS[1:]


def test_continuous_extension_has_the_values_and_the_slopes_of_the_ends():
    first, new = np.eye(rk.SLOPES)[[0, rk.NEW_SLOPE]]
    for found, exact, error in (
        (continuous(0.0), 0.0, 0.0),
        (continuous(1.0), rk.B, 1.0e-13),
        (continuous_rate(0.0), first, 1.0e-13),
        (continuous_rate(1.0), new, 1.0e-12),
    ):
        np.testing.assert_allclose(found, exact, rtol=0, atol=error)


@pytest.mark.parametrize("theta", [0.13, 0.86])
def test_continuous_extension_has_order_seven(theta):
    k = np.arange(1, 8)
    moments = continuous(theta) @ rk.C[:, None] ** (k - 1)
    np.testing.assert_allclose(moments, theta**k / k, rtol=0, atol=1.0e-13)
