"""Chains whose masses and contacts differ: patterns and equilibria."""

import numpy as np
import pytest
from chains import driven_scene, given, last_state

import granular_fronts as gf
from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.simulate import solve
from granular_fronts.scenes.beads import Masses, Pattern

MASSES, FACTORS = {"cell": [1.0, 0.3]}, {"cell": [1.0, 2.0]}
TODA = {"elastic": {"kind": "toda", "strength": 1, "rate": 1}}


def hanging(law, gravity, left=0.0, **changes):
    """A chain that its weight, and a force on bead 1, press on a wall."""
    wall = {"kind": "wall", "left": left}
    scene = {"boundary": wall, "start": {"kind": "equilibrium"}, "law": law, "gravity": gravity}
    return driven_scene(end_time=20.0, **scene | changes)


@pytest.mark.parametrize("law", [{"alpha": 1.5, "beta": 1.5, "gamma": 0.2}, TODA])
def test_a_chain_in_equilibrium_stays_at_rest(law):
    """Every contact bears what presses bead 1 and the weight above it, by its stiffness.

    A striker hits such a chain.
    """
    unlike = {"beads": {"count": 12, "mass": MASSES}, "contacts": {"elastic": FACTORS}}
    motion = solve(hanging(law, 0.05, 0.1, **unlike)).dataset.isel(t=-1)
    np.testing.assert_array_equal(motion["mass"], np.tile(MASSES["cell"], 6))
    u, velocity = motion["relative_displacement"].values, motion["velocity"]
    np.testing.assert_allclose(velocity, 0.0, atol=1.0e-13)
    pressed, *force = -gf.make_law(**law).elastic.first(-np.append(0.1, u))
    load = pressed + 0.05 * np.cumsum(motion["mass"].values)
    np.testing.assert_allclose(force, load / np.tile(FACTORS["cell"], 6), rtol=1.0e-12)
    unlike |= {"start": {"kind": "striker", "beads": 1, "velocity": 1.0}}
    struck = last_state(hanging(law, 0.05, 0.1, record={"snapshots": [0.0]}, **unlike))
    np.testing.assert_allclose(struck, [*u, 1.0, *[0.0] * 11], atol=1.0e-12)


def test_equilibrium_is_on_the_branch_that_begins_at_rest():
    """The force u − 2.2 u² + 1.3 u³ takes the value 0.12 at 0.1917, 0.4651 and 1.0356."""
    law = {"elastic": {"kind": "fpu", "cubic": 2.2, "quartic": 1.3}}
    u = last_state(hanging(law, 0.12, beads=2, record={"snapshots": [0.0]}))
    assert u[0] == pytest.approx(0.1917, abs=1.0e-4)


def test_a_chain_in_free_fall_moves_as_one():
    """No contact is pressed, and the last of many beads has the velocity g t too."""
    scene = driven_scene(0.0, 100, 3.0, delta=0.0, gravity=0.1)
    np.testing.assert_allclose(last_state(scene), np.repeat([0.0, 0.3], 100), atol=1.0e-14)


def test_patterns():
    def along(count, **pattern):
        return values_along(Masses(**pattern), count)

    np.testing.assert_array_equal(along(5, cell=[1.0, 0.3]), [1.0, 0.3, 1.0, 0.3, 1.0])
    np.testing.assert_allclose(along(3, cell=[2.0, 3.0], taper={"ratio": 0.5}), [2.0, 1.5, 0.5])
    np.testing.assert_allclose(along(3, taper={"difference": 0.5}), [1.0, 1.5, 2.0])
    product = along(3, cell=[2.0], taper={"ratio": 0.5}, list=[1.0, 3.0, 5.0])
    np.testing.assert_allclose(product, [2.0, 3.0, 2.5])
    impurities = [{"bead": 2, "mass": 5.0}, {"bead": 3, "mass": 7.0}]
    np.testing.assert_array_equal(along(4, cell=[2.0], impurity=impurities), [2.0, 5.0, 7.0, 2.0])


@pytest.mark.parametrize("pattern", [{"taper": {"difference": -0.24}}, {"cell": [1e6, 1e-6]}])
def test_patterns_up_to_their_limits_are_accepted(pattern):
    assert not list(Masses(**pattern).problems_along(5, is_ring=False))


def test_random_factors_are_uniform_and_repeatable():
    """The standard deviation is spread/√3, and that of the mean a hundredth of it."""
    pattern = Pattern(cell=[3.0], random={"spread": 0.1, "seed": 3})
    drawn = values_along(pattern, 10_000)
    assert abs(drawn - 3.0).max() <= 0.3
    np.testing.assert_allclose([drawn.mean(), drawn.std()], [3.0, 0.3 / np.sqrt(3)], atol=0.007)
    np.testing.assert_array_equal(drawn, values_along(pattern, 10_000))


@pytest.mark.parametrize("contacts", [{"elastic": FACTORS}, {"elastic": 2}])
def test_contacts_that_differ_move_everywhere_where_all_are_compressed_alike(contacts):
    """No contact is at rest though all have the compression of the right end."""
    held = {"kind": "pressure", "left": 0.5, "right": 0.5}
    start, record = given([0.5] * 99, [0.0] * 100), {"snapshots": [], "balances": True}
    scene = driven_scene(0.0, 100, 5.0, contacts=contacts, boundary=held, start=start)
    drifts = solve(scene | {"record": record}).drifts
    assert drifts["momentum_drift"] < 1e-13
    assert drifts["energy_drift"] < 1e-12
