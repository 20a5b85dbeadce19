"""When chains, and a ball on a plate, first come apart, by Newton's law in SciPy."""

import itertools
import math

import numpy as np
import pytest
from chains import FREE, REST, STRIKER, WALL, driven_scene, given, last_state
from newton import solutions

import granular_fronts as gf
from granular_fronts.scenes.chain import Chain

PRESSED = given([0.1, 0.1, 0.1, 0.1, 0.0], [-1.0, 0.0, 0.0, 0.0, -0.5])
TOUCHING = given([0.0] * 5, [0.0, 0.1, 0.1, -0.1, 0.2])
HELD = {"kind": "pressure", "left": 0.1, "right": 0.1}
PULL = {"pulse": {"height": -0.1, "duration": 2.0}}
LAWS = [(1.5, 1.0, 0.2), (1.5, 1.25, 0.3), (1.5, 1.5, 0.1), (1.5, 2.5, 1.0), (1.0, 1.0, 0.4)]
BALL, LOAD = given([0.0], [1.0]), 0.05
END, SOON, ROUNDING = 8.0, 1.0e-6, 1.0e-14


def first_gap(scene):
    """Time and contact of the first opening and its u̇, NaN from rest; the state at the end."""
    checked = Chain.read(scene)

    def opens(n):
        event = lambda t, state: state[n]  # noqa: E731 - SciPy wants an attribute of a function
        event.direction = -1.0
        return event

    options = {"rtol": 1.0e-12, "atol": 1.0e-14, "max_step": 0.1, "first_step": SOON}
    contacts = range(checked.contact_count)
    found = solutions(checked, events=[opens(n) for n in contacts], **options)
    u, soon = found[0].y[: len(contacts), :2].T
    gaps = [(0.0, n, found[0].y[:, 0]) for n in contacts if u[n] == 0.0 and soon[n] < -ROUNDING]
    for part, n in itertools.product(found, contacts):
        events = zip(part.t_events[n], part.y_events[n], strict=True)
        gaps += [(t, n, y) for t, y in events if t > SOON]
    time, n, state = min(gaps, key=lambda gap: gap[:2])
    velocity = state[len(contacts) :]
    ahead = np.append(velocity[1:], velocity[0] if checked.boundary.kind == "ring" else 0.0)
    return time, 1 + n, (velocity - ahead)[n] or math.nan, found[-1].y[:, -1]


def scene_of(law, boundary, start, gravity, **changes):
    alpha, beta, gamma = law
    count = len(start["velocity"]) if start["kind"] == "given" else 5
    scene = driven_scene(gamma, count, END, alpha, beta, boundary=boundary, start=start)
    scene["record"] |= {"extremes": True, "balances": True}
    return scene | {"gravity": gravity} | changes


HERTZ, UNDAMPED = LAWS[2], (1.5, 1.5, 0.0)


@pytest.mark.parametrize(
    ("law", "boundary", "start", "gravity"),
    [
        (HERTZ, WALL, STRIKER, 0.0),
        (UNDAMPED, WALL, PRESSED, 0.0),
        (HERTZ, WALL, TOUCHING, 0.0),
        (HERTZ, WALL, REST, -0.1),
        (HERTZ, WALL | {"left": 0.1}, TOUCHING, 0.05),
        (UNDAMPED, HELD, STRIKER, 0.0),
        (HERTZ, HELD, PRESSED, 0.0),
        (HERTZ, HELD, TOUCHING, 0.0),
        (HERTZ, {"kind": "ring"}, PRESSED, 0.0),
        (UNDAMPED, {"kind": "ring"}, TOUCHING, 0.0),
        (HERTZ, {"kind": "force", "force": PULL, "right": 0.0}, REST, 0.0),
        *((law, WALL, BALL, load) for law in LAWS for load in (0.0, LOAD)),
    ],
)
def test_the_first_gap_is_that_of_newtons_law(law, boundary, start, gravity):
    if start["kind"] == "given" and "right" in boundary:
        start = start | {"relative_displacement": start["relative_displacement"][:-1]}
    scene = scene_of(law, boundary, start, gravity)
    motion, (time, contact, velocity, last) = gf.simulate_chain(scene), first_gap(scene)
    assert float(motion["first_gap_time"]) == pytest.approx(time, abs=1.0e-10)
    assert int(motion["first_gap_bead"]) == contact
    rate = float(motion["first_gap_velocity"])
    assert rate == pytest.approx(velocity, abs=1.0e-8, nan_ok=True)
    u = motion["relative_displacement"].values[0, : motion.attrs["contacts"]]
    np.testing.assert_allclose([*u, *motion["velocity"].values[0]], last, rtol=0, atol=1.0e-9)
    assert motion.attrs["energy_drift"] < 1.0e-11


def test_a_pull_that_sets_in_later_opens_the_first_contact_then():
    late = {"pulse": {"height": 0.1, "duration": 1.0, "offset": -0.1}}
    scene = driven_scene(0.1, 5, 3.0, boundary={"kind": "force", "force": late, "right": 0.0})
    motion = gf.simulate_chain(scene | {"record": {"snapshots": [], "extremes": True}})
    assert (motion["first_gap_time"], motion["first_gap_bead"]) == (1.0, 1.0)


def test_a_contact_that_separates_from_touch_exerts_nothing():
    """With β = 1 its dashpot would pull: G'(u) is γ on one side of 0, and 0 on the other."""
    sensors = {"between": {"contacts": [1], "start": 0.0, "stop": 1.0, "step": 0.5}}
    record = {"snapshots": [1.0], "sensors": sensors}
    for speed, force in ((-1.0, 0.0), (1.0, 0.3)):
        start = given([0.0], [speed, 0.0])
        scene = driven_scene(0.3, 2, 1.0, beta=1.0, boundary=FREE, start=start, record=record)
        assert gf.simulate_chain(scene)["contact_force_between"].values[0] == force


@pytest.mark.parametrize("mass", [1.0, 1.0e-2])
@pytest.mark.parametrize("t", [1.0e-10, 1.0e-7])
def test_the_rounding_of_velocities_is_that_of_what_they_are_made_from(t, mass):
    """At first ẋ = w + G/m is the small difference of two numbers of size γδ^β/m, eq. (31)."""
    beads = {"count": 20, "mass": {"impurity": {"bead": 1, "mass": mass}}}
    scene = driven_scene(beads=beads, end_time=1.0, record={"snapshots": [t]})
    velocity = gf.simulate_chain(scene)["velocity"]
    exact = 0.1**1.5 * t / mass  # The next term is smaller by t.
    assert abs(float(velocity[0, 0]) - exact) <= 2.0 * velocity.attrs["error_estimate"]


@pytest.mark.parametrize("law", LAWS)
def test_two_beads_lose_what_a_ball_on_a_plate_does(law):
    """By the reduced mass 1/2 of James (2021), remark 6, γ of two is smaller by a power of 2."""
    alpha, beta, gamma = law
    e = gf.restitution(gamma / 2.0 ** (1.0 - beta / (alpha + 1.0)), alpha, beta)
    motion = gf.simulate_chain(scene_of(law, WALL, BALL, 0.0))
    for velocity, least in (motion["first_gap_velocity"], 1.0e-9), (motion["velocity"], 1.0e-13):
        assert abs(velocity.item() + e) <= 2.0 * velocity.attrs["error_estimate"] < 2.0 * least


def test_a_ball_that_sticks_settles_where_the_plate_bears_it():
    record = {"snapshots": [200.0], "extremes": True}
    scene = scene_of((1.5, 1.0, 2.0), WALL, BALL, LOAD, end_time=200.0, record=record)
    motion = gf.simulate_chain(scene)
    assert np.isnan(motion["first_gap_velocity"])
    assert motion["relative_displacement"].item() == pytest.approx(LOAD ** (1.0 / 1.5), abs=1.0e-9)


@pytest.mark.parametrize("beads", [1, 3])
def test_all_beads_of_a_striker_may_hit_a_wall(beads):
    listed = scene_of(HERTZ, WALL, given([0.0] * beads, [1.0] * beads), 0.0)
    thrown = listed | {"start": STRIKER | {"beads": beads}}
    assert np.array_equal(last_state(thrown), last_state(listed))
