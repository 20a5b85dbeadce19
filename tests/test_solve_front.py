"""Exact fronts: identities, limits, tails, and the chain itself as the judge."""

import math
import re
import time

import numpy as np
import pytest
from potentials import hertz

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.numerics.interpolation import interpolate_all

LAWS = [
    (1.02, 0.1, None),
    (1.02, 20.0, None),
    (1.5, 0.0337, None),
    (1.5, 0.3, None),
    (1.5, 0.2, 1.0),
    (1.5, 0.2, 1.25),
    (1.5, 0.2, 2.5),
    (3.0, 0.1, None),
    (5.0, 2.0, None),
]


def velocity_at(front, xi):
    grid = front["xi"].values
    position = (xi - grid[0]) / (grid[1] - grid[0])
    ends = front.attrs["speed"], front.attrs["speed"] * front.attrs["right_state"]
    return interpolate_all(front["velocity"].values, position, *ends)


@pytest.mark.parametrize(("alpha", "gamma", "beta"), LAWS)
def test_front_obeys_its_identities(alpha, gamma, beta):
    front = gf.solve_front(alpha, gamma, beta)
    attributes = front.attrs
    assert attributes["converged"] == 1
    assert attributes["reason"] == ""
    assert attributes["residual"] <= 1e-13
    assert abs(attributes["speed_defect"]) <= 1e-14
    assert attributes["error_estimate"] <= 1e-13
    power = (alpha - 1.0) / (2.0 * (alpha + 1.0))
    assert attributes["dissipated_power"] == pytest.approx(power, abs=1e-14)
    assert gf.evaluate_front(front, 0.0) == 0.5
    for name, behind in (("relative_displacement", 1.0), ("velocity", 1.0)):
        values = front[name].values
        assert values[0] == pytest.approx(behind, abs=1e-13)
        assert values[-1] == pytest.approx(0.0, abs=1e-13)
        assert front[name].attrs["error_estimate"] <= 5e-13
        assert "22 instead of 20" in front[name].attrs["error_method"]


@pytest.mark.parametrize("right_state", [0.01, 0.5, 0.9])
def test_front_into_a_compressed_chain_obeys_the_jump_conditions(right_state):
    front = gf.solve_front(1.5, 0.1, right_state=right_state)
    conditions = gf.jump_conditions(hertz(1.5), -1.0, -right_state)
    speed = conditions.speed
    assert front.attrs["converged"] == 1
    assert front.attrs["speed"] == pytest.approx(speed, rel=1e-15)
    assert abs(front.attrs["speed_defect"]) <= 1e-14
    power = conditions.dissipated_power
    assert front.attrs["dissipated_power"] == pytest.approx(power, abs=1e-14)
    ends = front["velocity"].values[[0, -1]]
    np.testing.assert_allclose(ends, [speed, speed * right_state], atol=1e-13)


def test_velocity_differences_are_the_rate_of_compression():
    """v(ξ) − v(ξ+1) = −c u'(ξ), with u' by differences of the evaluated front."""
    for beta in (1.5, 1.0):
        front = gf.solve_front(1.5, 0.2, beta)
        xi, h = np.linspace(-6.0, 3.0, 37), 1e-3
        weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
        rate = sum(
            w * (gf.evaluate_front(front, xi - k * h) - gf.evaluate_front(front, xi + k * h)) / h
            for k, w in weights.items()
        )
        np.testing.assert_allclose(
            velocity_at(front, xi) - velocity_at(front, xi + 1.0), rate, atol=5e-11
        )


@pytest.mark.parametrize(
    ("alpha", "gamma", "beta"), [(1.5, 0.3, None), (1.5, 0.1, 1.0), (3.0, 0.5, None)]
)
def test_chain_carries_the_front_by_one_bead_per_bead_time(alpha, gamma, beta):
    """The chain's integrator knows nothing of the profile equation."""
    front = gf.solve_front(alpha, gamma, beta)
    centre = math.ceil(-front["xi"].values[0]) + 2
    beads = np.arange(1.0, centre + math.ceil(front["xi"].values[-1]) + 4)
    u = gf.evaluate_front(front, beads - centre)
    scene = {
        "law": {"alpha": alpha, "beta": front.attrs["beta"], "gamma": gamma},
        "beads": beads.size,
        "boundary": {"kind": "pressure", "left": 1.0, "right": 0.0},
        "start": {
            "kind": "given",
            "relative_displacement": u[:-1].tolist(),
            "velocity": velocity_at(front, beads - centre).tolist(),
        },
        "end_time": 1.0,
        "tolerance": {"relative": 1e-14, "absolute": 1e-16},
        "record": {"snapshots": [1.0]},
    }
    later = gf.simulate_chain(scene)
    u = gf.evaluate_front(front, beads - centre - 1.0)
    found = later["relative_displacement"].values[0]
    np.testing.assert_allclose(found[: beads.size - 1], u[: beads.size - 1], atol=1e-12)
    v = velocity_at(front, beads - centre - 1.0)
    np.testing.assert_allclose(later["velocity"].values[0], v, atol=1e-12)


@pytest.mark.parametrize(("alpha", "gamma"), [(1.1, 0.1), (1.5, 0.1), (1.5, 1.0), (3.0, 0.3)])
def test_tail_behind_follows_the_slowest_roots(alpha, gamma):
    """Far behind, u − 1 is in the span of the slowest root, or pair, fitted at other points."""
    root = gf.tail_roots(alpha, gamma, count=1)[0]
    front = gf.solve_front(alpha, gamma)
    xi = -math.log(1e6) / root.real + np.linspace(-1.5, 0.0, 24)
    mode = np.exp(root * (xi - xi[-1]))
    modes = np.stack([mode.real, mode.imag] if root.imag else [mode.real], axis=1)
    tail = gf.evaluate_front(front, xi) - 1.0
    amplitudes, *_ = np.linalg.lstsq(modes[::2], tail[::2], rcond=None)
    scale = np.abs(tail).max()
    assert 1e-9 < scale < 1e-3
    np.testing.assert_allclose(modes @ amplitudes, tail, atol=2e-4 * scale)


def test_tail_ahead_is_doubly_exponential():
    """With p = −ln u, p(ξ) = α p(ξ−1) − ln(γ/q + 1/q²) + o(1), q = α p'(ξ−1): rate ln α."""
    alpha, gamma = 1.5, 0.5
    front = gf.solve_front(alpha, gamma)
    xi, h = np.array([2.5, 3.0, 3.5]), 1e-3

    def p(x):
        return -np.log(gf.evaluate_front(front, x))

    q = alpha * (p(xi - 1.0 + h) - p(xi - 1.0 - h)) / (2.0 * h)
    rest = p(xi) - alpha * p(xi - 1.0) + np.log(gamma / q + 1.0 / q**2)
    assert np.abs(rest[-1]) < 0.15
    assert (np.diff(np.abs(rest)) < 0.0).all()


def test_linear_dashpot_has_an_exponential_tail_ahead():
    gamma = 1.0
    front = gf.solve_front(1.5, gamma, beta=1.0)
    rate = math.log(np.divide(*gf.evaluate_front(front, np.array([21.0, 22.0]))))
    assert rate == pytest.approx(4.0 * gamma * math.sinh(0.5 * rate) ** 2, rel=1e-3)


def test_strong_damping_leads_to_the_front_of_equation_46():
    errors = []
    for gamma in (2.0, 8.0):
        front = gf.solve_front(1.5, gamma)
        xi = np.linspace(-60.0, 20.0, 801)
        y = gf.log_burgers_front(xi / (3.0 * gamma), 1.5)
        errors.append(np.abs(gf.evaluate_front(front, xi) - y ** (2.0 / 3.0)).max())
    assert errors[1] < 0.3 * errors[0] < 0.03


def test_strong_linear_damping_leads_to_its_closed_form():
    errors = []
    for gamma in (2.0, 8.0):
        front = gf.solve_front(1.5, gamma, beta=1.0)
        xi = np.linspace(-60.0, 60.0, 801)
        closed = (1.0 + (2.0**0.5 - 1.0) * np.exp(0.5 * xi / gamma)) ** -2.0
        errors.append(np.abs(gf.evaluate_front(front, xi) - closed).max())
    assert errors[1] < 0.3 * errors[0] < 0.03


def test_weak_damping_leads_to_the_solitary_wave_of_the_conservative_chain():
    """The first peak tends to 1.487 for α = 3/2; it falls short by a first power of γ."""
    gammas = np.array([0.01, 0.02, 0.04])
    peaks = [1.0 + gf.solve_front(1.5, gamma).attrs["overshoot"] for gamma in gammas]
    limit = np.polynomial.Polynomial.fit(gammas, peaks, 2).convert().coef[0]
    assert limit == pytest.approx(1.487, abs=2e-3)


def test_overshoot_definition_of_critical_damping_meets_its_cut():
    gamma = gf.critical_damping(1.5, definition="overshoot", cut=1e-3)
    assert gf.solve_front(1.5, gamma).attrs["overshoot"] == pytest.approx(1e-3, rel=1e-10)
    assert gamma < gf.critical_damping(1.5)


def test_a_failure_is_a_record_with_a_reason():
    front = gf.solve_front(5.0, 1e-3)
    assert front.attrs["converged"] == 0
    assert front.attrs["reason"]
    assert math.isnan(front.attrs["overshoot"])
    assert np.isnan(front["relative_displacement"].values).all()
    with pytest.raises(InputError, match="has not converged"):
        gf.evaluate_front(front, 0.0)


@pytest.mark.parametrize(
    "changed",
    [
        lambda front: front.isel(xi=slice(None, None, 2)),
        lambda front: front.isel(xi=slice(100, None)),
        lambda front: front.isel(xi=slice(None, -40)),
        lambda front: front.isel(xi=[0]),
        lambda front: front.drop_sel(xi=-1.0),
        lambda front: front.assign_coords(xi=front["xi"] + 1.0),
        lambda front: front.assign_coords(xi=0.5 * front["xi"]),
    ],
    ids=["thinned", "behind", "ahead", "point", "hole", "shifted", "scaled"],
)
def test_a_front_on_another_grid_is_refused(changed):
    """Local polynomials would go through points that are not where they seem to be."""
    front = gf.solve_front(1.5, 0.3)
    assert gf.evaluate_front(front.copy(), -1.0) == front["relative_displacement"].sel(xi=-1.0)
    with pytest.raises(InputError, match="thin, crop or shift the values"):
        gf.evaluate_front(changed(front), -1.0)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"alpha": 1.0}, "linear chain"),
        ({"alpha": 0.5}, "runs the other way"),
        ({"gamma": 0.0}, "conservative chain"),
        ({"gamma": -1.0}, r"gamma is -1\.0"),
        ({"beta": 0.9}, "at least 1"),
        ({"right_state": 1.0}, r"right_state is 1\.0.*at least 0 and below 1"),
        ({"right_state": -0.1}, r"right_state is -0\.1"),
        ({"method": "guess"}, "method is 'guess'"),
    ],
)
def test_fronts_that_do_not_exist_are_refused(arguments, words):
    with pytest.raises(InputError, match=words):
        gf.solve_front(**({"alpha": 1.5, "gamma": 0.2} | arguments))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"gamma": 1e8}, "1.1e\\+10 sites"),
        ({"gamma": 1e300}, "sites"),
        ({"gamma": 1e-300}, "sites"),
        ({"alpha": 1.0 + 1e-12}, "sites"),
        ({"right_state": 1.0 - 1e-16}, "sites"),
        ({"gamma": 1e8, "beta": 1.0}, "sites"),
        ({"gamma": 1e8, "method": "shooting"}, "explicit steps"),
        ({"gamma": 1e-5, "method": "shooting"}, "beads"),
    ],
)
def test_what_cannot_be_found_is_a_record_at_once(arguments, words):
    begun = time.monotonic()
    front = gf.solve_front(**({"alpha": 1.5, "gamma": 0.2} | arguments))
    assert front.attrs["converged"] == 0
    assert re.search(words, front.attrs["reason"])
    assert time.monotonic() - begun < 5.0
