"""Forces and velocities of time: their functions, order and errors."""

import numpy as np
import pytest
from chains import TIGHT, after_steps, driven_scene, given, last_state
from newton import newton
from rings import slope_and_residual
from scipy.integrate import quad

from granular_fronts.chain.drives import make_drive
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.errors import InputError
from granular_fronts.scenes.chain import Force, Piston

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


def scene_of(key, drive, gamma=0.3, right=0.0, beads=12, end_time=12.0, **changes):
    kind = {"force": "force", "velocity": "piston"}[key]
    boundary = {"kind": kind, key: drive, "right": right}
    return driven_scene(gamma, beads, end_time, boundary=boundary) | changes


@pytest.mark.parametrize("name", DRIVES)
def test_a_drive_is_its_function_and_its_integral(name):
    given_drive, function, breaks = DRIVES[name]
    boundary = Force(kind="force", force=given_drive)
    drive, times = make_drive(boundary.pieces()), np.append(np.linspace(0.0, 10.0, 73), breaks)
    exact = [function(t) for t in times]
    np.testing.assert_allclose(drive.value(times), exact, rtol=0, atol=1e-16)
    integral = quad(function, 0.0, 10.0, points=breaks or None, limit=200)[0]
    assert drive.integral(10.0) == pytest.approx(integral, abs=1e-14)
    # Before the first break point.
    change = function(0.9) - function(0.0)
    assert drive.derivative().integral(0.9) == pytest.approx(change, abs=1e-16)
    assert np.abs(exact).max() <= boundary.largest
    assert boundary.at_start == exact[0]


def test_a_wall_bears_the_force_and_the_weight_of_a_column():
    wall = {"kind": "wall", "force": 0.1}
    still = driven_scene(beads=8, boundary=wall, gravity=0.01, start={"kind": "equilibrium"})
    assert np.abs(last_state(still)[8:]).max() < 1.0e-14
    with pytest.raises(InputError, match=r"bear the force -0\.09, which pulls"):
        simulate_chain(still | {"boundary": {"kind": "wall", "force": -0.1}})


def test_a_table_of_two_points_is_a_ramp():
    table = {"table": {"times": [0.0, 5.0], "values": [0.0, 0.05]}}
    ramp = scene_of("velocity", 0.05)
    ramp["boundary"]["ramp"] = 5.0
    np.testing.assert_array_equal(last_state(scene_of("velocity", table)), last_state(ramp))


@pytest.mark.parametrize("key", ["force", "velocity"])
def test_the_right_end_ahead_of_a_drive_is_free_by_default(key):
    scene = scene_of(key, 0.05)
    free = last_state(scene)
    del scene["boundary"]["right"]
    np.testing.assert_array_equal(last_state(scene), free)


BENT = given(1.0 + 0.3 * np.cos(np.pi * np.arange(11) / 11), [0.0] * 12)


def errors_of_steps(key, drive, counts, power=1.0, end_time=8.0):
    """Errors after steps that end at the times (k/count)^power of the whole."""
    scene = scene_of(key, drive, 0.1, 0.7, start=BENT, end_time=end_time)
    if key == "velocity":
        scene["start"]["velocity"][0] = Piston(**scene["boundary"]).at_start

    def states(count, power):
        return after_steps(scene, end_time * (np.arange(1, count + 1) / count) ** power)

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


@pytest.mark.parametrize(
    ("key", "name"),
    [("force", "pulse"), ("force", "harmonic"), ("velocity", "half_sine"), ("velocity", "table")],
)
def test_a_driven_chain_moves_by_newtons_law_and_is_within_twice_its_stated_error(key, name):
    """At snapshots steps end; the grid is read from the continuous extension between them."""
    record = {"snapshots": [2.0, 4.5, 12.0], "grid": {"step": 0.7}}
    scene = scene_of(key, DRIVES[name][0], right=0.05, record=record)
    coarse = simulate_chain(scene | {"tolerance": {"relative": 1e-6, "absolute": 1e-8}})
    exact = solve(scene, TIGHT).dataset
    for variable, found in coarse.data_vars.items():
        error = float(np.abs(found - exact[variable]).max())
        # The sum of all velocities is as exact as its law: rounding of both is left.
        assert error < 2.0 * found.attrs["error_estimate"] + 1e-14
        assert found.attrs["error_estimate"] < 1e-4
    np.testing.assert_allclose(last_state(scene), newton(scene), rtol=0, atol=1e-9)
    landed = solve(scene | {"record": {"snapshots": list(exact["t_grid"].values)}}, TIGHT).dataset
    for variable in ("relative_displacement", "velocity"):
        between, at_ends = exact[f"{variable}_grid"].values, landed[variable].values
        np.testing.assert_allclose(between, at_ends, rtol=0, atol=2e-11)


STILL = {"table": {"times": [0, 1], "values": [0.0, 0.0]}}


@pytest.mark.parametrize(("key", "drive"), [("force", 0.125), ("velocity", STILL)])
def test_a_driven_chain_may_begin_compressed(key, drive):
    """F(0.25) is 0.125: the force holds the balance, as does a piston that rests."""
    scene = scene_of(key, drive, right=0.25, beads=8) | {"start": {"kind": "equilibrium"}}
    np.testing.assert_allclose(last_state(scene), [0.25] * 8 + [0.0] * 8, rtol=0, atol=1e-14)


def test_a_piston_drives_a_front_of_equations_22_and_23():
    """A piston of velocity V is followed by beads of v_p = V; its start leaves waves of n^(−2)."""
    delta, speed = 0.05**0.8, 0.05**0.2
    record = {"snapshots": [300.0 / speed], "arrival_level": 0.5 * delta}
    motion = simulate_chain(
        scene_of("velocity", 0.05, beads=330, end_time=300.0 / speed, record=record)
    )
    behind = motion.isel(t=0).sel(bead=75)
    assert float(behind["velocity"]) == pytest.approx(0.05, rel=5e-6)
    assert float(behind["relative_displacement"]) == pytest.approx(delta, rel=5e-6)
    assert float(motion["front_speed"]) == pytest.approx(speed, rel=5e-6)
