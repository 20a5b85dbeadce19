"""Long-double reference states of the granular chain of James (2021), section 3.3.

Beads n = 1 … N obey eqs. (31)–(32) of G. James, Nonlinearity 34 (2021) 1758, with α = β = 3/2,

    x_n' = w_n + γ [F(u_{n-1}) - F(u_n)],   w_n' = F(u_{n-1}) - F(u_n),   F(u) = max(u, 0)^{3/2},

where u_n = x_n - x_{n+1}. The left end is pressed (u_0 = δ), the right end is free (u_N = 0), and
the chain is at rest and just touching at t = 0: u_n = 0 and x_n' = 0, so that w_1 = -γ F(δ) and
all other w_n = 0.

Method. The unknowns are (u_n, w_n), with u_n' = x_n' - x_{n+1}', in 80-bit arithmetic. A step is
Gragg's smoothed midpoint rule extrapolated in h² (Bulirsch and Stoer), column by column until two
neighbouring columns agree to the tolerance. Its weights are ratios of integers, so that round-off
is the only floor. The step advances increments, which are added with a running compensation.

F is only C^{3/2} where a contact opens or closes. No extrapolation holds its order across such an
instant, and an error estimate may miss it. The steps are therefore graded geometrically towards
every zero of every u_n and away from it again, and the one step that straddles the zero must be so
short that the whole contribution of the kink, (γ + h) h |Δu|^{3/2}, is below its own tolerance.

Each state is computed three times, with other sequences of substeps, other numbers of columns and
other tolerances. The largest difference from the kept run is the error stated for it.

Run ``python make_chain_reference.py --help`` for the command line.
"""

import argparse
import json
import time
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
import xarray as xr

REAL = np.longdouble
BEADS = 420
DELTA = 0.1
NEGLIGIBLE = REAL("1e-60")
WINDOW_MARGIN = 8
CASES = {0.06: (700.0, 2600.0, 3000.0), 0.65: (700.0,)}


@dataclass(frozen=True)
class Settings:
    """Choices of one run.

    Attributes
    ----------
    sequence : tuple of int
        Even, increasing numbers of substeps, one per extrapolation column.
    tolerance : float
        Largest accepted difference of neighbouring columns in one step, maximum norm.
    kink_tolerance : float
        Largest accepted contribution of one opening or closing contact.
    """

    sequence: tuple[int, ...]
    tolerance: float
    kink_tolerance: float


# More columns would cost less work but enlarge round-off: the weights of ten columns sum to 150.
REFERENCE = Settings((2, 4, 6, 8, 12, 16, 24, 32), 5e-19, 1e-23)
CHECKS = (
    Settings((2, 4, 6, 8, 10, 12, 14, 16), 1e-18, 1e-22),
    Settings((2, 4, 6, 8, 10, 12, 14), 3e-18, 1e-21),
)


@dataclass
class Counts:
    """Work of one run; `straddling` counts accepted steps that hold an opening or closing."""

    accepted: int = 0
    rejected_error: int = 0
    rejected_kink: int = 0
    straddling: int = 0
    right_hand_sides: int = 0


def require_extended_precision():
    """Refuse a platform whose ``numpy.longdouble`` has no 64-bit significand."""
    bits = np.finfo(REAL).nmant + 1
    if bits < 64:
        raise RuntimeError(
            f"numpy.longdouble has a significand of {bits} bits here and 64 are needed; "
            "rebuild the reference on an x86-64 Linux machine"
        )


class Chain:
    """Right-hand side of the chain in (u_1 … u_{N-1}, w_1 … w_N), cut to the beads in motion.

    Parameters
    ----------
    gamma : float
        Damping; its double value, extended exactly, defines the problem. So do those of `delta`.
    delta : float
        Compression held at the left end.
    beads : int
        N.
    """

    def __init__(self, gamma, delta=DELTA, beads=BEADS):
        self.gamma = REAL(gamma)
        self.delta = REAL(delta)
        self.beads = beads
        self.evaluations = 0
        self.resize(min(beads, WINDOW_MARGIN))

    def resize(self, active):
        """Keep the first `active` beads; the contact right of the last one is open."""
        self.active = active
        self.force = np.zeros(active + 1, dtype=REAL)
        self.force[0] = self.delta * np.sqrt(self.delta)

    @property
    def contacts(self):
        """Number of moving contacts, which come first in a packed state."""
        return self.active - 1

    def start(self):
        """Return the start: every contact closed without force, every bead at rest."""
        state = np.zeros(2 * self.active - 1, dtype=REAL)
        state[self.active - 1] = -self.gamma * self.force[0]
        return state

    def split(self, state):
        """Return views (u, w) of a packed state."""
        return state[: self.contacts], state[self.contacts :]

    def rates(self, state):
        """Return (w', x') for a packed state."""
        contact, momentum = self.split(state)
        inner = self.force[1:-1]
        np.maximum(contact, 0, out=inner)
        inner *= np.sqrt(inner)
        momentum_rate = self.force[:-1] - self.force[1:]
        return momentum_rate, momentum + self.gamma * momentum_rate

    def derivative(self, state):
        """Return the time derivative of a packed state."""
        self.evaluations += 1
        momentum_rate, velocity = self.rates(state)
        out = np.empty_like(state)
        np.subtract(velocity[:-1], velocity[1:], out=out[: self.active - 1])
        out[self.active - 1 :] = momentum_rate
        return out

    def regrow(self, *packed):
        """Cut negligible tails and widen the window ahead of the wave; return the new arrays."""
        parts = [[part.copy() for part in self.split(state)] for state in packed]
        contact, momentum = parts[0]
        contact[np.abs(contact) < NEGLIGIBLE] = 0
        momentum[np.abs(momentum) < NEGLIGIBLE] = 0
        moving = np.flatnonzero(contact)
        reached = moving[-1] + 2 if moving.size else 1
        wanted = min(self.beads, reached + WINDOW_MARGIN)
        if wanted <= self.active:
            return [np.concatenate(pair) for pair in parts]
        extra = np.zeros(wanted - self.active, dtype=REAL)
        self.resize(wanted)
        return [np.concatenate([u, extra, w, extra]) for u, w in parts]

    def finish(self, state):
        """Return (u_1 … u_N, x_1' … x_N') of the whole chain."""
        contact, _ = self.split(state)
        _, velocity = self.rates(state)
        whole = np.zeros((2, self.beads), dtype=REAL)
        whole[0, : contact.size] = contact
        whole[1, : velocity.size] = velocity
        return whole[0], whole[1]


def midpoint_slope(chain, state, slope, step, substeps, low, high):
    """Return the mean slope of a smoothed midpoint step and widen (low, high) to its contacts.

    Parameters
    ----------
    chain : Chain
    state, slope : ndarray of longdouble
        State at the start of the step and its derivative.
    step : longdouble
    substeps : int
        Even.
    low, high : ndarray of longdouble
        Extremes of each contact over all stages, updated in place.

    Returns
    -------
    ndarray of longdouble
        Increment of the state divided by `step`.
    """
    small = step / substeps
    contacts = chain.contacts
    # Sums of slopes, not increments: the rounding of step / substeps then stays out of the result,
    # where the extrapolation would enlarge it into a drift.
    previous = np.zeros_like(state)
    current = slope.copy()
    for index in range(substeps):
        stage = state + small * current
        np.minimum(low, stage[:contacts], out=low)
        np.maximum(high, stage[:contacts], out=high)
        rate = chain.derivative(stage)
        if index < substeps - 1:
            previous += 2 * rate
            previous, current = current, previous
    return (previous + current + rate) / (2 * substeps)


def extrapolate(chain, state, slope, step, settings):
    """Return (increment, error, column, low, high) of one extrapolated step.

    `column` counts from 1; the step has failed when `error` exceeds the tolerance.
    """
    contacts = chain.contacts
    low, high = state[:contacts].copy(), state[:contacts].copy()
    squares = [substeps**2 for substeps in settings.sequence]
    above = []
    error = REAL(np.inf)
    for column, substeps in enumerate(settings.sequence):
        row = [midpoint_slope(chain, state, slope, step, substeps, low, high)]
        for back in range(1, column + 1):
            older = squares[column - back]
            difference = row[-1] - above[back - 1]
            row.append(row[-1] + older * difference / (squares[column] - older))
        if column:
            error = step * np.max(np.abs(row[-1] - row[-2]))
        above = row
        # A step that agrees after very few columns may have been lucky.
        if column >= 3 and error <= settings.tolerance:
            break
    return step * row[-1], error, column + 1, low, high


def kink_contribution(chain, size, step):
    """Return (γ + h) h |Δu|^{3/2}, the most that a kink of depth `size` adds within one step."""
    return (chain.gamma + step) * step * size * np.sqrt(size)


def largest_kink(chain, low, high, step):
    """Return the largest contribution of a contact that changes sign between `low` and `high`."""
    depth = np.maximum(np.minimum(high, -low), 0)
    # Noise around zero ahead of the wave is no crossing.
    crossing = kink_contribution(chain, depth, step) > REAL("1e-28")
    if not crossing.any():
        return REAL(0)
    return np.max(kink_contribution(chain, (high - low)[crossing], step))


def limit_to_crossings(chain, state, slope, step, settings):
    """Shorten `step` so that it ends before the next opening or closing, or only just beyond it."""
    contact, _ = chain.split(state)
    rate, _ = chain.split(slope)
    nearing = contact * rate < 0
    size = np.abs(contact[nearing])
    ahead = size / np.abs(rate[nearing])
    harmful = kink_contribution(chain, size, step) > settings.kink_tolerance
    relevant = harmful & (ahead < 2 * step)
    if not relevant.any():
        return step
    size, ahead = size[relevant], ahead[relevant]
    crossable = kink_contribution(chain, 2 * size, 2 * ahead) < settings.kink_tolerance
    return min(step, np.min(np.where(crossable, REAL(1.5), REAL(0.6)) * ahead))


def integrate(chain, times, settings):
    """Integrate a chain from its start.

    Parameters
    ----------
    chain : Chain
    times : sequence of float
        Increasing output times.
    settings : Settings

    Returns
    -------
    states : list of (ndarray, ndarray)
        (u_1 … u_N, x_1' … x_N') at each time, longdouble, shape (N,) each.
    counts : Counts
    """
    counts = Counts()
    state = chain.start()
    carry = np.zeros_like(state)
    now, step = REAL(0), REAL("1e-7")
    states = []
    for goal in map(REAL, times):
        while now < goal:
            slope = chain.derivative(state)
            wanted = on_clock(limit_to_crossings(chain, state, slope, step, settings))
            trial = min(wanted, goal - now)
            increment, error, column, low, high = extrapolate(chain, state, slope, trial, settings)
            kink = largest_kink(chain, low, high, trial)
            if error > settings.tolerance:
                counts.rejected_error += 1
                step = trial * shrink_factor(error, settings)
                continue
            if kink > settings.kink_tolerance:
                counts.rejected_kink += 1
                step = trial / 2
                continue
            counts.accepted += 1
            counts.straddling += bool(kink)
            carry += increment
            advanced = state + carry
            carry -= advanced - state
            state = advanced
            now = goal if trial == goal - now else now + trial
            grown = trial * growth_factor(error, column, settings)
            step = max(grown, wanted) if trial < wanted else grown
            state, carry = chain.regrow(state, carry)
        states.append(chain.finish(state))
    counts.right_hand_sides = chain.evaluations
    return states, counts


def on_clock(step):
    """Round a step to a multiple of 2⁻⁵⁰, so that the sum of all steps carries no error."""
    return max(np.floor(step * REAL(2) ** 50), REAL(1)) / REAL(2) ** 50


def shrink_factor(error, settings):
    """Return the factor for a step whose last column missed the tolerance by `error`."""
    power = 1 / (2 * len(settings.sequence) - 1)
    return REAL(max(0.1, 0.8 * float(settings.tolerance / error) ** power))


def growth_factor(error, column, settings):
    """Return the factor after a step accepted at `column`."""
    missing = len(settings.sequence) - column
    if missing >= 2:
        return REAL(2)
    if missing == 1:
        return REAL(1.15)
    power = 1 / (2 * column - 1)
    return REAL(min(1.1, 0.9 * float(settings.tolerance / max(error, REAL("1e-22"))) ** power))


def momentum_defect(instant, velocity, delta=DELTA):
    """Return Σ x_n' - δ^{3/2} t, which the exact solution keeps at zero."""
    return velocity.sum() - REAL(delta) * np.sqrt(REAL(delta)) * REAL(instant)


def largest_differences(kept, others):
    """Return the largest |difference| of each quantity from the kept state over all other runs."""
    return [
        max(float(np.max(np.abs(part - other[index]))) for other in others)
        for index, part in enumerate(kept)
    ]


def solve_case(make_chain, times, every_settings=(REFERENCE, *CHECKS)):
    """Compute one chain with every setting.

    Parameters
    ----------
    make_chain : callable
        Gives a fresh Chain.
    times : sequence of float
    every_settings : sequence of Settings, optional
        The first makes the kept run.

    Returns
    -------
    rows : list of dict
        One per time: t, the state, its errors.
    log : dict
        Counts of the kept run and wall-clock seconds of each run.
    """
    runs, seconds = [], []
    for settings in every_settings:
        started = time.perf_counter()
        runs.append(integrate(make_chain(), times, settings))
        seconds.append(round(time.perf_counter() - started, 1))
    rows = []
    for index, instant in enumerate(times):
        kept, *others = [states[index] for states, _ in runs]
        rows.append(
            {
                "t": instant,
                "state": kept,
                "errors": largest_differences(kept, others),
            }
        )
    return rows, {"seconds": seconds, **asdict(runs[0][1])}


def in_two_doubles(values):
    """Split longdouble values into a double and the double remainder, exact together."""
    high = values.astype(np.float64)
    return high, (values - high).astype(np.float64)


def build_dataset(rows, logs, **attributes):
    """Return the Dataset that is written, from the results of `solve_case`."""
    data = xr.Dataset(
        coords={
            "t": ("state", [row["t"] for row in rows]),
            "bead": np.arange(1, rows[0]["state"][0].size + 1),
        },
        attrs={
            **attributes,
            "log": json.dumps(logs),
            "versions": f"numpy {np.__version__}, xarray {xr.__version__}",
            "error_method": "largest difference from two further runs with other substep "
            "sequences, numbers of columns and tolerances",
        },
    )
    meanings = {"relative_displacement": "u_n = x_n - x_{n+1}", "velocity": "x_n'"}
    for index, (name, meaning) in enumerate(meanings.items()):
        high, low = in_two_doubles(np.array([row["state"][index] for row in rows], dtype=REAL))
        attrs = {"long_name": meaning, "units": "1"}
        data[name] = (("state", "bead"), high, attrs)
        data[f"{name}_low"] = (("state", "bead"), low, {"long_name": "what double leaves of it"})
        data[f"{name}_error"] = ("state", [row["errors"][index] for row in rows])
    return data


def read_arguments():
    """Return the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    here = Path(__file__).parent
    parser.add_argument("--output", type=Path, default=here / "chain_reference.nc")
    parser.add_argument(
        "--until", type=float, default=3000.0, help="leave out later states (700: fifteen seconds)"
    )
    return parser.parse_args()


def main():
    """Compute all states and write them."""
    arguments = read_arguments()
    require_extended_precision()
    rows, logs = [], []
    for gamma, times in CASES.items():
        times = [instant for instant in times if instant <= arguments.until]
        case, log = solve_case(lambda gamma=gamma: Chain(gamma), times)
        for row in case:
            row["gamma"] = gamma
            u_error, v_error = row["errors"]
            print(f"gamma {gamma}  t {row['t']:.0f}  error u {u_error:.1e}  velocity {v_error:.1e}")
        rows += case
        logs.append({"gamma": gamma, **log})
        print(log, flush=True)
    data = build_dataset(
        rows,
        logs,
        title="Long-double reference states of the front initiation, James (2021), sec. 3.3",
        source="tests/references/make_chain_reference.py",
        problem="alpha = beta = 3/2, N = 420, delta = 0.1, u_0 = delta, u_N = 0 (free end); "
        "at t = 0 all u_n = 0 and all velocities 0; delta and gamma are the double values",
        settings=json.dumps([asdict(item) for item in (REFERENCE, *CHECKS)]),
    )
    data = data.assign_coords(gamma=("state", [row["gamma"] for row in rows]))
    data["momentum_defect"] = (
        "state",
        [float(momentum_defect(row["t"], row["state"][1])) for row in rows],
    )
    data.to_netcdf(arguments.output)


if __name__ == "__main__":
    main()
