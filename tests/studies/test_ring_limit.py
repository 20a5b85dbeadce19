"""Rings in the limit α → 1: chain by Fourier series, errors of the equations and their orders."""

import functools
import math

import numpy as np
import pytest
from rings import slope_and_residual

from granular_fronts.campaign.ring_points import make_ring as ring_of_point
from granular_fronts.chain.fourier_ring import FourierRing, GapError, solve_fourier_ring
from granular_fronts.continuum.log_burgers.starts import make_start
from granular_fronts.errors import SolveError
from granular_fronts.model.amplitude_scaling import SlowScales, gamma_for
from granular_fronts.studies import ring_limit, ring_measures
from granular_fronts.studies.ring_limit import Ring, compare
from granular_fronts.studies.ring_starts import PROFILES, scene_start, slope_of, start_fields


def make_ring(alpha, profile="pulse", velocity="slow", base=0.2, **number):
    scaling = SlowScales(alpha, gamma_for(alpha, 1.0, **number), 1.0)
    half_beads = round(10.0 / scaling.epsilon + 0.5)
    start = scene_start(profile, 2.0, base, scaling.half_length(half_beads))
    return Ring(alpha, scaling.gamma, half_beads, start, velocity)


@functools.cache
def errors(alpha, velocity="slow", tolerance=1e-7, **number):
    ring = make_ring(alpha, velocity=velocity, **number)
    return compare(ring, np.array([0.5, 1.0]), tolerance)


def at_one(alpha, name, **options):
    return errors(alpha, **options)[name][0][1]


# The chain by Fourier series.


def both_motions(ring, slow_time, tolerance=1e-10):
    """The same ring by Fourier series and bead by bead, at all beads."""
    times = np.array([slow_time / ring.scaling.slow_rate])
    resolution = ring_limit.resolutions(tolerance)[0]
    beads = ring_limit._follow_beads(ring, times, resolution)
    xi = ring.scaling.epsilon * (np.arange(ring.beads) - ring.half_beads)
    start = start_fields(ring.start, ring.scaling, ring.half_length, xi, ring.velocity)
    fourier = FourierRing(ring.alpha, ring.damping, ring.beads, resolution.points(ring.half_length))
    return solve_fourier_ring(fourier, *start, times, tolerance), beads, start


@pytest.mark.parametrize("profile", PROFILES)
def test_fourier_series_and_beads_are_the_same_chain(profile):
    ring = make_ring(1.05, profile, damping=0.5)
    wave, beads, start = both_motions(ring, 0.5)
    assert ring.beads > 2 * ring_limit.resolutions(1e-8)[0].points(ring.half_length)
    for name in ("relative_displacement", "velocity"):
        # The first of the places is n = 0, which on the ring is n = N.
        found = np.roll(getattr(wave, name)[0], -1)
        np.testing.assert_allclose(found, getattr(beads, name)[0], rtol=0, atol=2e-10)
    u, velocity = start
    assert wave.relative_displacement[0].sum() == pytest.approx(u.sum(), rel=1e-13)
    assert wave.velocity[0].sum() == pytest.approx(velocity.sum(), rel=1e-13)
    assert wave.smallest.value == pytest.approx(beads.smallest.value, abs=1e-4)


def test_fourier_series_ends_where_a_contact_opens_and_the_beads_go_on():
    ring = make_ring(1.1, velocity="leading", base=1e-3, mu=0.5)
    times = np.array([0.5 / ring.scaling.slow_rate])
    usual, finer = ring_limit.resolutions(1e-6)
    with pytest.raises(GapError, match="opens"):
        ring_limit._follow_smooth(ring, times, usual)
    motions = ring_limit.follow(ring, times, usual, finer)
    assert motions.usual.smallest.value < 0.0
    assert motions.usual.site.size == ring.beads


def test_ring_is_followed_alike_at_every_length():
    """Whether places lie between beads hangs on ε alone, not on how points are rounded."""
    usual, finer = ring_limit.resolutions(1e-6)
    for alpha, per_point in ((1.5, usual.places), (1.6, None)):
        for half_beads in range(44, 52):
            ring = make_ring(alpha, mu=8)._replace(half_beads=half_beads)
            motion = ring_limit.follow(ring, np.array([1.0]), usual, finer).usual
            points = usual.points(ring.half_length)
            assert motion.site.size == (per_point * points if per_point else ring.beads)


def test_start_that_is_no_number_ends_in_an_error():
    fourier, u = FourierRing(1.5, 0.3, 40, 16), np.full(16, 1.0)
    with pytest.raises(SolveError, match="step size collapsed"):
        solve_fourier_ring(fourier, u, np.full(16, np.nan), np.array([1.0]), 1e-6)


def test_residuals_are_zero_for_the_velocities_of_their_formula():
    """y = 1 + cos(κξ)/2, whose slope and flux are known; (43) has ∂_ξ y in the place of y ln y."""
    ring = make_ring(1.1, damping=0.5)
    site = np.arange(1.0, ring.beads + 1.0)
    wave_number = np.pi / ring.half_length
    phase = wave_number * ring.scaling.epsilon * site
    y, slope = 1.0 + 0.5 * np.cos(phase), -0.5 * wave_number * np.sin(phase)
    correction = 0.5 * ring.scaling.epsilon
    velocities = {
        "leading": y,
        "printed": y - correction * (slope + 0.5 * 2.0 * slope),
        "first_order": y - correction * (slope + 0.5 * (slope + y * np.log(y))),
    }
    u = y[None] ** (1.0 / 1.1)
    for name, velocity in velocities.items():
        motion = ring_limit.Motion(site, u, velocity[None] + 0.3, np.nan)
        for other, found in ring_limit.velocity_residuals(ring, motion, [0]).items():
            assert (np.abs(found).max() < 1e-14) == (other == f"residual_{name}")


# Starts.


@pytest.mark.parametrize("profile", PROFILES)
def test_analytic_starts_are_smooth_between_their_points_and_close(profile):
    half_length = 11.3
    start = make_start(scene_start(profile, 2.0, 0.2, half_length))
    xi = np.linspace(-half_length, half_length, 301)
    exact = PROFILES[profile](xi, 2.0, 0.2, half_length)
    np.testing.assert_allclose(start.values(xi, half_length), exact, atol=1e-13)
    assert exact.min() == pytest.approx(0.2, abs=1e-5)
    # The front and its image, 2^(-2/e²) at the middle between them; the pulse is 1 there.
    top = {"pulse": 1.0, "front": 0.2 + 0.8 * 2.0 ** (-2.0 * np.exp(-2.0))}[profile]
    assert exact[150] == pytest.approx(top, abs=1e-12)


def test_slow_start_sends_less_back_than_the_start_of_the_paper():
    """What runs left has velocity −y; it falls by ε² and not by ε."""
    for velocity, order in (("leading", 1.0), ("slow", 2.0)):
        sizes, sent_back = [], []
        for alpha in (1.2, 1.1, 1.05, 1.02):
            error = at_one(alpha, "displacement_sup_dispersive", velocity=velocity, mu=2.0)
            sent_back.append(error)
            sizes.append(1.0 / make_ring(alpha, mu=2.0).scaling.epsilon)
        found, residual = slope_and_residual(sizes, sent_back)
        assert found == pytest.approx(order, abs=0.35)
        assert residual < 0.15


# Orders in ε.


@pytest.mark.parametrize("field", ["displacement_sup", "displacement_rms", "velocity_rms"])
def test_equations_of_section_4_are_of_first_order_at_fixed_damping(field):
    alphas = (1.2, 1.1, 1.05, 1.02)
    sizes = [1.0 / make_ring(alpha, damping=0.5).scaling.epsilon for alpha in alphas]
    for model in ("logarithmic", "unlimited", "dispersive"):
        found = [at_one(alpha, f"{field}_{model}", damping=0.5) for alpha in alphas]
        order, residual = slope_and_residual(sizes, found)
        assert order == pytest.approx(1.0, abs=0.2)
        assert residual < 0.12


def test_at_fixed_mu_only_the_dispersive_equation_is_a_limit():
    far, near = (
        {
            model: at_one(alpha, f"displacement_sup_{model}", mu=2.0)
            for model in ("logarithmic", "unlimited", "dispersive")
        }
        for alpha in (1.1, 1.02)
    )
    assert near["dispersive"] < 0.35 * far["dispersive"]
    for model in ("logarithmic", "unlimited"):
        assert near[model] > 0.8 * far[model]
        assert near[model] > 5.0 * near["dispersive"]


@pytest.mark.parametrize(
    ("alpha", "mu", "velocity", "known"),
    [
        (2.0, 16.0, "slow", {"residual_first_order": 0.0683513970}),
        (1.5, 4.0, "slow", {"residual_first_order": 0.042535660957576}),
        (1.5, 16.0, "leading", {"smallest_compression": 0.2965322465}),
    ],
)
def test_errors_of_maxima_hold_where_both_runs_share_their_place(
    alpha, mu, velocity, known, monkeypatch
):
    """A maximum may be at a place of both runs, and two extremes may agree by chance."""
    point = {"alpha": alpha, "delta": 1.0, "mu": mu}
    wave = {"half_length": 12.0, "half_width": 2.0, "base": 0.2}
    ring = ring_of_point(point | wave, {"profile": "pulse", "velocity": velocity})
    found = compare(ring, np.array([0.5]), 1e-8)
    usual, finer = ring_limit.resolutions(1e-11)
    tight = usual._replace(places=32), finer._replace(places=24)
    monkeypatch.setattr(ring_limit, "resolutions", lambda tolerance: tight)
    values = {name: one[0][0] for name, one in compare(ring, np.array([0.5]), 1e-11).items()}
    for name, (value, error) in found.items():
        if name.startswith(("residual", "smallest", "height")) or name.endswith(("sup", "rms")):
            exact = (values | known)[name]
            assert abs(value[0] - exact) <= 2.0 * error[0] + 1e-13, name


def test_every_number_that_gives_the_damping_gives_the_same():
    scaling = SlowScales(1.3, 0.4, 5.0)
    damping = scaling.gamma * scaling.speed
    numbers = {
        "damping": damping,
        "epsilon": scaling.epsilon,
        "ratio": scaling.ratio,
        "mu": scaling.dispersion**-0.5,
    }
    for name, value in numbers.items():
        assert gamma_for(1.3, 5.0, **{name: value}) == pytest.approx(0.4, rel=1e-14)
    assert scaling.ratio == pytest.approx(12.0 * scaling.dispersion, rel=1e-14)


def test_losses_are_passed_in_turn_before_the_slow_time_that_they_depend_on():
    ring, early = make_ring(1.2, damping=0.5), [0.03, 0.7, 1.0]
    alone, beside = (compare(ring, np.array(times), 1e-6) for times in ([1.0], early))
    for model in ring_limit.MODELS:
        name = f"lost_1_{model}"
        np.testing.assert_allclose(alone[name][0][-1], beside[name][0][-1], rtol=1e-5)
    passed = beside["lost_1_logarithmic"][0]
    # What the start still sends back passes the wave early.
    assert np.isnan(passed[0])
    assert 0.03 < passed[1] == passed[2] < 0.5
    assert np.isnan(beside["lost_10_logarithmic"][0]).all()


def test_measures_of_known_waves_are_exact():
    xi = np.arange(400) * 0.05
    wave, shifted = (np.exp(-((xi - centre) ** 2)) for centre in (10.0, 10.3))
    # The ring may be cut anywhere.
    for turn in (0, 210):
        rows = (np.roll(row, turn)[None] for row in (shifted, wave))
        assert ring_limit.lead(*rows, 0.05)[0] == pytest.approx(0.3, abs=1e-3)
    assert np.isnan(ring_limit.lead(wave[None], 0.0 * wave[None], 0.05)[0])
    wide = np.exp(-(((xi - 10.0) / 2.0) ** 2))
    [half_way] = ring_limit.lead(wide[None], wave[None], 0.05)
    assert half_way == pytest.approx(math.sqrt(math.log(2.0)), abs=1e-3)
    x = np.arange(11.0)
    rows = np.array([[3.0], [2.0]]) - 0.1 * (x - 5.3) ** 2
    np.testing.assert_allclose(ring_limit.heights(rows), [3.0, 2.0], rtol=1e-14)
    assert ring_measures._vertex(rows[0]) == pytest.approx(1.0 + 5.3, rel=1e-12)
    start = 4.0 - 0.1 * (x - 5.3) ** 2
    np.testing.assert_allclose(ring_limit.relative_decay(rows[:1], rows[1:], start), -0.5)
    times, found = np.array([1.0, 3.0]), np.array([0.2, 0.6])
    passages = [ring_limit.first_passage(times, found, level) for level in (0.1, 0.3, 0.7)]
    np.testing.assert_allclose(passages, [0.5, 1.5, np.nan])
    np.testing.assert_allclose(slope_of(np.sin, x), np.cos(x), rtol=0, atol=1e-9)
