"""Measures on data whose answer is known, each with a case in which it must answer otherwise."""

import json
import math

import numpy as np
import pytest
import xarray as xr
from chains import driven_scene
from rings import SCENES

from granular_fronts.campaign import measures as campaigns
from granular_fronts.chain import measures as chain
from granular_fronts.continuum import measures as continuum
from granular_fronts.continuum.log_burgers.equation import flux, limit_flux
from granular_fronts.fronts import measures as fronts
from granular_fronts.studies import law_measures as laws
from granular_fronts.studies import ring_measures as periodic

EXACT = {"error_estimate": 1e-15, "error_method": "given"}
DRIVEN = driven_scene(delta=0.1)
SPEED = 0.1**0.25


def driven(**variables):
    """A dataset of a driven chain from variables and their dimensions."""
    described = {name: (dims, values, EXACT) for name, (dims, values) in variables.items()}
    coordinates = {}
    for dims, values in variables.values():
        for axis, size in zip(np.atleast_1d(dims), np.shape(values), strict=True):
            first = 1 if axis.startswith("bead") else 0
            coordinates[axis] = np.arange(first, first + size)
    return xr.Dataset(described, coordinates, {"config": json.dumps(DRIVEN)})


def test_last_fall_is_where_a_line_crosses():
    places = np.array([1.0, 2.0, 4.0])
    assert chain.last_fall(np.array([1.0, 0.8, 0.0]), places, 0.4) == pytest.approx(3.0)
    # The last of two falls counts, and a rise does not.
    falling_twice = np.array([1.0, 0.0, 1.0, 0.0])
    assert chain.last_fall(falling_twice, np.arange(4.0), 0.5) == pytest.approx(2.5)
    with pytest.raises(IndexError):
        chain.last_fall(np.array([0.0, 1.0]), np.arange(2.0), 0.5)


def test_spread_and_spacing_of_peaks():
    beads = np.arange(1, 101)
    steady = driven(first_peak=("bead", np.full(100, 0.13)), arrival_time=("bead", beads / SPEED))
    assert chain.peak_spread(steady, [10, 50, 90]).value == 0.0
    assert chain.spacing_defect(steady, [10, 50, 90]).value == pytest.approx(0.0, abs=1e-12)
    growing = driven(
        first_peak=("bead", 0.1 + 1e-3 * beads), arrival_time=("bead", 1.1 * beads / SPEED)
    )
    assert chain.peak_spread(growing, [10, 50, 90]).value == pytest.approx(0.8)
    assert chain.spacing_defect(growing, [10, 50, 90]).value == pytest.approx(0.1)


def test_passages_through_the_applied_compression_are_counted():
    times = np.arange(0.0, 10.0, 0.01)
    waves = 0.1 + 0.01 * np.sin(2.0 * np.pi * times + 0.3)
    probe = driven(relative_displacement_steady=(("t_steady", "bead_steady"), waves[:, None]))
    assert chain.crossings(probe, 1).value == 20
    above = driven(
        relative_displacement_steady=(("t_steady", "bead_steady"), waves[:, None] + 0.02)
    )
    assert chain.crossings(above, 1).value == 0


@pytest.mark.parametrize(("late", "opened"), [(-0.01, 1), (0.01, 0), (-0.5e-15, 0), (-2e-15, 1)])
def test_contacts_that_open_later_by_more_than_the_error_are_counted(late, opened):
    u = np.full((5, 4), 0.05)
    u[1, 0] = -0.5
    u[4, 2] = late
    grid = driven(relative_displacement_grid=(("t_grid", "bead"), u))
    grid["smallest_relative_displacement_time"] = 2.0
    assert chain.openings_after_the_widest_gap(grid).value == opened
    assert chain.openings(grid).value == 1 + opened


@pytest.mark.parametrize("rate", [0.0, 0.02])
def test_width_of_a_front_that_spreads(rate):
    beads, times = np.arange(1, 402), np.arange(0.0, 2001.0, 5.0)
    arrival = beads / 0.5
    place = np.where(times < 802.0, 0.5 * times, 802.0 - 0.5 * times)[:, None]
    width = 10.0 + rate * times[:, None]
    u = 0.1 * np.clip(0.5 - (beads - place) / width, 0.0, 1.0)
    grid = driven(
        relative_displacement_grid=(("t_grid", "bead"), u), arrival_time=("bead", arrival)
    )
    grid = grid.assign_coords(t_grid=times)
    ratio = chain.thickening(grid)
    exact = (10.0 + rate * 1363.4) / (10.0 + rate * 962.4)
    assert ratio.value == pytest.approx(exact, abs=0.01)
    assert (chain.forward_thickening(grid).value > 1.1) is (rate > 0.0)
    assert (chain.backward_over_forward_width(grid).value > 1.1) is (rate > 0.0)


def test_velocities_ahead_of_the_front_do_not_count():
    velocity = np.array([[0.0, 0.0], [0.05, 0.0], [0.03, 0.06]])
    grid = driven(velocity_grid=(("t_grid", "bead"), velocity), arrival_time=("bead", [0.5, 1.5]))
    assert chain.smallest_velocity_behind(grid).value == pytest.approx(0.03 / 0.1**1.25)
    velocity[2, 0] = -0.01
    grid = driven(velocity_grid=(("t_grid", "bead"), velocity), arrival_time=("bead", [0.5, 1.5]))
    assert chain.smallest_velocity_behind(grid).value < 0.0


def gaussian_sweep(defect=0.0, mu=0.0):
    s = np.arange(-8.0, 8.05, 0.1)
    y = np.exp(0.5 - 0.25 * s**2)
    slope = -0.5 * s * y * (1.0 + defect)
    fields = {"rescaled_force": y, "slope": slope, "log_rescaled_force": 0.5 - 0.25 * s**2}
    variables = {name: (("mu", "s"), values[None], EXACT) for name, values in fields.items()}
    return xr.Dataset(variables, {"mu": [mu], "s": s})


def test_residual_finds_an_orbit_that_is_none():
    exact = continuum.residual_of_orbits(gaussian_sweep(), 0.0)
    assert exact.value < 1e-7
    assert exact.value == pytest.approx(exact.error, rel=0.1)
    assert continuum.residual_of_orbits(gaussian_sweep(1e-3), 0.0).value > 1e-4
    assert continuum.residual_of_orbits(gaussian_sweep(mu=0.1), 0.0).value > 0.05


def test_transition_is_where_the_squared_frequency_vanishes():
    """ω² = 1 − μ²/4, which is that of (59) linearised about y = 1."""
    mu = np.array([0.5, 1.0, 1.5, 2.5])
    frequency = np.sqrt(np.maximum(1.0 - 0.25 * mu**2, 0.0))
    fields = {"angular_frequency": frequency, "angular_frequency_error": np.full(4, 1e-6)}
    sweep = xr.Dataset({name: ("mu", values) for name, values in fields.items()}, {"mu": mu})
    assert continuum.transition(sweep).value == pytest.approx(2.0, rel=1e-12)
    # dμ = dω² / (μ/2), with the largest 2ω dω.
    assert continuum.transition(sweep).error == pytest.approx(2e-6 * frequency[0], rel=1e-12)


def test_steepness_is_taken_ahead_of_where_the_front_first_reaches_one():
    """The Gaussian falls behind its peak too, where it is above 1 and does not count."""
    assert continuum.smallest_steepness(gaussian_sweep()).value > 0.5
    rising = gaussian_sweep()
    rising["slope"] = -rising["slope"]
    assert continuum.smallest_steepness(rising).value < 0.0


def test_flux_distance_is_relative_to_the_largest_flux():
    y = np.linspace(0.0, 1.0, 401)
    tabulated = xr.Dataset(
        {"flux": (("alpha", "force"), [flux(y, 1.5)]), "flux_limit": ("force", limit_flux(y))},
        {"alpha": [1.5], "force": y},
    )
    everywhere = continuum.flux_distance(tabulated, 1.5)
    y = np.linspace(1e-6, 1.0, 100_001)
    exact = math.e * np.abs(flux(y, 1.5) - limit_flux(y)).max()
    assert everywhere.value == pytest.approx(exact, abs=1e-4)
    assert continuum.flux_distance(tabulated, 1.5, 0.5).value < 0.5 * everywhere.value


def test_extremes_of_a_velocity_are_located_between_grid_points():
    xi = np.arange(-6.0, 3.0, 0.1)
    velocity = np.where(xi < 1.0, 1.0 + 0.3 * np.cos(1.7 * xi), 0.0)
    front = xr.Dataset({"velocity": ("xi", velocity, EXACT)}, {"xi": xi})
    assert fronts.velocity_overshoot(front).value == pytest.approx(0.3, abs=1e-5)
    smallest = fronts.smallest_velocity_behind(front)
    assert smallest.value == pytest.approx(0.7, abs=1e-5)
    assert abs(smallest.value - 0.7) <= smallest.error


def ring(chain, equation):
    """Snapshots at t = 0 of a ring of 39 beads and of the equation, from functions of the site."""
    scene = SCENES["weak"] | {"law": {"alpha": 1.5, "gamma": 0.24}, "half_beads": 20}
    scene |= {"start": {"kind": "plateau", "half_width": 1.0, "floor": 0.1}}
    beads, sites = np.arange(1, 40), np.arange(1.0, 40.0, 0.2)
    return xr.Dataset(
        {
            "relative_displacement": (("t", "bead"), [chain(beads)]),
            "relative_displacement_logarithmic": (("t", "site"), [equation(sites)]),
        },
        {"t": [0.0], "bead": beads, "site": sites},
        {"config": json.dumps(scene)},
    )


def test_profiles_of_one_shape_are_correlated():
    def pulse(n):
        return 5.0 * np.exp(-(((n - 20.0) / 6.0) ** 2))

    alike = periodic.profile_correlation(ring(pulse, lambda n: 0.8 * pulse(n)))
    assert alike.value == pytest.approx(1.0, abs=1e-12)
    gap = periodic.profile_correlation(ring(lambda n: pulse(n) - 50.0 * (n == 1), pulse))
    assert gap.value > 0.999
    displaced = periodic.profile_correlation(ring(pulse, lambda n: pulse(n + 12.0)))
    assert displaced.value < 0.3


def jumps(**variables):
    """Fronts of two laws, of Hertz's force from −1 into rest and of an FPU force from 0 to 1."""
    cases = {
        "hertz": {"elastic": {"kind": "hertz", "alpha": 1.5}, "states": [-1, 0]},
        "fpu": {"elastic": {"kind": "fpu", "cubic": 3}, "states": [0, 1]},
    }
    described = {name: ("law", values) for name, values in variables.items()}
    return xr.Dataset(described, {"law": list(cases)}, {"config": json.dumps({"cases": cases})})


def test_the_worst_law_and_way_of_measuring_counts():
    fronts = jumps(
        speed_expected=[1.0, -2.0],
        speed_expected_error=[0.01, 0.01],
        speed_exact=[1.01, -2.0],
        speed_exact_error=[0.01, 0.01],
        speed_driven=[1.0, -2.12],
        speed_driven_error=[0.01, 0.03],
    )
    assert laws.worst_agreement(fronts, "speed").value == pytest.approx(3.0)
    close = fronts.assign(speed_driven=("law", [1.0, -2.02]))
    assert laws.worst_agreement(close, "speed").value == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("speeds", "margin"),
    [([1.0, -2.0], 1.0 - 1.5**-0.5), ([1.3, -2.0], None), ([1.0, -0.9], None)],
)
def test_fronts_are_slower_than_sound_behind_and_faster_than_sound_ahead(speeds, margin):
    """Sound: (3/2)^(1/2) behind Hertz's front, which runs into 0; 7^(1/2) and 1 for FPU."""
    fronts = jumps(speed_driven=speeds, speed_driven_error=[1e-9, 1e-9], direction=[1.0, -1.0])
    value, error = laws.sonic_margin(fronts)
    assert (value > 0.0) is (margin is not None)
    if margin is not None:
        assert value == pytest.approx(margin)
        assert error == pytest.approx(1e-9 / 1.5**0.5)
    with_wrong_direction = fronts.assign(direction=-fronts["direction"])
    assert laws.sonic_margin(with_wrong_direction).value < 0.0


def test_the_spread_of_speeds_is_that_of_the_laws_named():
    fronts = jumps(speed_travelling=[1.0, 1.5], speed_travelling_error=[1e-9, 3e-9])
    assert laws.speed_spread(fronts, ["hertz", "fpu"]) == (0.5, 6e-9)
    assert laws.speed_spread(fronts, ["hertz"]).value == 0.0


def test_mean_compression_of_an_oscillation_is_that_of_its_period():
    t = np.arange(61.0)
    swinging = 0.1 * (0.5 - 0.25 * np.cos(2.0 * np.pi * t / 20.0) + 0.01 * (t > 50.0))
    mean = chain.mean_compression(driven(mean_relative_displacement=("t_grid", swinging)))
    assert mean.value == pytest.approx(0.5, abs=1e-13)
    assert mean.error < 1e-13
    steady = driven(mean_relative_displacement=("t_grid", 0.1 * t / 60.0))
    assert math.isnan(chain.mean_compression(steady).value)


def test_middle_compression_is_midway_between_the_extremes_after_the_first_maximum():
    t = np.arange(61.0)
    swinging = 0.1 * (0.5 - 0.25 * np.cos(2.0 * np.pi * t / 20.0))
    middle = chain.middle_compression(driven(mean_relative_displacement=("t_grid", swinging)))
    assert middle.value == pytest.approx(0.5, abs=1e-13)
    assert middle.error == pytest.approx(0.5 * np.abs(np.diff(swinging)).max() / 0.1)
    rising = driven(mean_relative_displacement=("t_grid", 0.1 * t / 60.0))
    assert math.isnan(chain.middle_compression(rising).value)


ORDERS = {"logarithmic": 1.0, "unlimited": 0.9, "dispersive": 1.1}
ALPHA = np.array([1.01, 1.05, 1.1, 1.5])


def rings_of_campaign(axis, values, power):
    """Rings whose errors are powers of ε, but for α = 3/2."""
    epsilon = np.outer(np.ones(len(values)), ALPHA - 1.0)
    errors = {
        f"displacement_sup_{name}": ((axis, "alpha"), epsilon ** power(order) + (ALPHA > 1.4))
        for name, order in ORDERS.items()
    }
    dataset = xr.Dataset(
        errors | {"epsilon_of_ring": ((axis, "alpha"), epsilon)}, {axis: values, "alpha": ALPHA}
    )
    return dataset.expand_dims(slow_time=[1.0])


def test_extreme_orders_are_those_of_all_equations_and_dampings():
    damping = rings_of_campaign("damping", [0.3, 3.0], lambda order: order)
    gamma = rings_of_campaign("case", [0], lambda order: order + 0.05).isel(case=0)
    assert campaigns.smallest_order(damping, gamma).value == pytest.approx(0.9, abs=1e-12)
    assert campaigns.largest_order(damping, gamma).value == pytest.approx(1.15, abs=1e-12)


def test_best_equation_of_a_map():
    """(55) is best up to γ = 0.2, (40) from 0.8 on, a ring that is not solved left out."""
    gamma = np.array([0.1, 0.2, 0.4, 0.8, 1.6])
    dims = ("slow_time", "gamma", "alpha")
    ones = np.ones((1, gamma.size, ALPHA.size))
    errors = {
        "dispersive": ones * gamma[:, None],
        "unlimited": ones * 0.5 / gamma[:, None],
        "logarithmic": ones * np.where(gamma == 0.4, 0.1, 0.9)[:, None],
    }
    errors["unlimited"][0, 4, 0] = np.nan
    errors["dispersive"][0, :, 3] = -9.0
    dataset = xr.Dataset(
        {f"displacement_sup_{name}": (dims, values) for name, values in errors.items()},
        {"slow_time": [1.0], "gamma": gamma, "alpha": ALPHA},
    )
    assert campaigns.best_up_to(dataset, "displacement_sup_dispersive").value == 0.2
    assert campaigns.best_from(dataset, "displacement_sup_unlimited").value == 0.8
