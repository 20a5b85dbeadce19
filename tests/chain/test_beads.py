"""Chains whose masses and contacts differ: an independent solver, closed forms, balances."""

import numpy as np
import pytest
from chains import driven_scene, given, last_state
from scipy.integrate import solve_ivp

import granular_fronts as gf
from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.simulate import solve
from granular_fronts.errors import InputError
from granular_fronts.scenes.beads import Masses, Pattern
from granular_fronts.scenes.chain import read_chain

FREE = {"kind": "pressure", "left": 0.0, "right": 0.0}
WALL = {"kind": "wall", "left": 0.0}
TODA = {"elastic": {"kind": "toda", "strength": 1, "rate": 1}}
STRIKER = {"kind": "striker", "beads": 1, "velocity": 1.0}
RING = {"kind": "ring"}
WAVE = given(0.5 + 0.2 * np.cos(np.arange(12)), 0.1 * np.sin(np.arange(12)))
DIMER = {"count": 12, "mass": {"cell": [1.0, 0.3]}}
STIFF = {"elastic": {"cell": [1.0, 2.0]}}
UNLIKE_DAMPING = STIFF | {"viscous": {"cell": [1.0, 1.5]}}
SOFT_DAMPING = STIFF | {"viscous": {"taper": {"ratio": 1.1}}}
LEFT_WALL = {"kind": "piston", "velocity": 0.0}


def scene_of(beads=DIMER, boundary=FREE, start=STRIKER, end_time=12.0, **changes):
    """A short motion of a chain with its balances."""
    record = {"snapshots": [end_time], "balances": True}
    changes = {"beads": beads, "boundary": boundary, "start": start, "record": record} | changes
    return driven_scene(end_time=end_time, **changes)


def by_newton(scene):
    """u and velocity at the end, by SciPy from m ẍ = T_(n−1) − T_n + m g in positions."""
    made = read_chain(scene)
    mass = values_along(made.beads.masses(), made.beads.count)
    law, boundary, count = scene["law"], scene["boundary"], mass.size
    kind, gravity = boundary["kind"], scene.get("gravity", 0.0)
    contacts = count - (kind not in ("ring", "wall"))
    if kind == "piston":
        mass[0] = np.inf
    alpha, beta = law["alpha"], law["beta"]
    stiffness, viscosity = (
        values_along(pattern, contacts)
        for pattern in (made.elastic, made.contacts.viscous or made.elastic)
    )
    first = solve(scene | {"record": {"snapshots": [0.0]}}, scene["tolerance"]).dataset.isel(t=0)
    u = first["relative_displacement"].values[:contacts]
    turn = u.sum()
    x = np.flip(np.cumsum(np.flip(u))) if kind == "wall" else -np.append(0.0, np.cumsum(u))[:count]

    def compressions(x, turn):
        ahead = {"ring": [x[0] - turn], "wall": [0.0]}.get(kind, [])
        return -np.diff(np.append(x, ahead)) + 0.0 * turn

    def slopes(t, state):
        x, v = np.split(state, 2)
        u, rate = compressions(x, turn), compressions(v, 0.0)
        pressed = np.maximum(u, 0.0)
        damping = viscosity * law["gamma"] * beta * pressed ** (beta - 1.0)
        forces = stiffness * pressed**alpha + np.where(u > 0.0, damping, 0.0) * rate
        held = [max(boundary.get(end, 0.0), 0.0) ** law["alpha"] for end in ("left", "right")]
        behind = forces[-1] if kind == "ring" else held[0]
        ahead = [] if contacts == count else [held[1]]
        return np.concatenate([v, -np.diff([behind, *forces, *ahead]) / mass + gravity])

    state = np.concatenate([x, first["velocity"].values])
    state = solve_ivp(slopes, (0, scene["end_time"]), state, "DOP853", rtol=1e-11, atol=1e-13).y
    x, v = np.split(state[:, -1], 2)
    u = compressions(x, turn)
    return np.concatenate([u, v] if contacts == count else [u, [boundary.get("right", 0.0)], v])


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"boundary": {"kind": "pressure", "left": 0.2, "right": 0.1}, "start": {"kind": "rest"}},
        {"boundary": WALL, "gravity": 0.05, "start": {"kind": "rest"}},
        {"boundary": WALL, "gravity": 0.05, "contacts": STIFF},
        {"boundary": RING, "start": WAVE},
        {"boundary": RING, "start": WAVE, "contacts": UNLIKE_DAMPING, "beta": 2.5},
        {"contacts": SOFT_DAMPING},
        {"boundary": WALL, "gravity": 0.05, "beta": 2.5},
        {"beads": {"count": 12, "mass": {"impurity": {"bead": 6, "mass": 1.0e-2}}}},
        {"boundary": LEFT_WALL, "start": given([-0.2] + [0.0] * 10, [0.0, -0.5] + [0.0] * 10)},
    ],
    ids=[
        "striker",
        "pressure",
        "falling",
        "hanging",
        "ring",
        "ring-pair",
        "factors",
        "pair-gravity",
        "impurity",
        "left-wall",
    ],
)
def test_a_chain_of_unlike_beads_agrees_with_newtons_law(changes):
    """Both solve the same equations; the reference knows neither w nor the strain form."""
    scene = scene_of(**changes)
    np.testing.assert_allclose(last_state(scene), by_newton(scene), rtol=0, atol=3.0e-8)


@pytest.mark.parametrize("beta", [1.5, 1.0])
@pytest.mark.parametrize(
    "contacts",
    [{}, STIFF, SOFT_DAMPING],
    ids=["masses", "stiff", "both"],
)
@pytest.mark.parametrize(
    ("boundary", "start", "gravity"),
    [
        (FREE, STRIKER, 0.0),
        ({"kind": "pressure", "left": 0.2, "right": 0.1}, {"kind": "rest"}, 0.03),
        (WALL, STRIKER, 0.05),
        ({"kind": "piston", "velocity": 0.3, "ramp": 2.0}, {"kind": "rest"}, 0.0),
        (RING, WAVE, 0.0),
    ],
    ids=["striker", "pressure", "wall", "piston", "ring"],
)
def test_balances_of_unlike_beads_close(boundary, start, gravity, contacts, beta):
    if boundary is RING and "viscous" in contacts:
        contacts = {"elastic": {"cell": [1.0, 2.0]}, "viscous": {"cell": [1.0, 3.0]}}
    changes = {"gravity": gravity} if gravity else {}
    scene = scene_of(boundary=boundary, start=start, contacts=contacts, beta=beta, **changes)
    drifts = solve(scene).drifts
    assert drifts["energy_drift"] < 1.0e-12
    assert (
        np.isnan(drifts["momentum_drift"]) if boundary is WALL else drifts["momentum_drift"] < 1e-13
    )


def test_equal_masses_and_factors_are_the_uniform_chain():
    """The general loops, with factors of 1, differ from the plain ones by rounding alone."""
    ones = {"elastic": {"cell": [1.0, 1.0, 1.0]}}
    plain = last_state(driven_scene(beads=24))
    varied = last_state(driven_scene(beads={"count": 24, "mass": {"cell": [1.0, 1.0]}}))
    scaled = last_state(driven_scene(beads=24, contacts=ones))
    np.testing.assert_allclose([varied, scaled], [plain] * 2, rtol=0, atol=1.0e-13)


def test_scaling_all_masses_scales_time():
    """With masses m and no damping, time runs slower by √m."""
    plain = last_state(driven_scene(0.0, beads=16, end_time=20.0))
    heavy = last_state(driven_scene(0.0, beads={"count": 16, "mass": 4.0}, end_time=40.0))
    np.testing.assert_allclose(heavy[:16], plain[:16], rtol=0, atol=1.0e-12)
    np.testing.assert_allclose(2.0 * heavy[16:], plain[16:], rtol=0, atol=1.0e-12)


@pytest.mark.parametrize("mass", [1.0e-4, 0.3, 1.0, 7.0])
def test_two_beads_collide_as_in_a_textbook(mass):
    """Elastic: the first keeps (1 − m)/(1 + m) of its velocity, the second receives 2/(1 + m)."""
    beads = {"count": 2, "mass": {"list": [1.0, mass]}}
    after = last_state(scene_of(beads, end_time=10.0, gamma=0.0))[2:]
    np.testing.assert_allclose(after, [(1 - mass) / (1 + mass), 2 / (1 + mass)], atol=2.0e-12)


def test_reversed_velocities_lead_back_without_damping():
    scene = scene_of(end_time=6.0, gamma=0.0)
    u, velocity = np.split(last_state(scene), 2)
    back = last_state(scene | {"start": given(u[:-1], -velocity)})
    np.testing.assert_allclose(back, np.append(np.zeros(12), [-1.0, *np.zeros(11)]), atol=1.0e-11)


@pytest.mark.parametrize("law", [{"alpha": 1.5, "beta": 1.5, "gamma": 0.2}, TODA])
def test_a_chain_in_equilibrium_stays_at_rest(law):
    """Every contact bears the weight above it, Σ m_k g, with the factor of its stiffness."""
    scene = scene_of(
        boundary=WALL, start={"kind": "equilibrium"}, gravity=0.05, law=law, contacts=STIFF
    )
    u, velocity = np.split(last_state(scene), 2)
    np.testing.assert_allclose(velocity, 0.0, atol=1.0e-13)
    weight = 0.05 * np.cumsum(values_along(Pattern(**DIMER["mass"]), 12))
    weight /= values_along(Pattern(**STIFF["elastic"]), 12)
    force = -gf.make_law(**law).elastic.first(-u)
    np.testing.assert_allclose(force, weight, rtol=1.0e-12)


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
    beads = 100
    start = {"kind": "given", "relative_displacement": [0.5] * (beads - 1), "velocity": [0] * beads}
    motion = gf.simulate_chain(
        {
            "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.1},
            "beads": beads,
            "contacts": contacts,
            "boundary": {"kind": "pressure", "left": 0.5, "right": 0.5},
            "start": start,
            "end_time": 5.0,
            "tolerance": {"relative": 1e-9, "absolute": 1e-11},
            "record": {"snapshots": [5.0], "balances": True},
        }
    )
    assert motion.attrs["momentum_drift"] < 1e-13
    assert motion.attrs["energy_drift"] < 1e-10
