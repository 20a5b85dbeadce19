"""Sensors: Newton's law at a bead, and what passes a contact, against references."""

import itertools

import numpy as np
import pytest
from chains import FREE, REST, STRIKER, TODA, WALL, driven_scene, given
from scipy.integrate import simpson
from scipy.interpolate import make_interp_spline

import granular_fronts as gf
from granular_fronts.chain.patterns import values_along
from granular_fronts.reference_methods.extended import Motion
from granular_fronts.scenes.beads import Masses

MASSES = {"count": 12, "mass": {"cell": [0.8, 0.4, 2.0]}}
MASS = values_along(Masses(**MASSES["mass"]), 12)
WAVE = given(0.5 + 0.2 * np.cos(np.arange(12)), 0.1 * np.sin(np.arange(12)))
FACTORS = {"elastic": {"cell": [1.0, 2.0]}, "viscous": {"taper": {"ratio": 1.1}}}
ELASTIC = {"alpha": 1.5, "beta": 1.5, "gamma": 0.0}
HALF_SINE = {"half_sine": {"amplitude": 0.4, "duration": 9.0}}
PASSING = ("momentum", "energy")


def sensed(sensor, end=8.0, **changes):
    """A motion of twelve beads behind a striker, with a sensor `one`."""
    sensor = {"start": 0.0, "stop": end, "step": 0.02} | sensor
    record = {"snapshots": [], "sensors": {"one": sensor}}
    scene = {"beads": MASSES, "boundary": FREE, "start": STRIKER, "record": record}
    return driven_scene(0.2, end_time=end) | scene | changes


@pytest.mark.parametrize(
    ("inside", "changes"),
    [
        ([1, 11], {"boundary": {"kind": "pressure", "left": 0.3, "right": 0.2}, "start": REST}),
        ([1, 12], {"boundary": {"kind": "wall", "left": 0.1}, "gravity": 0.05, "start": REST}),
        ([1, 12], {"boundary": {"kind": "ring"}, "start": WAVE}),
        ([1, 2], {"boundary": {"kind": "piston", "velocity": 0.4, "ramp": 9.0}, "start": REST}),
        ([1, 3], {"boundary": {"kind": "force", "force": HALF_SINE}, "start": REST}),
        ([1, 3], {"law": {"alpha": 1.5, "beta": 2.5, "gamma": 0.3}}),
        ([1, 3], {"contacts": FACTORS}),
    ],
    ids=["pressure", "wall", "ring", "piston", "force", "exponents", "factors"],
)
def test_forces_on_both_sides_accelerate_the_bead(inside, changes):
    """m ẍ = T_(n−1) − T_n + m g, with the mean from the sensor and ẍ from a spline through ẋ."""
    motion = gf.simulate_chain(sensed({"contacts": inside, "beads": inside}, **changes))
    mean, ahead = motion["bead_force_one"].values, motion["contact_force_one"].values
    newton = 2.0 * (mean - ahead) / MASS[np.subtract(inside, 1)]
    newton += changes.get("gravity", 0.0)
    times = motion["t_one"].values
    acceleration = make_interp_spline(times, motion["velocity_one"].values, 7).derivative()(times)
    difference = np.abs(newton - acceleration)[10:-10]
    assert (np.abs(newton).max(axis=0) > 0.02).all()
    # Where a contact closes or opens forces have kinks, which no spline follows.
    assert np.median(difference) < 1.0e-9
    assert np.quantile(difference, 0.9) < 1.0e-4


@pytest.mark.parametrize("boundary", [WALL, {"kind": "ring"}], ids=["wall", "ring"])
def test_what_passes_a_contact_is_the_integral_of_its_force(boundary):
    """∫ T dt and ∫ T ẋ_(n+1) dt by Simpson's rule, of order 4; all beads move from the start.

    A wall takes momentum from the beads beyond, and the contact that closes a ring energy too.
    """
    scene, errors = {"law": TODA, "boundary": boundary}, []
    scene |= {"contacts": {"elastic": {"cell": [1.0, 2.0]}}}
    scene |= {"start": given([0.0] * 12, [1.1] + [0.1] * 11)}
    for step in (0.1, 0.05, 0.025):
        sensor = {"contacts": [3, 12], "beads": [4, 12], "step": step}
        motion = gf.simulate_chain(sensed(sensor, 6.0, **scene))
        force, last = motion["contact_force_one"].values.T
        velocity, of_last = motion["velocity_one"].values.T
        gained = [float(motion[f"transmitted_{name}_one"][-1, 0]) for name in PASSING]
        at_end = of_last if boundary["kind"] == "ring" else 0.0
        rates = force - last, force * velocity - last * at_end
        passed = [simpson(rate, x=motion["t_one"]) for rate in rates]
        errors.append(np.abs(np.subtract(passed, gained)))
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert (orders > 3.5).all()
    assert np.abs(gained).min() > 0.05
    late = gf.simulate_chain(sensed(sensor | {"start": 5.0}, 6.0, **scene))
    for name, value in zip(PASSING, gained, strict=True):
        assert float(late[f"transmitted_{name}_one"][-1, 0]) == pytest.approx(value, rel=1e-12)


def test_energy_of_a_slow_bead_behind_a_fast_one_keeps_its_digits():
    """A piston has hardly moved; the energy beyond the contact is that of bead 2 alone."""
    sensor = {"contacts": [1], "beads": [2], "stop": 0.001, "step": 0.001}
    scene = sensed(
        sensor, 0.001, law=ELASTIC | {"gamma": 0.0}, boundary={"kind": "piston", "velocity": 1.0}
    )
    motion = gf.simulate_chain(scene | {"beads": 2, "start": {"kind": "rest"}})
    energy = motion["transmitted_energy_one"].values[-1, 0]
    assert energy == pytest.approx(
        0.5 * motion["velocity_one"].values[-1, 0] ** 2, rel=1e-14, abs=0.0
    )


@pytest.mark.parametrize(
    "law", [ELASTIC | {"gamma": 0.2}, ELASTIC | {"beta": 1.0, "gamma": 0.1}, TODA]
)
def test_stated_errors_are_within_a_factor_of_two(law):
    """Against the reference in extended precision, with forces and sums from its states."""
    # For β = 1 the force jumps at the impact, at t = 0.
    sensor = {"contacts": [1, 6, 9], "beads": [3, 12], "start": 0.05, "step": 0.37}
    scene = sensed(sensor, law=law)
    motions = [
        gf.simulate_chain(scene | {"tolerance": {"relative": asked, "absolute": 1e-2 * asked}})
        for asked in (1e-5, 1e-8, 1e-11)
    ]
    reference = Motion(scene)
    u, velocity = (of.astype(float) for of in reference.states(motions[0]["t_one"].values))
    made, mass = gf.make_law(**law), reference.mass.astype(float)
    force = -made.elastic.first(-u) - made.viscous.second(-u) * np.diff(velocity, axis=1)
    energy = 0.5 * mass * velocity**2 + np.pad(made.elastic.value(-u), ((0, 0), (0, 1)))
    both = np.pad(force, ((0, 0), (1, 1)))
    true = {
        "contact_force": force,
        "bead_force": 0.5 * (both[:, 1:] + both[:, :-1]),
        "velocity": velocity,
        "transmitted_momentum": np.cumsum((mass * velocity)[:, ::-1], axis=1)[:, -2::-1],
        "transmitted_energy": np.cumsum(energy[:, ::-1], axis=1)[:, -2::-1],
    }
    for motion, (name, values) in itertools.product(motions, true.items()):
        found = motion[f"{name}_one"]
        error = np.abs(found.values - values[:, found[found.dims[1]].values - 1]).max()
        assert error <= 2.0 * found.attrs["error_estimate"] + 1e-14
