"""Any chain keeps its balances and moves by Newton's law."""

import numpy as np
import pytest
from chains import TIGHT, driven_scene, given
from hypothesis import given as with_any
from hypothesis import settings
from hypothesis import strategies as st
from newton import newton

from granular_fronts.chain.simulate import solve
from granular_fronts.scenes.chain import Piston

TODA = {"kind": "toda", "strength": 0.7, "rate": 1.3}
FPU = {"kind": "fpu", "quadratic": 1.0, "cubic": -0.3, "quartic": 0.2}
MORSE = {"kind": "morse", "depth": 1.0, "rate": 1.0}
EXPONENTS = [(1.5, 1.5), (1.2, 1.2), (3.0, 3.0), (1.5, 1.0), (1.5, 2.5), (1.0, 1.0)]
POWERS = [{"alpha": a, "beta": b, "gamma": g} for a, b in EXPONENTS for g in (0.0, 0.3)]
PULLING = [
    {"elastic": TODA},
    {"elastic": TODA, "viscous": {"kind": "proportional", "gamma": 0.3}},
    {"elastic": FPU, "viscous": TODA},
    {"elastic": MORSE, "viscous": {"kind": "linear", "gamma": 0.3}},
]
MASSES = [
    {},
    {"cell": [0.7, 0.3]},
    {"cell": [1.0, 2.0], "impurity": {"bead": 2, "mass": 0.05}},
    {"cell": [1.0], "impurity": {"bead": 2, "mass": 0.4}},
]
FACTORS = [
    {},
    {"elastic": {"cell": [1.0, 2.0]}},
    {"elastic": {"cell": [1.0, 2.0]}, "viscous": {"cell": [3.0, 0.5]}},
]
SMOOTH = [
    0.05,
    {"half_sine": {"amplitude": 0.3, "duration": 2.0}},
    {"harmonic": {"amplitude": 0.05, "angular_frequency": 1.3, "phase": 0.4, "offset": 0.06}},
    {"table": {"times": [0.5, 1.5, 2.0, 3.0], "values": [0.02, 0.1, -0.03, 0.05]}},
]
JUMPING = {"pulse": {"height": 0.2, "duration": 2.0, "offset": 0.01}}
HELD = st.sampled_from([0.0, 0.2])
ENDS = {
    "pressure": st.fixed_dictionaries({"left": HELD, "right": HELD}),
    "ring": st.just({}),
    "piston": st.fixed_dictionaries({"velocity": st.sampled_from(SMOOTH), "right": HELD}),
    "force": st.fixed_dictionaries({"force": st.sampled_from([*SMOOTH, JUMPING]), "right": HELD}),
    "wall": st.fixed_dictionaries({"left": HELD})
    | st.fixed_dictionaries({"force": st.sampled_from([*SMOOTH, JUMPING])}),
}


@st.composite
def scenes(draw, kind):
    """A few beads with gaps or without, or more than are reached from rest, for some time."""
    starts = ["given"] if kind == "ring" else ["given", "rest"]
    start = {"kind": draw(st.sampled_from([*starts, "striker"] if kind == "wall" else starts))}
    count = draw(st.sampled_from([2, 6, 8] if start["kind"] == "given" else [2, 40]))
    boundary = {"kind": kind} | draw(ENDS[kind])
    if start["kind"] == "striker":
        start |= {"beads": 1, "velocity": 0.5}
    if start["kind"] == "given":
        rng = np.random.default_rng(draw(st.integers(0, 1000)))
        velocity = rng.uniform(-0.3, 0.3, count)
        if kind == "piston":
            velocity[0] = Piston(**boundary).at_start
        start = given(rng.uniform(-0.1, 0.4, count - (kind not in ("ring", "wall"))), velocity)
    return driven_scene(
        beads={"count": count, "mass": draw(st.sampled_from(MASSES))},
        law=draw(st.sampled_from([*POWERS, *PULLING])),
        contacts=draw(st.sampled_from(FACTORS)),
        boundary=boundary,
        gravity=0.0 if kind in ("ring", "piston") else draw(st.sampled_from([0.0, 0.05])),
        start=start,
        end_time=4.0,
        record={"snapshots": [4.0], "balances": True},
    )


@pytest.mark.parametrize("kind", ENDS)
def test_any_chain_keeps_its_balances_and_moves_by_newtons_law(kind):
    """Momentum has no law of its own before a wall."""

    @settings(max_examples=12, deadline=None, derandomize=True, database=None)
    @with_any(scenes(kind))
    def holds(scene):
        solution = solve(scene, TIGHT)
        drifts, last = solution.drifts, solution.dataset.isel(t=-1)
        assert np.isnan(drifts["momentum_drift"]) == (kind == "wall")
        assert not drifts["momentum_drift"] > 2.0e-13
        assert drifts["energy_drift"] < 5.0e-11
        found = np.concatenate([last["relative_displacement"], last["velocity"]])
        np.testing.assert_allclose(found, newton(scene), rtol=0, atol=1.0e-9)

    holds()
