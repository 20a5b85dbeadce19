"""Other people's integrators on the front initiation of James (2021), section 3.3.

One function per peer solves the chain, eqs. (31)–(32) with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

with u_n = x_n - x_{n+1}, u_0 = δ, u_N = 0 (free end), at rest and just touching at t = 0. The
unknowns are the paper's, (x, w). A peer times its solve alone, without start-up, compilation or
files, in wall-clock time.

A peer that is not installed returns a run whose `message` says so and whose arrays are empty.

Traps met:

- LSODA has a step limit between two output times: 500 in Scilab and in SciPy's odeint, 10 000 in
  numbalsoda. One output time at t = 700 needs more; the limit is lifted here.
- LSODA may change to its stiff method, whose Jacobian is dense, 840 × 840 and made by differences.
  At t = 700 it did not; at t = 3000 it did, and a solve of half a second or two then took Scilab
  50 s (rtol 1e-9) and odeint 7 minutes (rtol 1e-13).
- LSODA gets no closer than about 1e-12 at t = 700, whatever the tolerance.
- numbalsoda hands back what it has when it gives up (NaN from lsoda); only its flag tells.
- After contact loss (t > 750 for γ = 0.06) errors are far above the tolerance: 10⁵ times it for
  DOP853 at rtol 1e-13 and t = 3000.
- In contacts and momenta (u, w) instead of (x, w), numbalsoda's dop853 was 10 % faster at errors
  above 1e-9 and 8 % slower below 1e-11: the choice of unknowns does not decide the comparison.
"""

import importlib.util
import os
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np

STEP_LIMIT = 10_000_000
SCILAB_SCRIPT = Path(__file__).with_name("chain.sce")


@dataclass(frozen=True)
class ChainScene:
    """Front initiation with α = β = 3/2.

    Attributes
    ----------
    gamma, delta : float
        Damping and boundary compression.
    beads : int
        N ≥ 2.
    end : float
        Final time.
    """

    gamma: float = 0.06
    delta: float = 0.1
    beads: int = 420
    end: float = 700.0

    @property
    def pressure(self):
        """Force δ^{3/2} at the left end."""
        return self.delta**1.5

    def start(self):
        """Return (x, w) at t = 0, shape (2N,): velocities are zero, so w_1 = -γ δ^{3/2}."""
        state = np.zeros(2 * self.beads)
        state[self.beads] = -self.gamma * self.pressure
        return state

    def observe(self, state):
        """Return (u_1 … u_N, x_1' … x_N') of a state (x, w)."""
        positions, momenta = state[: self.beads], state[self.beads :]
        contacts = np.append(positions[:-1] - positions[1:], 0.0)
        forces = np.concatenate([[self.pressure], np.maximum(contacts, 0.0) ** 1.5])
        return contacts, momenta + self.gamma * (forces[:-1] - forces[1:])


@dataclass(frozen=True)
class PeerRun:
    """What a peer gives back.

    Attributes
    ----------
    u, velocity : ndarray, shape (N,)
        Relative displacements (u_N = 0) and velocities at the final time; empty without a result.
    seconds : float
        Wall-clock time of the solve alone, the best of the repeats.
    right_hand_sides : int
    message : str
        Empty, or why there is no result or a doubtful one.
    """

    u: np.ndarray = field(default_factory=lambda: np.empty(0))
    velocity: np.ndarray = field(default_factory=lambda: np.empty(0))
    seconds: float = np.nan
    right_hand_sides: int = 0
    message: str = ""


def missing_package(*names):
    """Return a sentence that names the first package which is not installed, or ''."""
    for name in names:
        if importlib.util.find_spec(name) is None:
            return f"the package {name} is not installed here (see peers-environment.txt)"
    return ""


def missing_scilab():
    """Return a sentence when there is no Scilab on the path, or ''."""
    return "" if shutil.which("scilab-cli") else "scilab-cli is not on the path"


def best_of(solve, repeats):
    """Return (what `solve` returns, the least seconds of `repeats` calls)."""
    best = np.inf
    for _ in range(repeats):
        started = time.perf_counter()
        answer = solve()
        best = min(best, time.perf_counter() - started)
    return answer, best


def numpy_right_hand_side(scene):
    """Return f(t, y) of the chain in vectorised numpy; it works in buffers of its own."""
    beads, gamma = scene.beads, scene.gamma
    forces = np.zeros(beads + 1)
    forces[0] = scene.pressure
    inner = forces[1:-1]
    roots = np.empty(beads - 1)

    def right_hand_side(_, state):
        np.subtract(state[: beads - 1], state[1:beads], out=inner)
        np.maximum(inner, 0.0, out=inner)
        np.sqrt(inner, out=roots)
        np.multiply(inner, roots, out=inner)
        out = np.empty_like(state)
        momentum_rate = out[beads:]
        np.subtract(forces[:-1], forces[1:], out=momentum_rate)
        np.multiply(momentum_rate, gamma, out=out[:beads])
        out[:beads] += state[beads:]
        return out

    return right_hand_side


def run_solve_ivp(scene, rtol, atol, repeats, method):
    """Run one method of SciPy's solve_ivp."""
    from scipy.integrate import solve_ivp

    def solve():
        return solve_ivp(
            numpy_right_hand_side(scene),
            (0.0, scene.end),
            scene.start(),
            method,
            t_eval=[scene.end],
            rtol=rtol,
            atol=atol,
        )

    answer, seconds = best_of(solve, repeats)
    if not answer.success:
        return PeerRun(message=f"solve_ivp stopped: {answer.message}")
    # SciPy raises a smaller rtol with no more than a warning.
    floor = 100 * np.finfo(float).eps
    message = f"rtol raised to {floor:.1e} by SciPy" if rtol < floor else ""
    return PeerRun(*scene.observe(answer.y[:, -1]), seconds, answer.nfev, message)


def run_scipy_dop853(scene, rtol, atol, repeats=1):
    """Run SciPy's solve_ivp(method="DOP853") on a numpy right-hand side."""
    return run_solve_ivp(scene, rtol, atol, repeats, "DOP853")


def run_scipy_lsoda(scene, rtol, atol, repeats=1):
    """Run SciPy's solve_ivp(method="LSODA") on a numpy right-hand side."""
    return run_solve_ivp(scene, rtol, atol, repeats, "LSODA")


@cache
def compiled_kernel():
    """Return the numba kernel (state, out, force, parameters): (x, w) to its derivative."""
    import numba

    @numba.njit(error_model="numpy")
    def kernel(state, out, force, gamma, pressure):
        # Slices that start at zero let the compiler use contiguous vector loads.
        beads = state.size // 2
        left, right, momenta = state[: beads - 1], state[1:beads], state[beads:]
        position_rate, momentum_rate = out[:beads], out[beads:]
        inner = force[1:beads]
        for n in range(beads - 1):
            compression = max(left[n] - right[n], 0.0)
            inner[n] = compression * np.sqrt(compression)
        force[0] = pressure
        force[beads] = 0.0
        behind, ahead = force[:beads], force[1:]
        for n in range(beads):
            difference = behind[n] - ahead[n]
            momentum_rate[n] = difference
            position_rate[n] = momenta[n] + gamma * difference

    return kernel


@cache
def compiled_odeint_function():
    """Return the numba function f(y, t, force, gamma, pressure) for SciPy's odeint."""
    import numba

    kernel = compiled_kernel()

    @numba.njit
    def right_hand_side(state, _, force, gamma, pressure):
        out = np.empty_like(state)
        kernel(state, out, force, gamma, pressure)
        return out

    return right_hand_side


def run_scipy_odeint(scene, rtol, atol, repeats=1):
    """Run SciPy's odeint on a compiled right-hand side."""
    absent = missing_package("numba")
    if absent:
        return PeerRun(message=absent)
    from scipy.integrate import odeint

    function = compiled_odeint_function()
    extra = (np.zeros(scene.beads + 1), scene.gamma, scene.pressure)
    function(scene.start(), 0.0, *extra)

    def solve():
        return odeint(
            function,
            scene.start(),
            np.array([0.0, scene.end]),
            args=extra,
            rtol=rtol,
            atol=atol,
            mxstep=STEP_LIMIT,
            full_output=True,
        )

    (states, log), seconds = best_of(solve, repeats)
    if log["message"] != "Integration successful.":
        return PeerRun(message=f"odeint stopped: {log['message']}")
    stiff = log["mused"][-1] == 2
    message = "changed to the stiff method" if stiff else ""
    return PeerRun(*scene.observe(states[-1]), seconds, int(log["nfe"][-1]), message)


@cache
def compiled_numbalsoda_function():
    """Return the C callback for numbalsoda; its data are (calls, γ, pressure, N, scratch …)."""
    import numba
    from numbalsoda import lsoda_sig

    kernel = compiled_kernel()

    @numba.cfunc(lsoda_sig)
    def right_hand_side(_, state, out, data):
        head = numba.carray(data, 4)
        beads = int(head[3])
        head[0] += 1.0
        force = numba.carray(data, 4 + beads + 1)[4:]
        size = 2 * beads
        kernel(numba.carray(state, size), numba.carray(out, size), force, head[1], head[2])

    return right_hand_side


def run_numbalsoda(scene, rtol, atol, repeats, name):
    """Run one solver of numbalsoda on a compiled right-hand side."""
    absent = missing_package("numba", "numbalsoda")
    if absent:
        return PeerRun(message=absent)
    import numbalsoda

    solver = getattr(numbalsoda, name)
    address = compiled_numbalsoda_function().address
    data = np.zeros(4 + scene.beads + 1)

    def solve(end=scene.end):
        data[:4] = 0.0, scene.gamma, scene.pressure, scene.beads
        times = np.array([0.0, end])
        return solver(address, scene.start(), times, data, rtol=rtol, atol=atol, mxstep=STEP_LIMIT)

    solve(1e-3 * scene.end)
    (states, success), seconds = best_of(solve, repeats)
    if not success:
        return PeerRun(message=f"numbalsoda.{name} reported failure")
    return PeerRun(*scene.observe(states[-1]), seconds, int(data[0]))


def run_numbalsoda_dop853(scene, rtol, atol, repeats=1):
    """Run numbalsoda's dop853 on a compiled right-hand side."""
    return run_numbalsoda(scene, rtol, atol, repeats, "dop853")


def run_numbalsoda_lsoda(scene, rtol, atol, repeats=1):
    """Run numbalsoda's lsoda on a compiled right-hand side."""
    return run_numbalsoda(scene, rtol, atol, repeats, "lsoda")


def run_scilab(scene, rtol, atol, repeats=1):
    """Run Scilab's default `ode` on a vectorised right-hand side; Scilab itself takes the time."""
    absent = missing_scilab()
    if absent:
        return PeerRun(message=absent)
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "final.bin"
        settings = {
            "GAMMA": repr(scene.gamma),
            "DELTA": repr(scene.delta),
            "BEADS": str(scene.beads),
            "END": repr(scene.end),
            "RTOL": repr(rtol),
            "ATOL": repr(atol),
            "REPEATS": str(repeats),
            "OUTPUT": str(output),
        }
        process = subprocess.run(
            ["scilab-cli", "-nb", "-f", str(SCILAB_SCRIPT)],
            env=os.environ | {f"CHAIN_{name}": value for name, value in settings.items()},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )
        if not output.exists():
            said = " ".join((process.stdout + process.stderr).split())
            return PeerRun(message=f"Scilab failed: {said}")
        seconds, calls, *state = np.fromfile(output, "<f8")
    return PeerRun(*scene.observe(np.array(state)), seconds, int(calls))


PEERS = {
    "scilab_ode": run_scilab,
    "scipy_lsoda": run_scipy_lsoda,
    "scipy_dop853": run_scipy_dop853,
    "scipy_odeint": run_scipy_odeint,
    "numbalsoda_lsoda": run_numbalsoda_lsoda,
    "numbalsoda_dop853": run_numbalsoda_dop853,
}
