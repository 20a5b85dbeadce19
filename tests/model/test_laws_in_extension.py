"""Chains whose contacts pull: a cable is the mirror image of a chain of beads."""

import numpy as np
import pytest

import granular_fronts as gf

TOLERANCES = (1e-6, 1e-8, 1e-10)

CABLE = gf.make_law(
    elastic=gf.Potential(
        lambda r: 0.4 * np.maximum(r, 0.0) ** 2.5,
        lambda r: np.maximum(r, 0.0) ** 1.5,
        lambda r: 1.5 * np.maximum(r, 0.0) ** 0.5,
        interval=(-5.0, 5.0),
        kinks=(0.0,),
        name="the cable",
    ),
    viscous=gf.Potential(
        lambda r: 0.15 * np.maximum(r, 0.0) ** 2,
        lambda r: 0.3 * np.maximum(r, 0.0),
        lambda r: np.where(r >= 0.0, 0.3, 0.0),
        interval=(-5.0, 5.0),
        kinks=(0.0,),
        name="its damping",
    ),
)
BEADS = {"alpha": 1.5, "beta": 1.0, "gamma": 0.3}


def motion(law, sign, relative):
    """Six beads that fly apart and meet again, or their mirror image."""
    scene = {
        "law": law,
        "beads": 6,
        "boundary": {"kind": "pressure", "left": 0.3 * sign, "right": 0.1 * sign},
        "start": {
            "kind": "given",
            "relative_displacement": [sign * u for u in (0.3, -0.2, 0.1, -0.05, 0.4)],
            "velocity": [sign * v for v in (-0.3, 0.2, 0.1, -0.5, -0.3, -0.2)],
        },
        "end_time": 6.0,
        "tolerance": {"relative": relative, "absolute": 1e-2 * relative},
        "record": {"snapshots": [6.0]},
    }
    return gf.simulate_chain(scene)


@pytest.mark.parametrize("relative", TOLERANCES)
def test_a_cable_is_the_mirror_image_of_a_chain(relative):
    chain, cable = motion(BEADS, 1.0, relative), motion(CABLE, -1.0, relative)
    for name in ("relative_displacement", "velocity"):
        errors = chain[name].error_estimate + cable[name].error_estimate
        assert np.abs(chain[name] + cable[name]).max() <= 3.0 * errors
        assert errors < 1e3 * relative


def test_pulled_chain_relaxes_under_strong_damping():
    scene = {
        "law": {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 20.0}},
        "beads": 4,
        "boundary": {"kind": "pressure", "left": -0.5, "right": -0.5},
        "start": {
            "kind": "given",
            "relative_displacement": [0.01, -0.5, -0.5],
            "velocity": [0.0, 0.0, 0.0, 0.0],
        },
        "end_time": 800.0,
        "tolerance": {"relative": 1e-8, "absolute": 1e-10},
        "record": {"snapshots": [800.0]},
    }
    relaxed = gf.simulate_chain(scene)
    # What is left decays like exp(−tV″/W″), here to 1e-11.
    np.testing.assert_allclose(relaxed["relative_displacement"].squeeze()[:-1], -0.5, atol=1e-8)


def released(level, **record):
    """Toda's chain, compressed by 0.3 and free on its left: a wave of release runs to the right."""
    scene = {
        "law": {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.2}},
        "beads": 10,
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": {"kind": "given", "relative_displacement": [0.3] * 9, "velocity": [0.0] * 10},
        "end_time": 12.0,
        "tolerance": {"relative": 1e-10, "absolute": 1e-12},
        "record": {"snapshots": [12.0], "grid": {"step": 0.01}, "arrival_level": level} | record,
    }
    return gf.simulate_chain(scene)


def test_arrival_is_the_first_passage_of_contacts_that_start_above_the_level():
    data = released(0.15)
    u = data["relative_displacement_grid"].values[:, :-1]
    below = np.where((u <= 0.15).any(axis=0), np.argmax(u <= 0.15, axis=0) * 0.01, np.nan)
    np.testing.assert_allclose(data["arrival_time"].values[:-1], below, atol=0.0101)
    assert np.isfinite(below).all()


def test_first_peak_comes_after_the_arrival():
    data = released(0.15, extremes=True)
    later = np.isfinite(data["first_peak"].values)
    assert later.any()
    assert (data["first_peak_time"].values[later] >= data["arrival_time"].values[later]).all()
