"""Forces and velocities of time: other solvers, the linear response, balances, order, refusals."""

from itertools import pairwise

import numpy as np
import pytest
from chains import TIGHT, driven_scene, given, last_state
from configurations import assert_refused
from rings import slope_and_residual
from scipy.integrate import quad, solve_ivp

from granular_fronts.chain import run
from granular_fronts.chain.drives import make_drive
from granular_fronts.chain.equations import damping_ratio
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.chain.state import D, U
from granular_fronts.errors import InputError
from granular_fronts.scenes.chain import Force, Piston
from granular_fronts.scenes.validation import check_scene

TIMES, VALUES = [1.0, 2.5, 3.0, 6.0], [0.02, 0.1, -0.03, 0.05]
PULSE = {"height": 0.1, "duration": 3.0, "offset": 0.01}
ARCH = {"amplitude": 0.1, "duration": 5.0}
HARMONIC = {"amplitude": 0.05, "angular_frequency": 1.3, "phase": 0.4, "offset": 0.06}
TABLE = {"times": TIMES, "values": VALUES}
# Each drive with its function of time and the times at which that is not smooth.
DRIVES = {
    "pulse": ({"pulse": PULSE}, lambda t: 0.11 if t < 3.0 else 0.01, [3.0]),
    "half_sine": ({"half_sine": ARCH}, lambda t: 0.1 * np.sin(np.pi * min(t, 5.0) / 5.0), [5.0]),
    "harmonic": ({"harmonic": HARMONIC}, lambda t: 0.06 + 0.05 * np.sin(1.3 * t + 0.4), []),
    "table": ({"table": TABLE}, lambda t: np.interp(t, TIMES, VALUES), TIMES),
}
SMOOTH = ["half_sine", "harmonic", "table"]
CASES = [("force", name) for name in DRIVES] + [("velocity", name) for name in SMOOTH]
LAWS = [(1.5, 1.5, 0.3), (1.5, 1.5, 0.0), (1.5, 1.0, 0.3), (1.2, 1.2, 0.3)]


def scene_of(key, drive, law=LAWS[0], right=0.0, beads=12, end_time=12.0, **changes):
    kind = {"force": "force", "velocity": "piston"}[key]
    boundary = {"kind": kind, key: drive, "right": right}
    scene = driven_scene(law[2], beads, end_time, law[0], law[1])
    return scene | {"boundary": boundary} | changes


def by_scipy(scene, function, breaks):
    """u and velocity at the end, in (x, w), from the law (28) and a function of time alone."""
    law, beads, right = scene["law"], scene["beads"], scene["boundary"]["right"]
    piston = scene["boundary"]["kind"] == "piston"

    def forces(x):
        u = np.append(x[:-1] - x[1:], right)
        elastic, viscous = (np.maximum(u, 0.0) ** law[key] for key in ("alpha", "beta"))
        return u, elastic, law["gamma"] * viscous

    def velocities(t, x, w):
        _, _, viscous = forces(x)
        v = w - np.diff(viscous, prepend=viscous[0] if piston else 0.0)
        if piston:
            v[0] = function(t)
        return v

    def slopes(t, state):
        x, w = np.split(state, 2)
        elastic = forces(x)[1]
        behind = elastic[0] if piston else function(t)
        return np.concatenate([velocities(t, x, w), -np.diff(elastic, prepend=behind)])

    x, v = np.zeros(beads), np.zeros(beads)
    state = np.concatenate([x, v - velocities(0.0, x, v)])
    for start, end in pairwise([0.0, *breaks, scene["end_time"]]):
        inside = (start, np.nextafter(end, start))
        state = solve_ivp(slopes, inside, state, "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    x, w = np.split(state, 2)
    return np.concatenate([forces(x)[0], velocities(scene["end_time"], x, w)])


@pytest.mark.parametrize("law", LAWS[:3])
@pytest.mark.parametrize(("key", "name"), CASES)
def test_scipy_agrees_in_positions(key, name, law):
    drive, *reference = DRIVES[name]
    scene = scene_of(key, drive, law, 0.05)
    np.testing.assert_allclose(last_state(scene), by_scipy(scene, *reference), rtol=0, atol=2e-10)


@pytest.mark.parametrize("name", DRIVES)
def test_a_drive_is_its_function_and_its_integral(name):
    given_drive, function, breaks = DRIVES[name]
    boundary = Force(kind="force", force=given_drive)
    drive, times = make_drive(boundary.pieces()), np.linspace(0.0, 10.0, 73)
    exact = [function(t) for t in times]
    np.testing.assert_allclose(drive.value(times), exact, rtol=0, atol=1e-16)
    integral = quad(function, 0.0, 10.0, points=breaks or None, limit=200)[0]
    assert drive.integral(10.0) == pytest.approx(integral, abs=1e-14)
    # Before the first break point.
    change = function(0.9) - function(0.0)
    assert drive.derivative().integral(0.9) == pytest.approx(change, abs=1e-16)
    assert np.abs(exact).max() <= boundary.largest
    assert boundary.at_start == exact[0]


@pytest.mark.parametrize("masses", [12, {"count": 12, "mass": {"cell": [0.7, 0.3]}}])
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("key", "name"), CASES)
def test_balances_close(key, name, law, masses):
    """Momentum grows by the impulse, or bead 1 keeps to V(t); energy by the work of the drive."""
    record = {"snapshots": [], "balances": True}
    scene = scene_of(key, DRIVES[name][0], law, 0.05, beads=masses, record=record)
    drifts = solve(scene, TIGHT).drifts
    assert drifts["momentum_drift"] < 1.0e-13
    assert drifts["energy_drift"] < 5.0e-13


def test_a_force_on_a_column_before_a_wall_does_work():
    """In equilibrium the wall bears the force and the weight, and nothing moves."""
    wall = {"kind": "wall", "force": 0.1}
    still = driven_scene(beads=8, boundary=wall, gravity=0.01, start={"kind": "equilibrium"})
    assert np.abs(last_state(still)[8:]).max() < 1.0e-14
    offset = {"half_sine": {"amplitude": 0.05, "duration": 2.0, "offset": 0.1}}
    hit = still | {"boundary": {"kind": "wall", "force": offset}}
    hit |= {"record": {"snapshots": [], "balances": True}, "end_time": 20.0}
    assert solve(hit, TIGHT).drifts["energy_drift"] < 1.0e-13
    pulled = hit | {"boundary": {"kind": "wall", "force": -0.1}}
    with pytest.raises(InputError, match=r"bear the force -0\.09, which pulls"):
        simulate_chain(pulled)


@pytest.mark.parametrize("force", [0.1**1.5, {"pulse": {"height": 0.1**1.5, "duration": 1e6}}])
@pytest.mark.parametrize("law", LAWS[:3])
def test_a_lasting_force_is_the_pressure_of_its_compression(law, force):
    pressed = driven_scene(law[2], 12, 12.0, law[0], law[1])
    found = last_state(scene_of("force", force, law))
    np.testing.assert_allclose(found, last_state(pressed), rtol=0, atol=1e-14)


def test_a_table_of_two_points_is_a_ramp():
    table = {"table": {"times": [0.0, 5.0], "values": [0.0, 0.05]}}
    ramp = scene_of("velocity", 0.05)
    ramp["boundary"]["ramp"] = 5.0
    np.testing.assert_array_equal(last_state(scene_of("velocity", table)), last_state(ramp))


def test_a_law_that_is_driven_has_slopes_of_its_own_only_where_it_must():
    for key, drive, law, expected in [
        ("velocity", 0.05, LAWS[0], 0.3),
        ("velocity", DRIVES["half_sine"][0], LAWS[0], None),
        ("force", 0.1, LAWS[0], None),
        ("force", 0.1, LAWS[1], 0.0),
    ]:
        part = run.prepare(scene_of(key, drive, law))
        assert damping_ratio(part.law, part.boundary, part.beads) == expected
        assert part.chain.law.single == (expected is not None)


@pytest.mark.parametrize("key", ["force", "velocity"])
def test_a_table_that_samples_a_half_sine_is_of_order_two(key):
    exact = last_state(scene_of(key, DRIVES["half_sine"][0]))
    counts, errors = [8, 16, 32, 64], []
    for count in counts:
        times = np.linspace(0.0, 5.0, count + 1)
        table = {"times": list(times), "values": list(0.1 * np.sin(np.pi * times / 5.0))}
        errors.append(np.abs(last_state(scene_of(key, {"table": table})) - exact).max())
    order, residual = slope_and_residual(counts, errors)
    assert 1.9 < order < 2.1
    assert residual < 0.05


def linear_response(size, damping, omega, count, t):
    """u and velocity of beads joined by springs of stiffness 1.5, at a force ε sin ωt on bead 1."""
    q, rate = np.zeros((2, count))
    modes = np.cos(np.pi * np.outer(np.arange(count) + 0.5, np.arange(count)) / count)
    modes *= np.sqrt(np.where(np.arange(count), 2.0, 1.0) / count)
    q[0], rate[0] = t / omega - np.sin(omega * t) / omega**2, (1.0 - np.cos(omega * t)) / omega
    for k in range(1, count):
        stiff = 6.0 * np.sin(0.5 * np.pi * k / count) ** 2
        gain = 1.0 / (stiff - omega**2 + 1j * omega * damping * stiff)
        root = np.sqrt(stiff - (0.5 * damping * stiff) ** 2 + 0j)
        decays = -0.5 * damping * stiff + 1j * np.array([root, -root])
        free = np.linalg.solve([[1.0, 1.0], decays], [-gain.imag, -omega * gain.real])
        q[k] = (gain * np.exp(1j * omega * t)).imag + (free @ np.exp(decays * t)).real
        rate[k] = (1j * omega * gain * np.exp(1j * omega * t)).imag
        rate[k] += ((free * decays) @ np.exp(decays * t)).real
    x, v = (size * modes @ (modes[0] * part) for part in (q, rate))
    return np.concatenate([x[:-1] - x[1:], v])


def test_a_weak_harmonic_force_gives_the_linear_response_in_closed_form():
    """What is left is of second order in the force, by the curvature of u^{3/2}."""
    sizes, errors = [1e-2, 1e-3, 1e-4], []
    for size in sizes:
        harmonic = {"amplitude": size, "angular_frequency": 0.9, "offset": 1.0}
        scene = scene_of("force", {"harmonic": harmonic}, (1.5, 1.5, 0.1), 1.0, 16, 25.0)
        found = last_state(scene | {"start": {"kind": "equilibrium"}})
        moved = np.delete(found, 15) - np.repeat([1.0, 0.0], [15, 16])
        response = linear_response(size, 0.1, 0.9, 16, 25.0)
        assert np.abs(response).max() > 0.5 * size
        errors.append(np.abs(moved - response).max())
    order, residual = slope_and_residual(np.reciprocal(sizes), errors)
    assert 1.95 < order < 2.05
    assert residual < 0.05


BENT = given(1.0 + 0.3 * np.cos(np.pi * np.arange(11) / 11), [0.0] * 12)


def errors_of_steps(key, drive, counts, power=1.0, end_time=8.0):
    """Errors after steps that end at the times (k/count)^power of the whole."""
    scene = scene_of(key, drive, (1.5, 1.5, 0.1), 0.7, start=BENT, end_time=end_time)
    if key == "velocity":
        scene["start"]["velocity"][0] = Piston(**scene["boundary"]).at_start

    def states(count, power):
        part = run.prepare(scene)
        ends = end_time * (np.arange(1, count + 1) / count) ** power
        run.integrate_in_halves(part, scene["tolerance"], ends)
        return np.concatenate([part.row(U), part.row(D)])

    exact = states(240, 1.0)
    return [np.abs(states(count, power) - exact).max() for count in counts]


@pytest.mark.parametrize(
    ("key", "drive"),
    [
        ("force", {"pulse": {"height": 0.3, "duration": 4.0, "offset": 0.5}}),
        ("force", {"half_sine": {"amplitude": 0.3, "duration": 4.0, "offset": 0.5}}),
        ("velocity", {"half_sine": {"amplitude": 0.3, "duration": 4.0}}),
        ("velocity", {"table": {"times": [0, 2, 4], "values": [0.0, 0.3, 0.1]}}),
    ],
)
def test_order_is_eight_where_steps_meet_break_points(key, drive):
    counts = [12, 16, 20, 24]
    errors = errors_of_steps(key, drive, counts)
    assert errors[-1] > 1.0e-13, "the errors must stand above round-off"
    order, residual = slope_and_residual(counts, errors)
    assert 7.8 < order < 8.2
    assert residual < 0.02
    astride = errors_of_steps(key, drive, counts, 1.05)
    assert min(astride) > 1.0e3 * errors[0], "steps across a break point lose the order"


@pytest.mark.parametrize("law", LAWS[:3])
@pytest.mark.parametrize(("key", "name"), CASES)
def test_stated_errors_bound_true_ones_within_a_factor_of_two(key, name, law):
    record = {"snapshots": [2.0, 4.5, 12.0], "grid": {"step": 0.7}}
    scene = scene_of(key, DRIVES[name][0], law, 0.05, record=record)
    coarse = simulate_chain(scene | {"tolerance": {"relative": 1e-6, "absolute": 1e-8}})
    exact = solve(scene, TIGHT).dataset
    for variable, found in coarse.data_vars.items():
        error = float(np.abs(found - exact[variable]).max())
        # The sum of all velocities is as exact as its law: rounding of both is left.
        assert error < 2.0 * found.attrs["error_estimate"] + 1e-14
        assert found.attrs["error_estimate"] < 1e-4


@pytest.mark.parametrize(("key", "name"), CASES)
def test_states_between_the_ends_of_steps_see_the_drive(key, name):
    """The grid is read from the continuous extension; at snapshots steps end."""
    times = [0.5 * k for k in range(1, 24)]
    scene = scene_of(key, DRIVES[name][0], (1.5, 1.5, 0.1))
    landed = solve(scene | {"record": {"snapshots": times}}, TIGHT).dataset
    read = solve(scene | {"record": {"snapshots": [], "grid": {"step": 0.5}}}, TIGHT).dataset
    for variable in ("relative_displacement", "velocity"):
        between = read[f"{variable}_grid"].sel(t_grid=times).values
        np.testing.assert_allclose(between, landed[variable].values, rtol=0, atol=2e-11)


STILL = {"table": {"times": [0, 1], "values": [0.0, 0.0]}}


@pytest.mark.parametrize(("key", "drive"), [("force", 0.125), ("velocity", STILL)])
def test_a_driven_chain_may_begin_compressed(key, drive):
    """F(0.25) is 0.125: the force holds the balance, as does a piston that rests."""
    scene = scene_of(key, drive, right=0.25, beads=8) | {"start": {"kind": "equilibrium"}}
    np.testing.assert_allclose(last_state(scene), [0.25] * 8 + [0.0] * 8, rtol=0, atol=1e-14)


SINE = {"amplitude": 1.0, "angular_frequency": 1.0}
PUSH = {"kind": "force", "right": 0}
REFUSED = [
    (PUSH, "boundary.force is missing | External force"),
    (PUSH | {"force": {}}, "boundary.force is empty | half_sine"),
    (PUSH | {"force": float("inf")}, "boundary.force is inf | finite"),
    (PUSH | {"force": 1.0e200}, "law.alpha is 1.5 | energies of about 1e+333"),
    (PUSH | {"force": {"square": SINE}}, "boundary.force.square is no key | pulse, half_sine"),
    (PUSH | {"force": {"harmonic": SINE | {"angular_frequency": 0}}}, "frequency is 0 | above 0"),
    (PUSH | {"force": {"harmonic": SINE, "pulse": {"height": 1, "duration": 1}}}, "give one"),
    (PUSH | {"force": {"pulse": {"height": 1, "duration": 0}}}, "pulse.duration is 0 | above 0"),
    (PUSH | {"force": {"table": {"times": [0, 1], "values": [1]}}}, "2 entries, but values has 1"),
    (PUSH | {"force": {"table": {"times": [0, 2, 1], "values": [1] * 3}}}, "(entry 3) is 1 | is 2"),
    (
        PUSH | {"force": {"table": {"times": [-1, 0], "values": [1, 1]}}},
        "(entry 1) is -1",
    ),
    (
        {"kind": "piston", "velocity": {"pulse": {"height": 1, "duration": 1}}},
        "boundary.velocity.pulse jumps | infinite force | table",
    ),
    ({"kind": "piston", "velocity": {"harmonic": SINE}, "ramp": 1}, "boundary.ramp is given"),
    ({"kind": "wall", "left": 0.1, "force": 0.1}, "boundary has left and force"),
]


@pytest.mark.parametrize(("boundary", "words"), REFUSED, ids=[words for _, words in REFUSED])
def test_an_impossible_drive_is_refused_in_a_sentence(boundary, words):
    with pytest.raises(InputError) as caught:
        check_scene("chain", driven_scene(boundary=boundary), "mine")
    assert_refused(str(caught.value), words)
