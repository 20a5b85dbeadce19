"""The stored long-double states of the chain: their laws, a rebuild, and our errors."""

import subprocess
import sys

import numba
import numpy as np
import pytest
import xarray as xr
from chains import driven_scene
from projects import ROOT
from scipy.integrate import solve_ivp

from granular_fronts.chain.simulate import simulate_chain, solve

REFERENCES = ROOT / "tests" / "references"
DELTA = 0.1
extended = pytest.mark.skipif(
    np.finfo(np.longdouble).nmant < 63, reason="needs an 80-bit numpy.longdouble"
)


def read_states(path=REFERENCES / "chain_reference.nc"):
    """Return the reference Dataset, read whole."""
    return xr.load_dataset(path)


def both_parts(states, name):
    """Return a variable with its low part added, longdouble."""
    return states[name].values.astype(np.longdouble) + states[f"{name}_low"].values


def solve_in_positions(gamma, end, beads):
    """Return (u, velocity) from SciPy's DOP853 in positions and generalised velocities (x, w)."""
    pressure = DELTA**1.5
    start = np.zeros(2 * beads)
    start[beads] = -gamma * pressure

    def rates(positions):
        compression = np.maximum(positions[:-1] - positions[1:], 0.0)
        force = np.concatenate([[pressure], compression * np.sqrt(compression), [0.0]])
        return force[:-1] - force[1:]

    def derivative(_, state):
        momentum_rate = rates(state[:beads])
        return np.concatenate([state[beads:] + gamma * momentum_rate, momentum_rate])

    final = solve_ivp(derivative, (0.0, end), start, "DOP853", rtol=1e-13, atol=1e-15).y[:, -1]
    contact = np.append(final[: beads - 1] - final[1:beads], 0.0)
    return contact, final[beads:] + gamma * rates(final[:beads])


@numba.njit
def differentiate(contact, momentum, force, contact_rate, momentum_rate, velocity, gamma):
    """Fill the rates of contacts and momenta; `force` has δ^{3/2} first and zero last."""
    last = momentum.size - 1
    for n in range(last):
        compression = max(contact[n], 0.0)
        force[n + 1] = compression * np.sqrt(compression)
    for n in range(last + 1):
        momentum_rate[n] = force[n] - force[n + 1]
        velocity[n] = momentum[n] + gamma * momentum_rate[n]
    for n in range(last):
        contact_rate[n] = velocity[n] - velocity[n + 1]


@numba.njit
def solve_with_fixed_steps(gamma, pressure, beads, step, steps):
    """Return (u, velocity) from classical Runge–Kutta with compensated sums."""
    state, carry = np.zeros(2 * beads - 1), np.zeros(2 * beads - 1)
    state[beads - 1] = -gamma * pressure
    force, velocity = np.zeros(beads + 1), np.zeros(beads)
    force[0] = pressure
    rate = np.zeros_like(state)
    split = beads - 1
    for _ in range(steps):
        total = np.zeros_like(state)
        for stage in range(4):
            share = (0.0, 0.5, 0.5, 1.0)[stage] * step
            point = state + share * rate
            differentiate(
                point[:split], point[split:], force, rate[:split], rate[split:], velocity, gamma
            )
            total += (1.0, 2.0, 2.0, 1.0)[stage] * rate
        carry += step / 6 * total
        advanced = state + carry
        carry -= advanced - state
        state = advanced
    differentiate(state[:split], state[split:], force, rate[:split], rate[split:], velocity, gamma)
    return np.append(state[:split], 0.0), velocity


@extended
def test_momentum_law_holds_to_the_stated_error():
    states = read_states()
    total = both_parts(states, "velocity").sum(axis=1)
    pressure = np.longdouble(DELTA) * np.sqrt(np.longdouble(DELTA))
    assert np.max(np.abs(total - pressure * states.t.values.astype(np.longdouble))) < 2e-17


@pytest.mark.parametrize("gamma", [0.06, 0.65])
def test_scipy_in_positions_agrees_before_contact_loss(gamma):
    states = read_states()
    chosen = int(np.flatnonzero((states.gamma == gamma) & (states.t == 700.0))[0])
    contact, velocity = solve_in_positions(gamma, 700.0, states.sizes["bead"])
    expected = states.isel(state=chosen)
    assert np.max(np.abs(contact - expected.relative_displacement.values)) < 1e-12
    assert np.max(np.abs(velocity - expected.velocity.values)) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("end", [2600.0, 3000.0])
def test_fixed_steps_agree_after_contact_loss(end):
    states = read_states()
    expected = states.isel(state=int(np.flatnonzero(states.t == end)[0]))
    steps = int(512 * end)
    contact, velocity = solve_with_fixed_steps(0.06, DELTA**1.5, 420, 1 / 512, steps)
    # A kink crossed blindly costs γ (step)^{5/2}; at 1/8192 the difference is 5e-12.
    assert np.max(np.abs(contact - expected.relative_displacement.values)) < 1e-8
    assert np.max(np.abs(velocity - expected.velocity.values)) < 1e-8


@extended
@pytest.mark.slow
def test_rebuild_agrees_with_the_stored_states(tmp_path):
    output = tmp_path / "rebuilt.nc"
    script = ROOT / "tools" / "references" / "make_chain_reference.py"
    subprocess.run([sys.executable, script, "--until", "700", "--output", output], check=True)
    stored = read_states()
    stored = stored.isel(state=np.flatnonzero(stored.t.values == 700.0))
    rebuilt = read_states(output)
    for name in ("relative_displacement", "velocity"):
        difference = np.abs(both_parts(stored, name) - both_parts(rebuilt, name)).max()
        assert difference < 1e-17


def error_of(dataset, states, gamma, end):
    """Largest error of u and velocity of a solved scene against the stored state."""
    chosen = np.flatnonzero((states.gamma == gamma) & (states.t == end))
    expected = states.isel(state=int(chosen[0]))
    return max(
        np.abs(dataset[name].values[-1] - expected[name].values).max()
        for name in ("relative_displacement", "velocity")
    )


def initiation(gamma, end, relative=1.0e-13):
    """Front initiation of section 3.3, by default at the tolerances of the paper."""
    tolerance = {"relative": relative, "absolute": 1.0e-2 * relative}
    return driven_scene(gamma, beads=420, end_time=end, tolerance=tolerance)


@pytest.mark.parametrize(
    ("gamma", "end", "most"),
    [(0.06, 700.0, 1e-13), (0.65, 700.0, 1e-13), (0.06, 2600.0, 1e-10), (0.06, 3000.0, 1e-10)],
)
def test_our_error_at_the_tolerances_of_the_paper(gamma, end, most):
    """Contacts are lost after t = 700."""
    scene = initiation(gamma, end)
    dataset = solve(scene, scene["tolerance"]).dataset
    assert error_of(dataset, read_states(), gamma, end) < most


@pytest.mark.parametrize(("gamma", "end"), [(0.06, 700.0), (0.65, 700.0), (0.06, 2600.0)])
@pytest.mark.parametrize("relative", [1e-8, 1e-10, 1e-12])
def test_error_estimate_is_the_error(gamma, end, relative):
    """Before and after contact loss, where with events located it follows the tolerance too."""
    dataset = simulate_chain(initiation(gamma, end, relative))
    names = ("relative_displacement", "velocity")
    estimate = max(dataset[name].attrs["error_estimate"] for name in names)
    error = error_of(dataset, read_states(), gamma, end)
    assert 0.5 < estimate / error < 2.0
    assert error < 100.0 * relative
