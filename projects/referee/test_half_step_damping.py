"""What the half-step scheme does to a front: times, roots, measurements, and their checks."""

import json
import math
import re
from pathlib import Path
from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from scipy.integrate import quad

from granular_fronts.errors import InputError, SolveError
from granular_fronts.fronts.linear.tails import tail_roots
from granular_fronts.model.collision import restitution
from granular_fronts.referee.measurements import excess_by_table
from granular_fronts.referee.problems import collision_time
from granular_fronts.reference_methods.half_step import Chain, integrate
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import merge, read_yaml
from half_step_damping import half_step_damping
from half_step_motions import (
    Case,
    accurate_chain,
    compare_motion,
    half_step_chain,
    passing,
    read_motion,
)
from half_step_study import (
    collision_loss,
    compare_half_steps,
    excess_damping,
    excess_of_tail,
    order_of_half_steps,
    tail_root,
)
from referee_settings import HalfStepDamping

U = "relative_displacement"
UNIT = collision_time(1.5)
CASE = Case(1.5, 1.5, 0.1, 24, 10 * UNIT)
SCENE = {
    "alpha": 1.5,
    "betas": [1.5, 1.0],
    "gammas": [0.05, 0.13],
    "beads": 24,
    "collision_times": 10,
    "steps_per_collision": [160, 320, 80],
    "shown": {"beta": 1.5, "gamma": 0.13, "steps_per_collision": 20},
}


@pytest.fixture(scope="module")
def measured():
    return compare_half_steps(**SCENE)


@pytest.mark.parametrize("alpha", [1.0, 1.5, 3.0])
def test_collision_time_is_that_of_two_beads(alpha):
    """2∫du/u̇ up to the largest u, with u̇² = 1 − 4u^(α+1)/(α+1) and u = u_max sin²θ."""
    largest = (0.25 * (alpha + 1.0)) ** (1.0 / (alpha + 1.0))

    def time_per_angle(angle):
        share = math.sin(angle) ** 2
        return math.sin(2.0 * angle) / math.sqrt(1.0 - share ** (alpha + 1.0))

    passed, _ = quad(time_per_angle, 0.0, 0.5 * math.pi)
    assert collision_time(alpha) == pytest.approx(2.0 * largest * passed, rel=1e-9)


@pytest.mark.parametrize("beta", [1.0, 1.5])
def test_root_of_the_scheme_is_the_tail_root_without_a_step(beta):
    case = CASE._replace(beta=beta)
    exact = tail_roots(1.5, 0.1, beta, count=1)[0]
    distances = [abs(tail_root(case, h) - exact) for h in (0.02, 0.01, 0.005)]
    assert math.log2(distances[0] / distances[1]) == pytest.approx(1.0, abs=0.05)
    assert math.log2(distances[1] / distances[2]) == pytest.approx(1.0, abs=0.03)
    excess = excess_of_tail(case, 0.05)
    roots = tail_roots(1.5, 0.1 * (1.0 + excess), beta, count=1)
    assert roots[0].real == pytest.approx(tail_root(case, 0.05).real, rel=1e-11)


def test_motion_of_the_scheme_has_its_root():
    """Behind a driven front extremes of u − 1 follow each other as the root says."""
    case, step = Case(1.5, 1.5, 0.13, 240, 80 * UNIT), UNIT / 10
    motion = half_step_chain(case, step)
    u = motion.x[:, 119] - motion.x[:, 120]
    rate = motion.v[:, 119] - motion.v[:, 120]
    turns = np.flatnonzero((np.sign(rate[1:]) != np.sign(rate[:-1])) & (u[1:] > 0.5))
    times, sizes = motion.t[turns], np.abs(u[turns] - 1.0)
    kept = (sizes < 0.06) & (sizes > 0.002)
    decay = -np.polyfit(times[kept], np.log(sizes[kept]), 1)[0]
    spacing = np.diff(times[kept]).mean()
    root, plain = tail_root(case, step), tail_roots(1.5, 0.13, count=1)[0]
    assert kept.sum() >= 4
    assert math.pi / spacing == pytest.approx(root.imag, rel=0.02)
    assert abs(plain.imag / root.imag - 1.0) > 0.05
    assert decay == pytest.approx(root.real, rel=0.05)


def test_loss_of_a_collision_is_the_mean_over_the_phases_of_a_step():
    step, phases = 0.2 * UNIT, (np.arange(400) + 0.5) / 400
    starts = ([-phase * step, 0.0] for phase in phases)
    ends = [integrate(Chain(1.5, 1.5, 0.1), x, [1.0, 0.0], step, 20).v[-1] for x in starts]
    losses = 1.0 - np.diff(ends, axis=1)[:, 0]
    half = abs(losses[:200].mean() - losses.mean())
    assert collision_loss(CASE, step) == pytest.approx(losses.mean(), abs=0.1 * half)


def test_damping_added_to_the_accurate_chain_is_read_as_such():
    factors = (0.97, 1.0, 1.07, 1.17, 1.3)
    table = [accurate_chain(CASE._replace(gamma=0.1 * factor))[0].peak for factor in factors]
    peak, _ = accurate_chain(CASE._replace(gamma=0.1 * 1.023))
    assert excess_by_table(np.array(peak.peak), factors, table) == pytest.approx(0.023, abs=2e-6)
    # Beyond the table nothing is read.
    outside = np.array([table[0] + 1e-6, table[-1] - 1e-6, -100.0, 100.0])
    assert np.isnan(excess_by_table(outside, factors, table)).all()


def test_stated_error_of_the_excess_is_that_of_the_table(measured):
    """Against a table of twice as many dampings."""
    factors = (0.96, 0.98, 1.0, 1.05, 1.1, 1.15, 1.2, 1.25, 1.32)
    case, one = CASE._replace(gamma=0.13), measured.sel(beta=1.5, gamma=0.13)
    table = [accurate_chain(case._replace(gamma=0.13 * factor))[0].peak for factor in factors]
    finer = excess_by_table(one["peak"].values, factors, table)
    error = np.abs(one["excess_overshoot"] - finer).max()
    assert error <= 2.0 * measured["excess_overshoot"].attrs["error_estimate"] < 1e-4


def test_orders_and_excess_are_of_first_order(measured):
    np.testing.assert_allclose(measured["order"], 1.0, rtol=0, atol=0.06)
    for observable in ("overshoot", "tail"):
        excess = measured[f"excess_{observable}"]
        halved = excess.isel(step=1) / excess.isel(step=2)
        np.testing.assert_allclose(halved, 2.0, rtol=0, atol=0.08)
    steps = measured["step"]
    assert np.all(np.diff(steps) < 0.0)
    # Of the size of h/t_c, and more than the tail says.
    assert np.all(measured["excess_overshoot"] < 1.5 * steps)
    assert np.all(measured["excess_overshoot"] > 0.3 * steps)
    assert np.all(measured["excess_overshoot"] > 1.2 * measured["excess_tail"])


def test_findings_are_measured_where_they_are_named_and_nowhere_else(measured):
    one = measured.sel(beta=1.5, gamma=0.13)
    found = excess_damping(measured, "tail", 1.5, 0.13, 160)
    assert (found.value, found.error) == (float(one["excess_tail"][1]), 1e-12)
    found = order_of_half_steps(measured, 1.5, 0.13)
    assert (found.value, found.error) == (float(one["order"]), float(one["order_error"]))
    with pytest.raises(KeyError):
        excess_damping(measured, "tail", 1.5, 0.13, 150)


def test_checks_do_not_see_what_the_front_shows(measured):
    excess = measured["excess_overshoot"].sel(beta=1.5, gamma=0.13)
    for name in ("restitution", "momentum", "energy", "speed"):
        assert np.all(measured[f"{name}_defect"] < 0.1 * excess)
    assert np.all(measured["momentum_defect"] < 1e-13)
    energy = measured["energy_defect"].values
    np.testing.assert_allclose(np.log2(energy[:-1] / energy[1:]), 2.0, rtol=0, atol=0.2)
    # They do see damping that is really there: 5 % more of it, 4 % more of the loss.
    exact = 1.0 - restitution(CASE.gamma)
    more = collision_loss(CASE._replace(gamma=1.05 * CASE.gamma), UNIT / 100) / exact - 1.0
    assert more > 0.04 > 20.0 * abs(collision_loss(CASE, UNIT / 100) / exact - 1.0)


def test_motions_differ_by_an_error_of_first_order():
    motions = [compare_motion(CASE, UNIT / steps) for steps in (40, 80)]
    coarse, fine = (float(abs(one[f"{U}_method"] - one[f"{U}_accurate"]).max()) for one in motions)
    assert 1e-4 < coarse < 0.1
    assert coarse / fine == pytest.approx(2.0, abs=0.3)


def test_level_and_peak_between_two_steps_are_those_of_a_sine():
    t = np.linspace(0.0, 3.0, 31)
    x, v = (np.stack([1.2 * wave(t), 0.0 * t], axis=1) for wave in (np.sin, np.cos))
    motion = SimpleNamespace(t=t, x=x, v=v)
    for event, exact in (("arrival", (math.asin(0.5 / 1.2), 0.5)), ("peak", (0.5 * math.pi, 1.2))):
        assert passing(motion, 1, event) == pytest.approx(exact, abs=1e-5)


def test_measurements_of_both_chains_are_of_the_same_thing():
    case = CASE._replace(gamma=1e-9)
    fine, (exact, _) = read_motion(case, half_step_chain(case, UNIT / 400)), accurate_chain(case)
    assert fine.peak == pytest.approx(exact.peak, abs=1e-4)
    np.testing.assert_allclose(fine.arrivals, exact.arrivals, rtol=0, atol=1e-4)
    with pytest.raises(SolveError, match="Contact 12 does not pass its peak before"):
        passing(half_step_chain(case._replace(end_time=UNIT), UNIT / 20), 12, "peak")


def test_figure_shows_what_was_measured(measured):
    data = measured.assign_attrs(config=json.dumps(SCENE))
    figure = half_step_damping(data)
    plt.close(figure)
    panels = {axes.get_label(): axes for axes in figure.axes}
    shown = data.sel(beta=1.5, gamma=0.13)
    names = ("excess_overshoot", "excess_tail", "restitution_defect", "energy_defect")
    curves = panels["checks"].get_lines()
    for line, name in zip(curves, (*names, "speed_defect"), strict=False):
        assert_curve(line, shown["step"], shown[name])
    for line, name in zip(panels["motion"].get_lines(), ("accurate", "method"), strict=True):
        assert_curve(line, data["t"], data[f"{U}_{name}"])
    for panel, name in (("excess", "excess_overshoot"), ("error", "error")):
        for line, beta in zip(panels[panel].get_lines(), data["beta"].values, strict=True):
            assert_curve(line, data["step"], data[name].sel(beta=beta, gamma=0.13))


def assert_curve(line, x, y):
    np.testing.assert_array_equal(line.get_xdata(), x)
    np.testing.assert_array_equal(line.get_ydata(), y)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"alpha": 2}, "alpha is 2, above its limit 1.5"),
        ({"gammas": [0.05, 0.2]}, "gammas (entry 2) is 0.2, above its limit 0.13"),
        ({"shown": {"beta": 1.1}}, "shown.beta is 1.1, but betas are 1.5, 1.25, 1"),
        ({"beads": 10**4, "collision_times": 1000, "steps_per_collision": [10, 99, 10**4]}, "GiB"),
    ],
)
def test_impossible_settings_are_named(change, sentence):
    own = read_yaml(Path(__file__).with_name("config.yaml"))
    with pytest.raises(InputError, match=re.escape(sentence)):
        read_part(HalfStepDamping, merge(own, change))
