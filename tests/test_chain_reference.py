"""The stored long-double states of the chain: laws, an independent integrator, a rebuild."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from scipy.integrate import solve_ivp

REFERENCES = Path(__file__).parent / "references"
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


@extended
@pytest.mark.slow
def test_rebuild_agrees_with_the_stored_states(tmp_path):
    output = tmp_path / "rebuilt.nc"
    script = REFERENCES / "make_chain_reference.py"
    subprocess.run([sys.executable, script, "--until", "700", "--output", output], check=True)
    stored = read_states()
    stored = stored.isel(state=np.flatnonzero(stored.t.values == 700.0))
    rebuilt = read_states(output)
    for name in ("relative_displacement", "velocity"):
        difference = np.abs(both_parts(stored, name) - both_parts(rebuilt, name)).max()
        assert difference < 1e-17
