"""Materials, damping regimes and pistons against closed formulas and each other."""

import math

import numpy as np
import pandas as pd
import pytest
from chains import driven_scene
from configurations import DEFAULT, refusal, set_value
from potentials import hertz
from tabulate_materials import tabulate_materials

import granular_fronts as gf
from granular_fronts.output.datasets import write_dataset
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.damping_regimes import evaluate_regimes
from granular_fronts.studies.materials import evaluate_materials
from granular_fronts.studies.pistons import limit, measure_pistons, push_chain, repetition

TIGHT = {"relative": 1.0e-12, "absolute": 1.0e-14}


@pytest.fixture(scope="module")
def given():
    return load_configuration(DEFAULT)["laws"]["materials"]


@pytest.fixture(scope="module")
def materials(given):
    return evaluate_materials(**given)


def test_materials_are_consistent(materials, given):
    for material in materials["material"].values:
        one, mass = materials.sel(material=material), given["beads"][material]["mass"]
        law = float(one["stiffness"]), float(one["contact_damping"])
        scaled = gf.Scaling(mass, *law, given["impact_velocity"])
        assert scaled.gamma == pytest.approx(float(one["gamma"]), rel=1e-12)
        e, printed = float(one["restitution"]), float(one["gamma_printed"])
        assert gf.restitution(float(one["gamma"])) == pytest.approx(e, rel=1e-12)
        assert gf.restitution(printed) == pytest.approx(float(one["restitution_exact"]), rel=1e-12)
        # The linear rule is right for weak damping and too low otherwise.
        assert printed < float(one["gamma"])
        assert abs(float(one["gamma"]) / printed - 1.0) < 3.0 * (1.0 - e)


def test_front_damping_scales_with_the_velocity_and_hardly_with_the_stiffness(materials, given):
    """γ ∝ k^(−1/15) at a given force: a modulus known to a few per cent is good enough."""
    ratio = materials["gamma_front_piston"] / materials["gamma"]
    expected = (materials["piston_velocity"] / given["impact_velocity"]) ** 0.2
    np.testing.assert_allclose(ratio, expected.broadcast_like(ratio), rtol=1e-12)
    beads = given["beads"]["cork"]
    found = evaluate_materials({"ptfe": beads, "cork": beads}, 0.5, [1.0], [100.0])
    stiff, soft = found["gamma_front_force"].values[:, 0]
    ratio = np.divide(*found["stiffness"].values)
    assert soft / stiff == pytest.approx(ratio ** (1.0 / 15.0), rel=1e-12)


def test_table_names_the_regime_of_each_front(materials, tmp_path):
    csv, markdown = tmp_path / "materials.csv", tmp_path / "materials.md"
    write_dataset(materials, tmp_path / "data.nc", scene_id="materials", config={})
    tabulate_materials(tmp_path / "data.nc", csv, markdown)
    table = pd.read_csv(csv)
    oscillates = table["gamma_of_front"] < gf.critical_damping(1.5)
    assert list(table["regime"] == "underdamped") == list(oscillates)
    assert 0 < oscillates.sum() < len(table)
    critical = float(materials["critical_gamma"])
    for gamma, complex_root in ((0.999 * critical, True), (1.001 * critical, False)):
        assert (gf.tail_roots(1.5, gamma, count=1)[0].imag > 0.0) == complex_root


def test_regimes_follow_equation_29():
    found = evaluate_regimes(1.5, [1.0, 1.25, 1.5, 2.5], 2.0, 5)
    slopes = np.diff(np.log(found["gamma"])) / np.diff(np.log(found["velocity_ratio"]))
    for beta, slope in zip(found["beta"].values, slopes, strict=True):
        np.testing.assert_allclose(slope, 2.0 * beta / 2.5 - 1.0, atol=1e-14)
    np.testing.assert_allclose(found["gamma"].sel(velocity_ratio=1.0, method="nearest"), 1.0)
    critical = found["critical_gamma"]
    assert float(critical.sel(beta=1.5)) == gf.critical_damping(1.5)
    np.testing.assert_allclose(critical * critical["beta"], 1.5 * gf.critical_damping(1.5))
    e = found["restitution"]
    assert np.all(np.diff(e.sel(beta=2.5)) < 0.0)
    assert np.all(np.diff(e.sel(beta=1.0)) >= 0.0)
    assert np.all(np.diff(e.sel(beta=1.25)) == 0.0)


QUANTITIES = ("speed", "compression", "velocity")
PUSHED = [(1.5, 1.5, 0.3), (1.5, 1.5, 0.65), (1.5, 1.0, 0.3), (1.5, 2.5, 5.0), (2.0, 2.0, 0.3)]


@pytest.mark.parametrize("ramp", [0.0, 2.0, 10.0])
@pytest.mark.parametrize("law", PUSHED)
def test_piston_drives_a_front_of_equations_22_and_23(law, ramp):
    """δ, v_p and c of eqs. (22), (23), whatever the damping, at once or by a ramp."""
    velocity, power = 0.05, 2.0 / (law[0] + 1.0)
    front = push_chain(named(law), velocity, ramp, 320, TIGHT)
    assert front.expected_compression == pytest.approx(velocity**power, rel=1e-14)
    assert front.expected_speed == pytest.approx(velocity ** (1.0 - power), rel=1e-14)
    assert front.expected_velocity == pytest.approx(velocity, rel=1e-14)
    for quantity in QUANTITIES:
        measured, expected = getattr(front, quantity), getattr(front, f"expected_{quantity}")
        assert abs(measured.value - expected) < measured.error < 1e-4
    assert front.velocity_drift < 1e-13


def named(law):
    return dict(zip(("alpha", "beta", "gamma"), law, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("ramp", [0.0, 10.0])
def test_speed_of_a_long_driven_chain(ramp):
    front = push_chain(named(PUSHED[0]), 0.05, ramp, 1280, TIGHT)
    assert abs(front.speed.value - front.expected_speed) < front.speed.error < 1e-6


@pytest.mark.parametrize("alpha", [1.1, 1.5, 2.0, 3.0])
def test_reflection_at_a_front_is_the_repetition_to_the_power_minus_two(alpha):
    """The jump conditions with a front a little stronger: v' over u', then its reflection."""
    step = 1e-5
    weak, strong = (
        gf.jump_conditions(hertz(alpha), -delta, 0.0) for delta in (1.0 - step, 1.0 + step)
    )
    slope = (strong.velocity_behind - weak.velocity_behind) / (2.0 * step)
    sound = gf.jump_conditions(hertz(alpha), -1.0, 0.0).sound_minus
    reflection = (slope - sound) / (slope + sound)
    assert reflection == pytest.approx(repetition(alpha) ** -2, rel=1e-6)
    assert (sound + 1.0) / (sound - 1.0) == pytest.approx(repetition(alpha), rel=1e-12)


def test_slowness_repeats_itself_with_the_opposite_sign():
    """In a driven chain, 1/c of the front differs from (23) by an s with s(λn) = −s(n)/λ²."""
    scene = {
        "law": named(PUSHED[0]),
        "beads": 801,
        "boundary": {"kind": "piston", "velocity": 0.05, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": 760.0 / 0.05**0.2,
        "tolerance": TIGHT,
        "record": {"snapshots": [], "arrival_level": 0.5 * 0.05**0.8},
    }
    arrivals = gf.simulate_chain(scene)["arrival_time"].values * 0.05**0.2
    disturbance = np.diff(arrivals) - 1.0
    near = np.array([60, 70])
    far = np.round(repetition(1.5) * near).astype(int)
    ratios = disturbance[far] / disturbance[near]
    assert limit(3.0 - 0.5 / repetition(1.5) ** 2, 3.5, 1.5) == pytest.approx(3.0, rel=1e-15)
    np.testing.assert_allclose(ratios, -(repetition(1.5) ** -2), rtol=0.05)


def dissipated_power(start, beta, gamma, samples=16):
    """Power lost in a chain driven with δ = c = 1, averaged over the time 1/c."""
    scene = driven_scene(gamma, int(1.2 * start) + 20, start + 1.0, beta=beta, delta=1.0)
    scene["record"] = {"snapshots": list(start + np.arange(samples) / samples)}
    motion = gf.simulate_chain(scene)
    u = np.maximum(motion["relative_displacement"].values[:, :-1], 0.0)
    rate = np.diff(motion["velocity"].values, axis=1)
    return float((beta * gamma * u ** (beta - 1.0) * rate**2).sum(axis=1).mean())


def test_front_dissipates_what_the_jump_conditions_say():
    """Σ W''(δ⁺x) (δ⁺ẋ)², averaged over the passage of one bead, is cS whatever W (16)."""
    expected = gf.jump_conditions(hertz(1.5), -1.0, 0.0).dissipated_power
    assert expected == pytest.approx(0.1, rel=1e-14)
    early, late = (dissipated_power(time, beta=2.5, gamma=0.4) for time in (120.0, 240.0))
    # What the sudden start leaves behind dies out as t^(-2).
    assert (4.0 * late - early) / 3.0 == pytest.approx(expected, rel=5e-4)
    assert abs(late / expected - 1.0) < 1.3e-3


def test_pistons_are_gathered():
    cases = {
        "one": {"alpha": 1.5, "beta": 1.5, "gamma": 0.3},
        "two": {"alpha": 1.2, "beta": 1.2, "gamma": 0.5},
    }
    found = measure_pistons(cases, 0.2, [0, 3], 64, {"relative": 1e-9, "absolute": 1e-12})
    assert list(found["law"].values) == ["one", "two"]
    assert list(found["ramp"].values) == [0.0, 3.0]
    expected = [[0.2 ** (0.5 / 2.5)] * 2, [0.2 ** (0.2 / 2.2)] * 2]
    np.testing.assert_allclose(found["front_speed_expected"], expected, rtol=1e-14)
    for name in ("front_speed", "compression_behind", "velocity_behind"):
        assert math.isfinite(found[name].error_estimate)
        np.testing.assert_allclose(found[name], found[f"{name}_expected"], rtol=0.05)


@pytest.mark.parametrize(
    ("path", "value", "limit"),
    [
        ("laws.materials.beads.cork.gamma", 0.438, "below 0.438"),
        ("laws.numerical_damping.profile.theta", 0.5, "above 0.5"),
    ],
)
def test_impossible_parameter_is_refused(path, value, limit):
    sentence = refusal(set_value(load_configuration(DEFAULT), path, value))
    assert f"{path.rpartition('.')[2]} is {value}, but must be {limit}" in sentence
