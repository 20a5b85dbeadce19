"""The half-step scheme: LAMMPS to round-off, order, modified equation, limit of stability."""

import runpy
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr
from lammps import LAMMPS, needs_lammps
from rings import assert_order
from scipy.integrate import solve_ivp

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.reference_methods.half_step import SCHEMES, Chain, integrate
from granular_fronts.studies.chain_scenes import pressed_chain
from projects import ROOT

SCRIPT = ROOT / "tools" / "references" / "make_lammps_reference.py"
OTHERS = xr.load_dataset(ROOT / "tests" / "references" / "other_codes_reference.nc")
STORED = xr.load_dataset(ROOT / "tests" / "references" / "lammps_reference.nc")
BEADS, END = 8, 12.0
DIFFERENCES = np.eye(BEADS)[:-1] - np.eye(BEADS)[1:]


def from_rest(chain, step, end=END, beads=BEADS, scheme="lagged_verlet"):
    """The state at the end, of a chain at rest."""
    rest = np.zeros(beads)
    steps, scheme = round(end / step), SCHEMES[scheme]
    motion = integrate(chain, rest, rest, step, steps, scheme=scheme)
    return motion.x[-1], motion.v[-1]


def exact(chain, end=END, beads=BEADS):
    """Relative displacements at the end, by the package's own solver."""
    law = {name: getattr(chain, name) for name in ("alpha", "beta", "gamma")}
    record = {"snapshots": [end]}
    scene = pressed_chain(law, beads, end, (1e-13, 1e-15), record, chain.left, chain.right)
    return simulate_chain(scene)["relative_displacement"].values[0, :-1]


def test_stored_motions_of_lammps_are_the_same_to_round_off():
    """Of both, positions are rounded once a step."""
    h, steps = STORED.attrs["step"], round(STORED.attrs["end_time"] / STORED.attrs["step"])
    for case in range(STORED.sizes["case"]):
        stored = STORED.isel(case=case)
        chain = Chain(1.5, *(stored[name].item() for name in ("beta", "gamma", "left")))
        x, v = np.zeros((2, stored.sizes["bead"]))
        v[0] = stored["push"].item()
        motion = integrate(chain, x, v, h, steps)
        np.testing.assert_allclose(motion.x[-1], stored["displacement"], rtol=0, atol=1e-12)
        np.testing.assert_allclose(motion.v[-1], stored["velocity"], rtol=0, atol=2e-14)
        # The last digits are those of this scheme and of no other step.
        finer = integrate(chain, x, v, 0.5 * h, 2 * steps)
        assert np.abs(finer.v[-1] - stored["velocity"].values).max() > 1e-6
    gaps = -np.diff(STORED["displacement"].values, axis=1)
    assert (gaps.min(axis=1) < -0.01).sum() >= 6
    assert STORED.attrs["title"] == "LAMMPS (22 Jul 2025 - Update 4), fix nve"


@pytest.mark.parametrize("gamma", OTHERS["gamma"].values)
@pytest.mark.parametrize(("code", "beta"), [("liggghts", 1.5), ("yade", 1.25)])
def test_other_codes_move_by_the_same_scheme(code, beta, gamma):
    stored = OTHERS.sel(code=code, gamma=gamma)
    chain, rest = Chain(1.5, beta, float(gamma), left=0.1), np.zeros(stored.sizes["bead"])
    motion = integrate(chain, rest, rest, OTHERS.attrs["step"], int(stored["steps"]))
    assert float(stored["beta"]) == beta
    np.testing.assert_allclose(motion.x[-1], stored["displacement"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(motion.v[-1], stored["velocity"], rtol=0, atol=2e-13)


@needs_lammps
def test_installed_lammps_makes_the_stored_motions(tmp_path):
    output = tmp_path / "again.nc"
    subprocess.run([sys.executable, SCRIPT, "--lmp", LAMMPS, "--output", output], check=True)
    again = xr.load_dataset(output)
    np.testing.assert_allclose(again["displacement"], STORED["displacement"], rtol=0, atol=1e-12)


@needs_lammps
def test_predicted_velocities_of_lammps_are_of_second_order():
    u = exact(Chain(1.5, 1.5, 0.3, left=0.1), end=60.0, beads=20)
    made, steps = runpy.run_path(str(SCRIPT)), np.array([0.2, 0.1, 0.05])
    scene = made["scene_of"](1.5, 0.3, 0.1, 0.0)
    runs = [made["final_state"](scene, step, LAMMPS, "mvv")[0] for step in steps.tolist()]
    assert_order(1.0 / steps, [np.abs(-np.diff(x) - u).max() for x in runs], 2.0, 0.15, 0.043)


@pytest.mark.parametrize(
    ("scheme", "beta", "gamma", "order"),
    [
        ("lagged_verlet", 1.5, 0.0, 2.0),
        *(("lagged_verlet", beta, 0.3, 1.0) for beta in (1.5, 1.25, 1.0)),
        *(("predicted_verlet", beta, 0.3, 2.0) for beta in (1.5, 1.25, 1.0)),
        *(("symplectic_euler", 1.5, gamma, 1.0) for gamma in (0.0, 0.3)),
    ],
)
def test_order_without_damping_and_with_it(scheme, beta, gamma, order):
    chain, steps = Chain(1.5, beta, gamma, left=1.0), np.array([0.02, 0.01, 0.005, 0.0025])
    u = exact(chain)
    errors = [
        np.abs(-np.diff(from_rest(chain, step, scheme=scheme)[0]) - u).max() for step in steps
    ]
    assert_order(1.0 / steps, errors, order, 0.06, 0.026)


def test_velocities_of_half_steps_are_those_of_symplectic_euler():
    """Started half a step before, its motion is that of the lagged step, its velocities late."""
    chain, step = Chain(1.5, 1.5, 0.3, left=1.0), 0.1
    lagged = integrate(chain, np.zeros(BEADS), np.zeros(BEADS), step, 120)
    start = -0.5 * step * np.eye(BEADS)[0]
    euler = integrate(chain, np.zeros(BEADS), start, step, 120, scheme=SCHEMES["symplectic_euler"])
    np.testing.assert_allclose(euler.x, lagged.x, rtol=0, atol=1e-14)
    mean = 0.5 * (euler.v[:-1] + euler.v[1:])
    np.testing.assert_allclose(mean, lagged.v[:-1], rtol=0, atol=1e-14)


def modified_chain(chain, step, is_chain):
    """Relative displacements at the end of a chain that the step modifies.

    Its contacts carry −(h/2) g ü besides, or are stronger by the factor 1 + hg of two free beads.
    """
    pressure = np.eye(BEADS)[0] * chain.left**chain.alpha

    def rates(_, state):
        x, v = np.split(state, 2)
        u = np.maximum(DIFFERENCES @ x, 0.0)
        g = np.where(u > 0.0, chain.gamma * chain.beta * u ** (chain.beta - 1.0), 0.0)
        force = u**chain.alpha + g * (DIFFERENCES @ v)
        if not is_chain:
            return np.concatenate([v, pressure - DIFFERENCES.T @ ((1.0 + step * g) * force)])
        inertia = np.eye(BEADS) - 0.5 * step * DIFFERENCES.T @ (g[:, None] * DIFFERENCES)
        return np.concatenate([v, np.linalg.solve(inertia, pressure - DIFFERENCES.T @ force)])

    answer = solve_ivp(rates, (0.0, END), np.zeros(2 * BEADS), "DOP853", rtol=1e-9, atol=1e-11)
    return DIFFERENCES @ answer.y[:BEADS, -1]


@pytest.mark.parametrize(("is_chain", "order"), [(True, 2.0), (False, 1.0)])
def test_modified_equation_explains_the_leading_error(is_chain, order):
    """The factor is that of two free beads; in a chain it explains nothing."""
    chain, steps = Chain(1.5, 1.5, 0.3, left=1.0), np.array([0.04, 0.02, 0.01])
    errors = [
        np.abs(-np.diff(from_rest(chain, step)[0]) - modified_chain(chain, step, is_chain)).max()
        for step in steps
    ]
    assert_order(1.0 / steps, errors, order, 0.15, 0.026)


@pytest.mark.parametrize(("stiffness", "damping"), [(1.0, 0.0), (0.1, 0.6)])
def test_limit_of_stability_is_that_of_the_shortest_wave(stiffness, damping):
    """A linear chain (α = 1 with stiffness s by the unit of time, β = 1) near h²s + 2hg = 1."""
    g = damping / np.sqrt(stiffness)
    chain = Chain(1.0, 1.0, g, left=10.0, right=10.0)
    pressed, kick = 10.0 * np.arange(40, 0, -1.0), np.where(np.arange(40) % 2, 1e-3, -1e-3)
    for factor, grows in [(0.98, False), (1.02, True)]:
        step = factor * (np.sqrt(g**2 + 1.0) - g)
        motion = integrate(chain, pressed, kick, step, 400)
        assert (np.abs(motion.v).max() > 0.1) == grows
