"""When a chain first comes apart, by Newton's law in SciPy, whatever holds it and starts it."""

import numpy as np
import pytest
from chains import FREE, REST, STRIKER, WALL, driven_scene, given
from newton import solutions

import granular_fronts as gf
from granular_fronts.scenes.chain import Chain

PRESSED = given([0.1, 0.1, 0.1, 0.1, 0.0], [-1.0, 0.0, 0.0, 0.0, -0.5])
TOUCHING = given([0.0] * 5, [0.0, 0.1, 0.1, -0.1, 0.2])
HELD = {"kind": "pressure", "left": 0.1, "right": 0.1}
PULL = {"pulse": {"height": -0.1, "duration": 2.0}}
SOON, ROUNDING = 1.0e-6, 1.0e-14


def first_gap(scene):
    """Time and contact of the first opening."""
    checked = Chain.read(scene)

    def opens(n):
        event = lambda t, state: state[n]  # noqa: E731 - SciPy wants an attribute of a function
        event.direction = -1.0
        return event

    options = {"rtol": 1.0e-10, "atol": 1.0e-12, "max_step": 0.05, "first_step": SOON}
    events = [opens(n) for n in range(checked.contact_count)]
    found = solutions(checked, events=events, **options)
    times = np.array(
        [
            min((t for part in found for t in part.t_events[n] if t > SOON), default=np.inf)
            for n in range(checked.contact_count)
        ]
    )
    u, soon = found[0].y[: checked.contact_count, :2].T
    times[(u == 0.0) & (soon < -ROUNDING)] = 0.0
    return times.min(), 1 + int(times.argmin())


@pytest.mark.parametrize(
    ("boundary", "start", "gravity", "gamma"),
    [
        (WALL, STRIKER, 0.0, 0.1),
        (WALL, PRESSED, 0.0, 0.0),
        (WALL, TOUCHING, 0.0, 0.1),
        (WALL, REST, -0.1, 0.1),
        (WALL | {"left": 0.1}, TOUCHING, 0.05, 0.1),
        (HELD, STRIKER, 0.0, 0.0),
        (HELD, PRESSED, 0.0, 0.1),
        (HELD, TOUCHING, 0.0, 0.1),
        ({"kind": "ring"}, PRESSED, 0.0, 0.1),
        ({"kind": "ring"}, TOUCHING, 0.0, 0.0),
        ({"kind": "force", "force": PULL, "right": 0.0}, REST, 0.0, 0.1),
    ],
)
def test_the_first_gap_is_that_of_newtons_law(boundary, start, gravity, gamma):
    if start["kind"] == "given" and "right" in boundary:
        start = start | {"relative_displacement": start["relative_displacement"][:-1]}
    scene = driven_scene(gamma, 5, 8.0, boundary=boundary, start=start)
    scene |= {"gravity": gravity, "record": {"snapshots": [8.0], "extremes": True}}
    motion, (time, contact) = gf.simulate_chain(scene), first_gap(scene)
    assert float(motion["first_gap_time"]) == pytest.approx(time, abs=1.0e-7)
    assert int(motion["first_gap_bead"]) == contact


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
