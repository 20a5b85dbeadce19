"""Exact fronts of any law between any states: identities, the chain as the judge, and sweeps."""

import functools
import json
import math

import numpy as np
import pytest
from potentials import cosh
from scipy.optimize import brentq

import granular_fronts as gf
from granular_fronts.fronts.profile.equation import front_problem
from granular_fronts.fronts.profile.solve import (
    Window,
    quadrature_defect,
    refine,
    solve_on_grid,
    solve_profile,
)
from granular_fronts.fronts.solve import FIELDS


def law_of(elastic, viscous, **parameters):
    elastic = elastic if isinstance(elastic, gf.Potential) else {"kind": elastic} | parameters
    return gf.make_law(elastic=elastic, viscous=viscous)


def linear(gamma):
    return {"kind": "linear", "gamma": gamma}


NONLINEAR = {"kind": "fpu", "quadratic": 0.5, "quartic": 0.25}
POWER = {"kind": "power", "beta": 1.25, "gamma": 0.4}
FRONTS = {
    "toda, weakly damped": (law_of("toda", linear(0.05)), (-2.0, 0.0)),
    "fpu": (law_of("fpu", NONLINEAR, cubic=3.0), (1.0, 0.0)),
    "hertz": (law_of("hertz", POWER, alpha=1.5, stiffness=2.0), (-0.5, -0.1)),
    "cosh": (law_of(cosh(), linear(0.4)), (-2.0, -0.5)),
    "lennard_jones": (law_of("lennard_jones", linear(0.2), depth=1.0 / 72.0), (-0.08, 0.01)),
    "proportional": (law_of("toda", {"kind": "proportional", "gamma": 0.2}), (-1.5, 0.5)),
}


def powers(alpha, gamma, beta=None, right_state=0.0):
    """A law and the states of a front of two powers from compression 1."""
    return gf.make_law(alpha=alpha, beta=beta, gamma=gamma), (-1.0, 0.0 - right_state)


POWERS = {
    "long waves, strongly damped": powers(1.02, 20.0),
    "weakly damped": powers(1.5, 0.0337),
    "dashpot": powers(1.5, 0.2, 1.0),
    "alpha = 3": powers(3.0, 0.1),
    "beta = 5/2, compressed": powers(1.5, 0.2, 2.5, 0.3),
    "almost linear": powers(1.5, 0.1, right_state=0.9),
}
ALL = FRONTS | POWERS
XI = np.array([-6.0, -2.0, -0.5, 0.75, 2.0])

by_front = pytest.mark.parametrize("name", FRONTS)
by_any_front = pytest.mark.parametrize("name", ALL)
# Not the widest, which coarse grids resolve to the last digit, and which differ little in damping.
WIDEST = ("long waves, strongly damped", "almost linear")
by_sharper_front = pytest.mark.parametrize("name", [name for name in ALL if name not in WIDEST])


@functools.cache
def solved(name):
    law, states = ALL[name]
    if name in POWERS:
        front = gf.solve_front(law.alpha, law.gamma, law.beta, right_state=-states[1])
    else:
        front = gf.solve_front(law=law, states=states)
    assert front.attrs["converged"] == 1, front.attrs["reason"]
    assert front.attrs["reason"] == ""
    return front


@by_any_front
def test_front_obeys_the_jump_conditions(name):
    """The speed is an unknown and the power an integral; neither knows of the theory."""
    front, (law, states) = solved(name), ALL[name]
    theory, plain = gf.jump_conditions(law, *states), name in POWERS
    attributes = front.attrs
    assert attributes["speed"] == pytest.approx(theory.speed, rel=1e-15 if plain else 0.0, abs=0.0)
    assert abs(attributes["speed_defect"]) <= attributes["speed_defect_error"] <= 1e-14
    close = {"abs": 1e-14} if plain else {"rel": 1e-13}
    assert attributes["dissipated_power"] == pytest.approx(theory.dissipated_power, **close)
    assert attributes["error_estimate"] <= (1e-13 if plain else 2e-13 * max(map(abs, states)))
    ends = front["strain"].values[[0, -1]]
    size = max(map(abs, states))
    np.testing.assert_allclose(ends, states, rtol=0, atol=1e-13 if plain else 5e-13 * size)
    ends = front["velocity"].values[[0, -1]]
    close = 1e-13 if plain else 1e-12 * theory.speed
    np.testing.assert_allclose(
        ends, [theory.velocity_behind, theory.velocity_ahead], rtol=0, atol=close
    )
    np.testing.assert_array_equal(front["strain"], -front["relative_displacement"])
    halfway = gf.evaluate_front(front, 0.0, "strain")
    assert halfway == pytest.approx(0.5 * sum(states), rel=1e-15)
    if plain:
        assert attributes["right_state"] == -states[1]
        assert attributes["residual"] <= 1e-13
        assert front["velocity"].attrs["error_estimate"] <= 5e-13
        assert "22 instead of 20" in front["velocity"].attrs["error_method"]


@by_front
def test_what_is_measured_on_a_front_is_that_of_its_profile(name):
    """By SciPy's root finder and by differences, without the kernels that measure."""
    front, (behind, ahead) = solved(name), FRONTS[name][1]

    def share(xi):
        return (gf.evaluate_front(front, xi, "strain") - ahead) / (behind - ahead)

    xi = np.arange(front["xi"].values[0], front["xi"].values[-1], 2e-3)
    values, ends = share(xi), []
    for level in (0.9, 0.1):
        k = np.flatnonzero((values[:-1] >= level) & (values[1:] < level))[-1]
        ends.append(brentq(lambda x, level=level: float(share(x)) - level, xi[k], xi[k + 1]))
    jump, found = abs(behind - ahead), front.attrs
    assert found["width_10_90"] == pytest.approx(ends[1] - ends[0], abs=1e-9)
    assert found["slope"] == pytest.approx(jump * -np.gradient(values, xi).min(), rel=1e-4)
    assert found["overshoot"] == pytest.approx(jump * max(values.max() - 1.0, 0.0), abs=1e-5 * jump)
    for measure in ("overshoot", "width_10_90", "slope", "dissipated_power"):
        assert found[f"{measure}_error"] < 1e-11


@by_any_front
def test_errors_of_measures_follow_from_that_of_the_strain(name):
    """An error η of the strain moves levels by η/|R'|, slopes by η/(4h), the power by parts."""
    front, (law, _) = solved(name), ALL[name]
    found, strain = front.attrs, front["strain"].values
    error, slopes = found["error_estimate"], np.gradient(strain, front["xi"].values)
    way = (strain - strain[-1]) / (strain[0] - strain[-1])
    flattest = min(abs(slopes[np.flatnonzero(way >= level)[-1]]) for level in (0.1, 0.9))
    expected = {"overshoot": 1.0, "first_peak": 1.0, "width_10_90": 1.0 / flattest}
    if law.proportional is None:
        weighted = found["speed"] ** 2 * law.viscous.second(strain) * slopes
        expected["dissipated_power"] = np.abs(np.diff(weighted)).sum()
    for measure, factor in expected.items():
        assert 0.98 * factor * error <= found[f"{measure}_error"] <= 2.0 * factor * error
    assert found["slope_error"] >= 0.249 * error / found["spacing"]


def test_errors_scale_with_the_jump():
    """With β = (α + 1)/2 fronts of all sizes have one shape, and the same relative errors."""
    law = {"alpha": 1.5, "beta": 1.25, "gamma": 0.3}
    large, small = (gf.solve_front(law=law, states=(-size, 0.0)) for size in (1.0, 1e-3))
    for name in FIELDS:
        large_error, small_error = (front[name].attrs["error_estimate"] for front in (large, small))
        scale = 1e-3 ** (1.25 if name == "velocity" else 1.0)
        assert small_error == pytest.approx(scale * large_error, rel=0.5)


def carried(law, states, front, shift=0.0):
    """Largest change of u and ẋ/c when the chain carries a front for a bead-time, seen from it."""
    behind, ahead = states
    first = math.ceil(-front["xi"].values[0]) + 2
    beads = np.arange(1.0, first + math.ceil(front["xi"].values[-1]) + 4)
    u = gf.evaluate_front(front, beads - first) + shift * np.exp(-((beads - first) ** 2))
    period = 1.0 / front.attrs["speed"]
    later = gf.simulate_chain(
        {
            "law": law,
            "beads": beads.size,
            "boundary": {"kind": "pressure", "left": -behind, "right": -ahead},
            "start": {
                "kind": "given",
                "relative_displacement": u[:-1].tolist(),
                "velocity": gf.evaluate_front(front, beads - first, "velocity").tolist(),
            },
            "end_time": period,
            "tolerance": {"relative": 1e-14, "absolute": 1e-16 * max(map(abs, states))},
            "record": {"snapshots": [period]},
        }
    )
    changes = [
        later[field].values[0] - gf.evaluate_front(front, beads - first - 1.0, field)
        for field in ("relative_displacement", "velocity")
    ]
    return max(np.abs(changes[0][:-1]).max(), period * np.abs(changes[1]).max())


@by_sharper_front
def test_chain_carries_the_front_by_one_bead_per_bead_time(name):
    """The chain's integrator knows nothing of the profile equation."""
    law, states = ALL[name]
    front, size = solved(name), max(map(abs, states))
    assert carried(law, states, front) <= 1e-12 * size
    # Neither another state nor another damping is carried.
    assert carried(law, states, front, shift=1e-3 * size) > 1e-6 * size
    assert carried(law.with_damping(1.05), states, front) > 1e-4 * size


@by_sharper_front
def test_grid_errors_fall_as_the_defect_says(name):
    """The difference of two rules bounds the error against a finer grid, and both fall."""
    law, states = ALL[name]
    problem = front_problem(law, *states)
    fine = refine(solve_profile(problem))
    window = Window(
        *(n * float(fine.spacing) for n in (fine.middle, fine.s.size - fine.middle - 1))
    )
    defects, errors = [], []
    for factor in (4, 3, 2):
        spacing = factor * fine.spacing
        coarse = solve_on_grid(problem, window, spacing, 20, fine.evaluate)
        defects.append(quadrature_defect(coarse))
        errors.append(np.abs(coarse.s - fine.evaluate(coarse.xi)).max())
    assert defects == sorted(defects, reverse=True)
    assert errors == sorted(errors, reverse=True)
    assert errors[0] > 30.0 * errors[2]
    assert (np.array(errors) < 10.0 * np.array(defects) + 1e-14).all()


@pytest.mark.parametrize("beta", [1.5, 1.0])
def test_both_ways_to_two_powers_are_one(beta):
    known = gf.solve_front(1.5, 0.3, beta)
    found = gf.solve_front(law={"alpha": 1.5, "beta": beta, "gamma": 0.3}, states=(-1.0, 0.0))
    np.testing.assert_allclose(found["strain"], known["strain"], rtol=0, atol=1e-15)
    assert found.attrs.keys() == known.attrs.keys()
    shot = gf.solve_front(law=json.loads(found.attrs["law"]), states=(-1, 0), method="shooting")
    other = gf.evaluate_front(found, shot["xi"].values)
    np.testing.assert_allclose(shot["relative_displacement"], other, rtol=0, atol=1e-13)


@pytest.mark.parametrize("law", [law_of("toda", linear(0.3)), gf.make_law(alpha=1.5, gamma=0.3)])
def test_close_states_have_the_digits_that_rounding_leaves(law):
    """Strains near −1 are known to 1e-16, and the jump of 0.01 accordingly less well."""
    front = gf.solve_front(law=law, states=(-1.0, -0.99))
    theory = gf.jump_conditions(law, -1.0, -0.99)
    assert front.attrs["converged"] == 1
    assert front.attrs["error_estimate"] < 2e-14
    assert front.attrs["dissipated_power"] == pytest.approx(theory.dissipated_power, rel=1e-11)
