"""Spheres of materials: Hertz's law for unlike bodies, and chains of them in SI units."""

import math

import numpy as np
import pytest
from chains import driven_scene, given, last_state
from scipy.integrate import solve_ivp

import granular_fronts as gf
from granular_fronts.model.materials import MATERIALS, body_of
from granular_fronts.model.scaling import sphere_mass
from granular_fronts.scenes.chain import Chain

# Speeds of waves of compression and of shear in m/s, of mild and 347 steel and of pyrex, from the
# table of the CRC Handbook of Chemistry and Physics.
SPEEDS = {"steel": (5960, 3235), "stainless_steel": (5790, 3100), "aluminium": (6420, 3040)}
SPEEDS |= {"brass": (4700, 2110), "glass": (5640, 3280), "tungsten_carbide": (6655, 3980)}
SPEEDS |= {"nylon": (2620, 1070)}
STRIKER = {"kind": "striker", "beads": 1, "velocity": 1.0}


def chain_of(beads, end_time=10.0, **changes):
    return driven_scene(0.0, beads, end_time, delta=0.0, **{"start": STRIKER} | changes)


@pytest.mark.parametrize("name", MATERIALS)
def test_materials_are_solids(name):
    """A wave of compression is faster than one of shear, and both are slower than in diamond."""
    density, modulus, ratio, source = MATERIALS[name]
    shear = modulus / (2.0 * (1.0 + ratio))
    bulk = modulus / (3.0 * (1.0 - 2.0 * ratio))
    slow, fast = np.sqrt(np.array([shear, bulk + 4.0 / 3.0 * shear]) / density)
    assert 50.0 < slow < fast < 18_000.0
    expected = SPEEDS.get(name, (fast, slow))
    assert (fast, slow) == pytest.approx(expected, rel=0.13 if name == "nylon" else 0.05)
    assert source


def test_bodies_by_words():
    for words in ("steel 20 mm", "steel 2cm", "steel 0.02 m", "steel 2e4 um", " steel  20.0mm "):
        assert body_of(words).radius == pytest.approx(0.01, rel=1.0e-15)
    assert body_of("ptfe 3 in").radius == pytest.approx(0.0381)
    mass = 7810.0 * 4.0e-6 / 3.0 * math.pi
    assert body_of("steel 20 mm").mass == pytest.approx(mass)
    assert sphere_mass(0.01, 7810.0) == pytest.approx(mass)
    # Porter et al., Phys. Rev. E 77, 015601 (2008): beads of 4.76 mm of 0.45 g and 0.123 g.
    for words, grams, error in (("stainless_steel", 0.45, 0.005), ("ptfe", 0.123, 0.0005)):
        assert 1.0e3 * body_of(f"{words} 4.76 mm").mass == pytest.approx(grams, abs=error)


def test_contacts_are_hertzian():
    """Equal spheres have the k of Remark 6, a wall is a sphere without end, compliances add."""
    equal = gf.contact_stiffness("glass 8 mm", "glass 8 mm")
    assert equal == pytest.approx(gf.sphere_stiffness(0.004, 70.0e9, 0.22), rel=1.0e-14)
    assert gf.contact_stiffness("glass 8 mm", "glass") == pytest.approx(math.sqrt(2.0) * equal)
    far = gf.contact_stiffness("ptfe 8 mm", "steel 1e9 m")
    assert gf.contact_stiffness("ptfe 8 mm", "steel") == pytest.approx(far, rel=1.0e-11)
    sizes = "glass 8 mm", "steel 8 mm"
    soft, stiff = (gf.contact_stiffness(size, size) for size in sizes)
    mixed = gf.contact_stiffness(*sizes)
    assert 2.0 / mixed == pytest.approx(1.0 / soft + 1.0 / stiff, rel=1.0e-14)


def test_a_chain_of_ten_materials_in_si_units():
    """Newton's law in kilograms, metres and seconds, against the scene and its scaling."""
    words = [f"{name} {size} mm" for name, size in zip(MATERIALS, range(5, 15), strict=False)]
    bodies = [body_of(word) for word in words]
    mass = np.array([body.mass for body in bodies])
    pairs = zip(words, [*words[1:], "brass"], strict=True)
    stiffness = np.array([gf.contact_stiffness(*pair) for pair in pairs])
    wall = {"kind": "wall", "left": 0.0, "material": "brass"}
    scene = chain_of({"count": 10, "list": words}, 40.0, boundary=wall)
    scaling = gf.Scaling.of_spheres(words[0], velocity=0.3, damping=1.0e-6)
    assert scaling.damping == 1.0e-6

    def slopes(t, state):
        x, v = np.split(state, 2)
        force = stiffness * np.maximum(x - np.append(x[1:], 0.0), 0.0) ** 1.5
        return np.concatenate([v, -np.diff(force, prepend=0.0) / mass])

    start = np.append(np.zeros(10), 0.3 * np.eye(10)[0])
    end = scaling.to_physical(40.0, "time")
    found = solve_ivp(slopes, (0.0, end), start, "DOP853", rtol=1.0e-12, atol=1.0e-18).y[:, -1]
    x, v = np.split(found, 2)
    u, velocity = np.split(last_state(scene), 2)
    u, velocity = scaling.to_physical(u, "displacement"), scaling.to_physical(velocity, "velocity")
    np.testing.assert_allclose(u, x - np.append(x[1:], 0.0), rtol=0, atol=1.0e-8 * abs(x).max())
    np.testing.assert_allclose(velocity, v, rtol=0, atol=1.0e-8)


def test_equal_spheres_are_the_uniform_chain():
    plain = last_state(chain_of(12))
    spheres = last_state(chain_of({"count": 12, "cell": ["brass 5 mm", "brass 0.5 cm"]}))
    np.testing.assert_allclose(spheres, plain, rtol=0, atol=1.0e-13)


def test_a_ring_closes_with_the_contact_of_its_last_and_first_sphere():
    beads = {"count": 4, "cell": ["steel 9.5 mm", "ptfe 4.8 mm"]}
    scene = chain_of(beads, boundary={"kind": "ring"}, start=given([0.1] * 4, [0.0] * 4))
    [factor] = set(Chain.read(scene).elastic.list)
    unlike = gf.contact_stiffness("steel 9.5 mm", "ptfe 4.8 mm")
    assert factor == pytest.approx(unlike / gf.contact_stiffness(*2 * ["steel 9.5 mm"]))
