"""Campaigns of rings: their points, and the paper's two runs."""

import numpy as np
import pytest
from rings import scene_with

from campaigns import PULSE, RINGS, campaign, merged, solved_points
from granular_fronts.campaign.ring_points import make_ring
from granular_fronts.studies.ring_against_equations import compare_with_chain
from granular_fronts.studies.ring_limit import compare


def solved(given=RINGS, **changes):
    return solved_points(campaign(given, **changes))


WAVE = {"alpha": 1.2, "delta": 1.0, "damping": 0.5, **PULSE}


def test_points_are_the_rings_of_the_study_whichever_axis_is_fast():
    found = solved()
    assert not found.reasons.any()
    errors = dict.fromkeys(found.values, np.nan)
    for line, alpha in enumerate([1.1, 1.2]):
        ring = make_ring(WAVE | {"alpha": alpha}, RINGS["start"])
        expected = compare(ring, np.array([0.2, 0.5]), 1e-6)
        assert set(expected) == set(found.values)
        for name, (value, error) in expected.items():
            np.testing.assert_array_equal(found.values[name][line], value)
            errors[name] = np.fmax(errors[name], np.fmax.reduce(error))
    assert errors == pytest.approx(dict(found.errors), nan_ok=True)
    assert all(found.errors[name] < 1e-4 for name in found.errors if name.startswith("disp"))
    turned = solved(axes=dict(reversed(RINGS["axes"].items())))
    for name, value in found.values.items():
        np.testing.assert_array_equal(value, turned.values[name].T)


def test_a_ring_depends_on_alpha_and_damping_alone():
    """γ at another δ with the same γc, James (2021), eq. (30), and every other way to say it."""
    ring = make_ring(WAVE, RINGS["start"])
    scales = ring.scaling
    numbers = {"epsilon": scales.epsilon, "ratio": scales.ratio, "mu": scales.dispersion**-0.5}
    for name, value in {"gamma": 0.5 / 4.0**0.1, **numbers}.items():
        other = make_ring({"alpha": 1.2, "delta": 4.0, name: value, **PULSE}, RINGS["start"])
        assert other.damping == pytest.approx(0.5, rel=1e-14)
        force = other.start.rescaled_force
        assert force == pytest.approx(ring.start.rescaled_force, rel=1e-13)
        assert other._replace(damping=0.5, start=ring.start) == ring


def test_merged_rings_keep_their_axes_and_profile(tmp_path):
    record = {
        "scalars": ["displacement_sup_logarithmic"],
        "profile": {"start": -4, "stop": 4, "count": 9},
    }
    rings = merged(campaign(RINGS, record=record), tmp_path, 1)
    assert rings["displacement_sup_logarithmic"].dims == ("alpha", "slow_time")
    assert rings.attrs["damping"] == 0.5
    assert "gamma" not in rings.attrs
    wave = rings["relative_displacement"].sel(alpha=1.1, slow_time=0.2)
    assert float(wave.max()) == pytest.approx(0.93, abs=0.02)
    assert abs(float(wave.idxmax("xi"))) <= 1.0


def test_run_of_the_paper_agrees_with_its_scene():
    """The plateau of section 4.3 at an early time, by the campaign in units of δ and 1/c."""
    scene = scene_with("weak", end_time=10.0, half_beads=40, start__half_width=4)
    scene["record"] = {"snapshots": [0, 10], "grid": {"step": 10}}
    scene["tolerance"] = {"relative": 1e-10, "absolute": 1e-12}
    data = compare_with_chain(scene)
    given = {"gamma": 0.24, "delta": 5.0, "half_beads": 40, "half_width": 4, "base": 1e-7}
    start = {"profile": "plateau", "velocity": "leading"}
    ring = make_ring({"alpha": 1.1, **given}, start)
    slow_time = np.array([10.0 * 5.0**0.05 * ring.scaling.slow_rate])
    found = compare(ring, slow_time, 1e-8)
    for name, field in (
        ("displacement_sup", "relative_displacement_sup"),
        ("displacement_rms", "relative_displacement_rms"),
        ("leading_velocity_sup", "velocity_sup"),
    ):
        for model in ("logarithmic", "unlimited"):
            expected = float(data[f"{field}_{model}"][-1])
            assert found[f"{name}_{model}"][0][0] == pytest.approx(expected, abs=2e-5)
    gap = float(data["first_gap_time"]) * 5.0**0.05 * ring.scaling.slow_rate
    assert found["first_gap_time"][0][0] == pytest.approx(gap, rel=1e-4)


def test_paper_does_not_keep_its_requirement():
    """ε/γc of the two runs, equal to 12/μ²: near critical damping μ = 2."""
    given = {"gamma": 0.24, "delta": 5.0, "half_beads": 80, "half_width": 10, "base": 1e-7}
    for alpha, ratio, mu in ((1.1, 1.34, 2.99), (1.5, 2.59, 2.15)):
        scaling = make_ring({"alpha": alpha, **given}, {"profile": "plateau"}).scaling
        assert scaling.ratio == pytest.approx(ratio, abs=0.005)
        assert scaling.dispersion**-0.5 == pytest.approx(mu, abs=0.005)


@pytest.mark.parametrize("alpha", [1.03, 1.04, 1.1])
def test_ring_has_the_length_nearest_to_the_one_asked_for(alpha):
    ring = make_ring(WAVE | {"alpha": alpha}, RINGS["start"])
    lengths = [ring.scaling.half_length(ring.half_beads + k) for k in (-1, 0, 1)]
    assert np.argmin(np.abs(np.array(lengths) - PULSE["half_length"])) == 1


def test_given_profile_may_be_any():
    """A pulse listed by hand is the pulse."""
    pulse = make_ring(WAVE, RINGS["start"])
    start = {"profile": "given", "rescaled_force": [*pulse.start.rescaled_force]}
    axes, bare = {"slow_time": [0.5]}, {"alpha": 1.2, "damping": 0.5, "half_length": 8.1}
    listed = solved(start=start, axes=axes, fixed=bare)
    named = solved(axes=axes, fixed=bare | PULSE)
    for name, value in named.values.items():
        np.testing.assert_array_equal(listed.values[name], value)
