"""Chains whose masses and contacts differ: patterns, equilibria, what is refused."""

import numpy as np
import pytest
from chains import driven_scene, given, last_state

import granular_fronts as gf
from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.simulate import solve
from granular_fronts.errors import InputError
from granular_fronts.scenes.beads import Masses, Pattern

FREE = {"kind": "pressure", "left": 0.0, "right": 0.0}
WALL = {"kind": "wall", "left": 0.0}
TODA = {"elastic": {"kind": "toda", "strength": 1, "rate": 1}}
STRIKER = {"kind": "striker", "beads": 1, "velocity": 1.0}
RING = {"kind": "ring"}
WAVE = given(0.5 + 0.2 * np.cos(np.arange(12)), 0.1 * np.sin(np.arange(12)))
DIMER = {"count": 12, "mass": {"cell": [1.0, 0.3]}}
STIFF = {"elastic": {"cell": [1.0, 2.0]}}


def scene_of(beads=DIMER, boundary=FREE, start=STRIKER, **changes):
    """A short motion of a chain."""
    return driven_scene(**{"beads": beads, "boundary": boundary, "start": start} | changes)


@pytest.mark.parametrize("law", [{"alpha": 1.5, "beta": 1.5, "gamma": 0.2}, TODA])
def test_a_chain_in_equilibrium_stays_at_rest(law):
    """Every contact bears the weight above it, Σ m_k g, with the factor of its stiffness."""
    equilibrium = {"kind": "equilibrium"}
    scene = scene_of(boundary=WALL, start=equilibrium, gravity=0.05, law=law, contacts=STIFF)
    u, velocity = np.split(last_state(scene), 2)
    np.testing.assert_allclose(velocity, 0.0, atol=1.0e-13)
    weight = 0.05 * np.cumsum(values_along(Pattern(**DIMER["mass"]), 12))
    weight /= values_along(Pattern(**STIFF["elastic"]), 12)
    force = -gf.make_law(**law).elastic.first(-u)
    np.testing.assert_allclose(force, weight, rtol=1.0e-12)


def test_a_chain_in_free_fall_moves_as_one():
    """No contact is pressed, and the last of many beads has the velocity g t too."""
    scene = driven_scene(0.0, 100, 3.0, delta=0.0, gravity=0.1)
    np.testing.assert_allclose(last_state(scene), np.repeat([0.0, 0.3], 100), atol=1.0e-14)


def test_equilibrium_is_on_the_branch_that_begins_at_rest():
    """The force u − 2.2 u² + 1.3 u³ takes the value 0.12 at 0.1917, 0.4651 and 1.0356."""
    law = {"elastic": {"kind": "fpu", "cubic": 2.2, "quartic": 1.3}}
    start = {"kind": "equilibrium"}
    scene = scene_of(2, WALL, start, law=law, gravity=0.12)
    u = solve(scene).dataset["relative_displacement"]
    assert float(u.sel(bead=1)[0]) == pytest.approx(0.1917, abs=1.0e-4)


def test_patterns():
    expected = [1.0, 0.3, 1.0, 0.3, 1.0]
    np.testing.assert_array_equal(values_along(Pattern(cell=[1.0, 0.3]), 5), expected)
    np.testing.assert_allclose(values_along(Pattern(taper={"ratio": 0.5}), 3), [1.0, 0.5, 0.25])
    np.testing.assert_allclose(values_along(Pattern(taper={"difference": 0.5}), 3), [1.0, 1.5, 2.0])
    impurity = {"cell": [2.0], "impurity": [{"bead": 2, "mass": 5.0}, {"bead": 3, "mass": 7.0}]}
    np.testing.assert_array_equal(values_along(Masses(**impurity), 4), [2.0, 5.0, 7.0, 2.0])
    drawn = values_along(Pattern(cell=[3.0], random={"spread": 0.1, "seed": 3}), 10_000)
    assert abs(drawn - 3.0).max() <= 0.3
    # Uniform: the standard deviation is spread/√3, and that of the mean a hundredth of it.
    np.testing.assert_allclose([drawn.mean(), drawn.std()], [3.0, 0.3 / np.sqrt(3)], atol=0.007)
    np.testing.assert_array_equal(
        drawn, values_along(Pattern(cell=[3.0], random={"spread": 0.1, "seed": 3}), 10_000)
    )


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (
            {"beads": {"count": 5, "mass": {"cell": [1.0, -2.0]}}},
            "beads.mass.cell (entry 2) is -2.0",
        ),
        ({"beads": {"count": 5, "mass": {"list": [1.0, 2.0]}}}, "beads.mass.list has 2 values | 5"),
        ({"beads": {"count": 5, "mass": {"impurity": {"bead": 9, "mass": 2}}}}, "is at 9 | 5"),
        (
            {"beads": {"count": 5, "mass": {"impurity": [{"bead": 3, "mass": m} for m in (2, 5)]}}},
            "beads.mass.impurity names 3 more than once | keep one",
        ),
        (
            {"contacts": {"viscous": {"impurity": [{"contact": 2, "factor": 3}] * 2}}},
            "contacts.viscous.impurity names 2 more than once",
        ),
        (
            {"beads": {"count": 5, "mass": {"taper": {"difference": -0.3}}}},
            "difference is -0.3 | -0.25",
        ),
        (
            {"beads": {"count": 5, "mass": {"random": {"spread": 1.5, "seed": 1}}}},
            "spread is 1.5 | 1",
        ),
        (
            {
                "beads": 13,
                "boundary": RING,
                "start": given([0.1] * 13, [0.0] * 13),
                "contacts": STIFF,
            },
            "13 | 12",
        ),
        ({"beads": {"count": 5, "mass": 1.0e7}}, "beads.mass comes to 1e±7 | 1e±6"),
        ({"beads": {"count": 5, "mass": {"taper": {"ratio": 0.01}}}}, "beads.mass comes to 1e±8"),
        ({"start": STRIKER | {"beads": 12}}, "start.beads is 12 | 11"),
        ({"start": STRIKER | {"velocity": 0.0}}, "start.velocity is 0"),
        (
            {"contacts": {"elastic": {"impurity": {"contact": 20, "factor": 2}}}},
            "contacts.elastic.impurity is at 20 | 11",
        ),
        ({"gravity": 0.1}, "gravity 0.1 | balance"),
        ({"boundary": WALL | {"left": -0.1}, "law": TODA}, "boundary.left is -0.1 | pulls"),
        ({"gravity": -0.1, "boundary": WALL}, "gravity is -0.1 | 0 or more"),
        ({"gravity": 0.1, "boundary": RING, "start": WAVE}, "gravity is 0.1 | ring"),
        (
            {"boundary": {"kind": "pressure", "left": 0.1, "right": 0.0}},
            "boundary.left is 0.1 | 0",
        ),
    ],
)
def test_impossible_chains_are_refused(changes, words):
    with pytest.raises(InputError) as caught:
        gf.simulate_chain(scene_of(**changes))
    assert all(word in str(caught.value) for word in words.split(" | "))


@pytest.mark.parametrize("contacts", [{"elastic": {"cell": [1, 2]}}, {"elastic": 2}])
def test_contacts_that_differ_move_everywhere_where_all_are_compressed_alike(contacts):
    """No contact is at rest though all have the compression of the right end."""
    held = {"kind": "pressure", "left": 0.5, "right": 0.5}
    start, record = given([0.5] * 99, [0.0] * 100), {"snapshots": [], "balances": True}
    scene = driven_scene(0.0, 100, 5.0, contacts=contacts, boundary=held, start=start)
    drifts = solve(scene | {"record": record}).drifts
    assert drifts["momentum_drift"] < 1e-13
    assert drifts["energy_drift"] < 1e-12
