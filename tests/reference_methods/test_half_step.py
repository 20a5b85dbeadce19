"""The half-step scheme: LAMMPS to round-off, order, modified equation, limit of stability."""

import runpy
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr
from projects import ROOT
from rings import slope_and_residual
from scipy.integrate import solve_ivp

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import InputError
from granular_fronts.reference_methods.half_step import Chain, integrate
from peers.lammps_chain import find_command

SCRIPT = ROOT / "tools" / "references" / "make_lammps_reference.py"
OTHERS = xr.load_dataset(ROOT / "tests" / "references" / "other_codes_reference.nc")
STORED = xr.load_dataset(ROOT / "tests" / "references" / "lammps_reference.nc")
BEADS, END = 8, 12.0
DIFFERENCES = np.eye(BEADS)[:-1] - np.eye(BEADS)[1:]


def from_rest(chain, step, end=END, beads=BEADS):
    """The state at the end, of a chain at rest."""
    rest = np.zeros(beads)
    motion = integrate(chain, rest, rest, step, round(end / step))
    return motion.x[-1], motion.v[-1]


def exact(chain, end=END, beads=BEADS):
    """Relative displacements at the end, by the package's own solver."""
    scene = {
        "law": {"alpha": chain.alpha, "beta": chain.beta, "gamma": chain.gamma},
        "beads": beads,
        "boundary": {"kind": "pressure", "left": chain.left, "right": chain.right},
        "start": {"kind": "rest"},
        "end_time": end,
        "tolerance": {"relative": 1e-13, "absolute": 1e-15},
        "record": {"snapshots": [end]},
    }
    return simulate_chain(scene)["relative_displacement"].values[0, :-1]


@pytest.mark.parametrize("case", range(STORED.sizes["case"]))
def test_stored_motion_of_lammps_is_the_same_to_round_off(case):
    """Of both, positions are rounded once a step."""
    stored = STORED.isel(case=case)
    chain = Chain(1.5, *(float(stored[name]) for name in ("beta", "gamma", "left")))
    steps = round(STORED.attrs["end_time"] / STORED.attrs["step"])
    x, v = np.zeros((2, stored.sizes["bead"]))
    v[0] = stored["push"]
    motion = integrate(chain, x, v, STORED.attrs["step"], steps)
    np.testing.assert_allclose(motion.x[-1], stored["displacement"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(motion.v[-1], stored["velocity"], rtol=0, atol=2e-14)
    # The last digits are those of this scheme and of no other step.
    finer = integrate(chain, x, v, 0.5 * STORED.attrs["step"], 2 * steps)
    assert np.abs(finer.v[-1] - stored["velocity"]).max() > 1e-6


def test_stored_motions_open_contacts_and_name_the_version():
    gaps = -np.diff(STORED["displacement"].values, axis=1)
    assert (gaps.min(axis=1) < -0.01).sum() >= 6
    assert STORED.attrs["title"] == "LAMMPS (22 Jul 2025 - Update 4), fix nve"


@pytest.mark.parametrize("gamma", OTHERS["gamma"].values)
@pytest.mark.parametrize(("code", "beta"), [("liggghts", 1.5), ("yade", 1.25)])
def test_other_codes_move_by_the_same_scheme(code, beta, gamma):
    """YADE keeps velocities of half steps, and starts with rest half a step before t = 0."""
    stored = OTHERS.sel(code=code, gamma=gamma)
    step, (x, v) = OTHERS.attrs["step"], np.zeros((2, stored.sizes["bead"]))
    if code == "yade":
        v[0] = 0.5 * step * 0.1**1.5
    motion = integrate(Chain(1.5, beta, float(gamma), left=0.1), x, v, step, int(stored["steps"]))
    velocity = np.diff(motion.x[-2:], axis=0)[0] / step if code == "yade" else motion.v[-1]
    assert float(stored["beta"]) == beta
    np.testing.assert_allclose(motion.x[-1], stored["displacement"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(velocity, stored["velocity"], rtol=0, atol=2e-13)


LAMMPS = find_command()
needs_lammps = pytest.mark.skipif(not LAMMPS, reason="LAMMPS is not installed")


@needs_lammps
def test_installed_lammps_makes_the_stored_motions(tmp_path):
    output = tmp_path / "again.nc"
    subprocess.run([sys.executable, SCRIPT, "--lmp", LAMMPS, "--output", output], check=True)
    again = xr.load_dataset(output)
    np.testing.assert_allclose(again["displacement"], STORED["displacement"], rtol=0, atol=1e-12)


@needs_lammps
def test_predicted_velocities_of_lammps_are_of_second_order():
    chain = Chain(1.5, 1.5, 0.3, left=0.1)
    u = exact(chain, end=60.0, beads=20)
    made = runpy.run_path(str(SCRIPT))
    scene = made["scene_of"](1.5, 0.3, 0.1, 0.0)
    errors = [
        np.abs(-np.diff(made["final_state"](scene, step, LAMMPS, "mvv")[0]) - u)
        for step in (0.2, 0.1, 0.05)
    ]
    found, scatter = slope_and_residual([5.0, 10.0, 20.0], [error.max() for error in errors])
    assert found == pytest.approx(2.0, abs=0.15)
    assert scatter < 0.043


@pytest.mark.parametrize(
    ("beta", "gamma", "order"),
    [(1.5, 0.0, 2.0), (1.5, 0.3, 1.0), (1.25, 0.3, 1.0), (1.0, 0.3, 1.0)],
)
def test_order_is_two_without_damping_and_one_with_it(beta, gamma, order):
    chain = Chain(1.5, beta, gamma, left=1.0)
    u = exact(chain)
    steps = np.array([0.02, 0.01, 0.005, 0.0025])
    errors = [np.abs(-np.diff(from_rest(chain, step)[0]) - u).max() for step in steps]
    found, scatter = slope_and_residual(1.0 / steps, errors)
    assert found == pytest.approx(order, abs=0.06)
    assert scatter < 0.026


def chain_with_inertia(chain, step, g, force):
    """Accelerations where contacts carry −(h/2) g ü besides."""
    inertia = np.eye(BEADS) - 0.5 * step * DIFFERENCES.T @ (g[:, None] * DIFFERENCES)
    return np.linalg.solve(inertia, pressure(chain) - DIFFERENCES.T @ force)


def chain_with_factor(chain, step, g, force):
    """Accelerations where contacts are stronger by 1 + hg, as that of two free beads is."""
    return pressure(chain) - DIFFERENCES.T @ ((1.0 + step * g) * force)


def pressure(chain):
    """Force on each bead."""
    return np.eye(BEADS)[0] * chain.left**chain.alpha


def modified_chain(chain, step, accelerations):
    """Relative displacements at the end of a chain that the step modifies."""

    def rates(_, state):
        x, v = np.split(state, 2)
        u = np.maximum(DIFFERENCES @ x, 0.0)
        g = np.where(u > 0.0, chain.gamma * chain.beta * u ** (chain.beta - 1.0), 0.0)
        force = u**chain.alpha + g * (DIFFERENCES @ v)
        return np.concatenate([v, accelerations(chain, step, g, force)])

    answer = solve_ivp(rates, (0.0, END), np.zeros(2 * BEADS), rtol=1e-11, atol=1e-13)
    return DIFFERENCES @ answer.y[:BEADS, -1]


@pytest.mark.parametrize(
    ("accelerations", "order"), [(chain_with_inertia, 2.0), (chain_with_factor, 1.0)]
)
def test_modified_equation_explains_the_leading_error(accelerations, order):
    """The factor is that of two free beads; in a chain it explains nothing."""
    chain = Chain(1.5, 1.5, 0.3, left=1.0)
    steps = np.array([0.04, 0.02, 0.01])
    errors = [
        np.abs(-np.diff(from_rest(chain, step)[0]) - modified_chain(chain, step, accelerations))
        for step in steps
    ]
    found, scatter = slope_and_residual(1.0 / steps, [error.max() for error in errors])
    assert found == pytest.approx(order, abs=0.15)
    assert scatter < 0.026


def test_momentum_is_that_of_the_pressure():
    chain = Chain(1.5, 1.0, 0.2, left=0.7, right=0.3)
    _, v = from_rest(chain, 0.3)
    assert v.sum() == pytest.approx((0.7**1.5 - 0.3**1.5) * END, rel=1e-13)


@pytest.mark.parametrize(("stiffness", "damping"), [(1.0, 0.0), (0.5, 0.2), (0.1, 0.6)])
def test_limit_of_stability_is_that_of_the_shortest_wave(stiffness, damping):
    """A linear chain (α = 1 with stiffness s by the unit of time, β = 1) near h²s + 2hg = 1."""
    g = damping / np.sqrt(stiffness)
    limit = -g + np.sqrt(g**2 + 1.0)
    rest = np.full(40, 0.0)
    pressed = 10.0 * np.arange(40, 0, -1.0)
    kick = np.where(np.arange(40) % 2, 1e-3, -1e-3)
    for factor, grows in [(0.98, False), (1.02, True)]:
        step = factor * limit
        chain = Chain(1.0, 1.0, g, left=10.0, right=10.0)
        motion = integrate(chain, pressed, rest + kick, step, 400)
        assert (np.abs(motion.v).max() > 0.1) == grows


@pytest.mark.parametrize(
    ("change", "step", "sentence"),
    [
        ({"beta": 0.5}, 0.1, "beta is 0.5"),
        ({"gamma": -1.0}, 0.1, "gamma is -1.0"),
        ({}, 0.0, "step is 0.0"),
    ],
)
def test_impossible_chains_are_named(change, step, sentence):
    with pytest.raises(InputError, match=sentence):
        integrate(Chain(1.5, 1.5, 0.1)._replace(**change), [0.0, 0.0], [1.0, 0.0], step, 3)
