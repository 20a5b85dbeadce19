"""Chains whose contacts pull: a cable is the mirror image of a chain of beads."""

import numpy as np
from chains import driven_scene, given

import granular_fronts as gf

KINKED = {"interval": (-5.0, 5.0), "kinks": (0.0,)}
CABLE = gf.make_law(
    elastic=gf.Potential(
        lambda r: 0.4 * np.maximum(r, 0.0) ** 2.5,
        lambda r: np.maximum(r, 0.0) ** 1.5,
        lambda r: 1.5 * np.maximum(r, 0.0) ** 0.5,
        **KINKED,
    ),
    viscous=gf.Potential(
        lambda r: 0.15 * np.maximum(r, 0.0) ** 2,
        lambda r: 0.3 * np.maximum(r, 0.0),
        lambda r: np.where(r >= 0.0, 0.3, 0.0),
        **KINKED,
    ),
)
BEADS = {"alpha": 1.5, "beta": 1.0, "gamma": 0.3}


def motion(law, sign):
    """Six beads that fly apart and meet again, or their mirror image."""
    u, velocity = [0.3, -0.2, 0.1, -0.05, 0.4], [-0.3, 0.2, 0.1, -0.5, -0.3, -0.2]
    scene = driven_scene(
        beads=6,
        end_time=6.0,
        law=law,
        start=given(sign * np.array(u), sign * np.array(velocity)),
        boundary={"kind": "pressure", "left": 0.3 * sign, "right": 0.1 * sign},
        tolerance={"relative": 1e-8, "absolute": 1e-10},
    )
    return gf.simulate_chain(scene)


def test_a_cable_is_the_mirror_image_of_a_chain():
    chain, cable = motion(BEADS, 1.0), motion(CABLE, -1.0)
    assert (chain.contacts_open, cable.contacts_open) == (1, 0)
    for name in ("relative_displacement", "velocity"):
        errors = chain[name].error_estimate + cable[name].error_estimate
        assert np.abs(chain[name] + cable[name]).max() <= 3.0 * errors
        assert errors < 1e-5


def test_arrivals_and_peaks_of_contacts_that_start_above_the_level():
    """Toda's chain, compressed by 0.3 and free on its left: a wave of release runs to the right."""
    scene = driven_scene(
        beads=10,
        end_time=12.0,
        delta=0.0,
        law={"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.2}},
        start=given([0.3] * 9, [0.0] * 10),
        tolerance={"relative": 1e-10, "absolute": 1e-12},
        record={"snapshots": [], "grid": {"step": 0.01}, "arrival_level": 0.15, "extremes": True},
    )
    data = gf.simulate_chain(scene)
    below = data["relative_displacement_grid"].values[:, :-1] <= 0.15
    assert below.any(axis=0).all()
    arrival = data["arrival_time"].values
    np.testing.assert_allclose(arrival[:-1], 0.01 * below.argmax(axis=0), rtol=0, atol=0.0101)
    later = np.isfinite(data["first_peak"].values)
    assert later.any()
    assert (data["first_peak_time"].values[later] >= arrival[later]).all()
