"""Implicit steps for strong damping: identities, order, and agreement with the explicit pair."""

import math

import numpy as np
import pytest
from chains import TIGHT, driven_scene, smooth_ring
from numpy.polynomial import Polynomial

from granular_fronts.chain import stiff
from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, prepare, work_done
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.chain.state import U
from granular_fronts.model.laws import make_law
from granular_fronts.numerics import radau
from granular_fronts.studies.hard_cases.extended import Motion, reference_state

LAWS = [(1.5, 1.5, 60.0), (3.0, 3.0, 30.0), (1.5, 1.0, 40.0), (1.5, 2.5, 30.0)]


def solve(scene, stiff_from, tolerance=TIGHT):
    run = prepare(scene)
    integrate(run, tolerance, stiff_from=stiff_from)
    return collect(scene, run), work_done(run.clock), run


def final(dataset):
    last = dataset.isel(t=-1)
    return np.concatenate([last["relative_displacement"], last["velocity"]])


def stiff_scene(alpha=1.5, beta=None, gamma=60.0, **changes):
    return driven_scene(gamma, 30, 20.0, alpha, beta, 1.0, **changes)


def test_collocation_is_of_order_nine():
    for power in range(9):
        integral = radau.WEIGHTS @ radau.NODES**power
        assert integral == pytest.approx(1.0 / (power + 1), abs=1e-15)
    assert abs(radau.WEIGHTS @ radau.NODES**9 - 0.1) > 1e-7
    for power in range(5):
        np.testing.assert_allclose(
            radau.MATRIX @ radau.NODES**power, radau.NODES ** (power + 1) / (power + 1), atol=1e-15
        )


def test_real_layout_parts_the_stages():
    np.testing.assert_allclose(radau.TO_STAGES @ radau.TO_ROWS, np.eye(5), atol=1e-13)
    parted = radau.TO_ROWS @ radau.MATRIX @ radau.TO_STAGES
    expected = np.zeros((5, 5))
    expected[0, 0] = radau.EIGENVALUES[0].real
    for pair, value in zip((1, 3), radau.EIGENVALUES[1:], strict=True):
        block = [[value.real, -value.imag], [value.imag, value.real]]
        expected[pair : pair + 2, pair : pair + 2] = block
    np.testing.assert_allclose(parted, expected, atol=1e-13)
    assert (radau.EIGENVALUES.real > 0.0).all()


def test_lagrange_weights_are_exact_for_polynomials():
    cubic = Polynomial([1.0, -2.0, 0.5, 3.0])
    nodes = np.array([0.0, 0.2, 0.7, 1.0])
    x = np.array([-0.3, 1.8])
    np.testing.assert_allclose(radau.lagrange_weights(nodes, x) @ cubic(nodes), cubic(x))


@pytest.mark.parametrize(("alpha", "beta", "gamma"), LAWS)
def test_implicit_steps_agree_with_the_explicit_pair(alpha, beta, gamma):
    scene = stiff_scene(alpha, beta, gamma)
    explicit, counts, _ = solve(scene, math.inf)
    implicit, implicit_counts, _ = solve(scene, 0.0)
    assert counts["steps_implicit"] == 0
    assert implicit_counts["steps_implicit"] > 20
    np.testing.assert_allclose(final(implicit), final(explicit), atol=1.0e-11)


@pytest.mark.slow
def test_implicit_steps_agree_with_extended_precision():
    scene = driven_scene(50.0, 16, 8.0, delta=1.0)
    motion = Motion(scene["law"], 1.0, 0.0, np.zeros(15), np.zeros(16))
    reference = reference_state(motion, 8.0)
    exact = np.concatenate([reference.relative_displacement, reference.velocity])
    dataset, counts, _ = solve(scene, stiff.STIFF)
    assert counts["steps_implicit"] > 0
    np.testing.assert_allclose(final(dataset), exact, atol=5.0e-12)


def test_error_follows_the_tolerance():
    """The tolerance is on u; a velocity holds γ times differences of forces beside w."""
    scene = stiff_scene(gamma=100.0)
    exact = final(solve(scene, math.inf)[0])
    amplified = stiff.damping_rate(make_law(alpha=1.5, gamma=100.0), 1.0)
    for tolerance in 10.0 ** np.arange(-12.0, -4.0):
        accuracy = {"relative": tolerance, "absolute": 1.0e-2 * tolerance}
        error = np.abs(final(solve(scene, 0.0, accuracy)[0]) - exact)
        assert error[:30].max() < tolerance
        assert error[30:].max() < 0.1 * amplified * tolerance


@pytest.mark.parametrize(("alpha", "beta", "gamma"), LAWS)
def test_balance_laws_hold(alpha, beta, gamma):
    record = {"snapshots": [20.0], "balances": True}
    dataset = simulate_chain(stiff_scene(alpha, beta, gamma, record=record))
    assert dataset.attrs["steps_implicit"] > 0
    assert dataset.attrs["solver"].startswith("Radau IIA")
    assert dataset.attrs["momentum_drift"] < 1.0e-13
    assert dataset.attrs["energy_drift"] < 1.0e-11


def test_error_estimate_holds():
    loose = {"relative": 1.0e-8, "absolute": 1.0e-10}
    scene = stiff_scene(gamma=100.0, tolerance=loose)
    dataset = simulate_chain(scene)
    exact = solve(scene, math.inf)[0]
    for name in ("relative_displacement", "velocity"):
        error = float(np.abs(dataset[name] - exact[name]).max())
        assert error < 2.0 * dataset[name].attrs["error_estimate"]


def test_every_output_is_met():
    """Probes crowd the start and go to the explicit pair; the grid is met by implicit steps."""
    record = {
        "snapshots": [0.0, 7.3, 20.0],
        "probes": {"start": {"beads": [1, 4], "start": 0.0, "stop": 2.0, "step": 0.01}},
        "grid": {"step": 0.5},
    }
    scene = stiff_scene(gamma=200.0, record=record)
    explicit, implicit = solve(scene, math.inf)[0], solve(scene, stiff.STIFF)[0]
    for name in explicit.data_vars:
        np.testing.assert_allclose(implicit[name], explicit[name], atol=2.0e-11, err_msg=name)


def test_contact_that_closes_goes_to_the_explicit_pair():
    """Two squeezed halves of a free chain, with a gap between them, expand until they touch."""
    start = {
        "kind": "given",
        "relative_displacement": [1.0] * 6 + [-0.02] + [1.0] * 6,
        "velocity": [0.0] * 14,
    }
    scene = driven_scene(200.0, 14, 60.0, delta=0.0, start=start)
    explicit, _, run = solve(scene, math.inf)
    implicit, counts, _ = solve(scene, stiff.STIFF)
    assert run.table[U, 7] > 0.0, "the gap has closed"
    assert counts["steps_implicit"] > 0
    assert counts["steps_accepted"] > counts["steps_implicit"], "explicit steps, where it closes"
    np.testing.assert_allclose(final(implicit), final(explicit), atol=1.0e-10)


def test_only_stiff_chains_take_implicit_steps():
    assert stiff.suits(prepare(stiff_scene()))
    assert not stiff.suits(prepare(driven_scene(0.65)))
    assert not stiff.suits(prepare(driven_scene(5.0)))
    extremes = stiff_scene(record={"snapshots": [20.0], "extremes": True})
    assert not stiff.suits(prepare(extremes))
    u, velocity = smooth_ring()
    ring = driven_scene(100.0, 24) | {"boundary": {"kind": "ring"}}
    start = {"kind": "given", "relative_displacement": list(u), "velocity": list(velocity)}
    assert not stiff.suits(prepare(ring | {"start": start}))


def test_stiffness_does_not_depend_on_the_units():
    """Scaling (27)-(30): γ → γ δ^((1−α)/2) at δ leaves it unchanged."""
    one = stiff.stiffness(make_law(alpha=1.5, gamma=10.0), 1.0)
    scaled = stiff.stiffness(make_law(alpha=1.5, gamma=10.0 * 1.0e-4**-0.25), 1.0e-4)
    assert scaled == pytest.approx(one, rel=1e-14)
    assert stiff.stiffness(make_law(alpha=1.5, gamma=0.0), 1.0) == 0.0
