"""Measures behind the statements on datasets whose answers, and errors, follow by hand."""

import json
import math

import numpy as np
import pytest
from by_hand import ANY, assert_measures, dataset, estimates
from tabulate_statements import find_measure

from granular_fronts.accuracy import tabulated
from granular_fronts.chain import measures as chain
from granular_fronts.continuum import measures as continuum
from granular_fronts.fronts import measures as fronts
from granular_fronts.model.collision import restitution
from granular_fronts.scenes.yaml_files import read_yaml
from granular_fronts.studies import law_measures as laws
from granular_fronts.studies import ring_measures as ring
from granular_fronts.studies.chain_scenes import kuwabara_kono, pressed_chain
from projects import ROOT

# δ = 1/16 and α = 3/2: the front has the speed 1/2, its beads the velocity 1/32, the pressure 1/64.
T, N = np.arange(11.0), np.arange(1, 9)
VELOCITY = np.zeros((11, 8))
VELOCITY[5:, -2], VELOCITY[9:, -2], VELOCITY[3, 2] = 3.0, 4.0, -0.25
# Before the front has arrived.
VELOCITY[1, -1] = -0.5
# Contact 2 opens before the widest gap, contact 4 after it; -0.5e-3 of contact 6 is not certain.
DISPLACEMENT = np.full((11, 8), 0.05)
DISPLACEMENT[2, 1], DISPLACEMENT[9, 3], DISPLACEMENT[9, 5] = -0.5, -1.5e-3, -0.5e-3
CROSSING = np.array([[1.1], [0.9], [0.8], [1.3], [1.2], [0.1]]) / 16
LAW, TOLERANCE = kuwabara_kono(1.5, 0.1), (1e-9, 1e-11)
CHAIN_SCENE = pressed_chain(LAW, 8, 10.0, TOLERANCE, {"snapshots": []}, 1 / 16)
CHAIN = dataset(
    CHAIN_SCENE,
    front_speed=({}, 0.7),
    first_peak=({"bead": N}, np.where(N == 4, 0.09, 0.07)),
    largest_relative_displacement=({}, 0.08),
    smallest_relative_displacement=({}, -3.0),
    smallest_relative_displacement_time=({}, 7.0),
    first_gap_time=({}, 5.0),
    total_velocity=({"t_grid": T}, 1.5 * T / 64),
    velocity_grid=({"t_grid": T, "bead": N}, VELOCITY),
    relative_displacement_grid=({"t_grid": T, "bead": N}, DISPLACEMENT),
    # It falls through v_p/2 twice, at beads 3/2 and 4.
    velocity=({"t": [0.0], "bead": N}, [(N != 2) * np.clip(1.5 - N / 4, 0, 1) / 32]),
    relative_displacement_steady=({"t_steady": None, "bead_steady": [3]}, CROSSING),
    arrival_time=({"bead": N}, N * 3 / 8),
)
# The mean compression has a period of 20 about half of δ, before a disturbance, or grows.
LATER = np.arange(61.0)
SWING = 0.5 - 0.25 * np.cos(2.0 * np.pi * LATER / 20.0) + 0.01 * (LATER > 50.0)
SWINGING, RISING = (
    dataset(CHAIN_SCENE, mean_relative_displacement=({"t_grid": LATER}, values / 16))
    for values in (SWING, LATER / 60)
)
# A front of width 10 + t/10 runs to bead 50 until t = 100, and back.
LONG, ALONG = np.arange(201.0), np.arange(1.0, 62.0)
PLACE = 50.0 - 0.5 * abs(LONG - 100.0)[:, None]
SPREADING = dataset(
    CHAIN_SCENE,
    arrival_time=({"bead": ALONG}, np.minimum(2.0 * ALONG, 100.0)),
    relative_displacement_grid=(
        {"t_grid": LONG, "bead": ALONG},
        np.clip(0.5 - (ALONG - PLACE) / (10.0 + 0.1 * LONG[:, None]), 0.0, 1.0) / 16,
    ),
)

LAWS = dataset(
    gamma=({"material": ["glass", "steel"]}, [0.008, 0.05]),
    order=({"step": None}, [1.9, 1.8, 2.0]),
    order_two_stages=({"step": None}, [2.9, 2.8, 2.7]),
    conserved_velocity_drift=({}, 1e-13),
    contact_time=({"impact_velocity": [0.01, 1.0, 100.0]}, 3.0 * np.array([0.01, 1, 100]) ** -0.2),
    indentation=({"impact_velocity": [0.01, 1.0, 100.0]}, 3.0 * np.array([0.01, 1, 100]) ** 0.8),
    ring_distance=({"exponent": [1.1, 1.2, 1.4]}, 3.0 * np.array([0.1, 0.2, 0.4]) ** 0.7),
    softening_speed=({"strain_ahead": [0.1, 1e-12]}, [-2.0, -1.0]),
    speed_exact=({"law": ["softening"]}, [-1.5]),
    speed_expected=({"law": ["softening"]}, [-2.0]),
)
# Hertz's force from −1 into rest, and an FPU force from 0 to 1, of the same power and speed.
CASES = {
    "hertz": {"elastic": {"kind": "hertz", "alpha": 1.5}, "states": [-1, 0]},
    "fpu": {"elastic": {"kind": "fpu", "cubic": 3}, "states": [0, 1]},
}


def jumps(driven=(1.0, -2.0), direction=(1.0, -1.0), **ways):
    """Fronts of two laws, with the speed 1 and −2 of theory, measured in different ways."""
    described = {
        "direction": direction,
        "speed_expected": [1.0, -2.0],
        "speed_expected_error": [0.01, 0.01],
        "speed_driven": driven,
        "speed_driven_error": [0.01, 0.03],
    } | ways
    laws = {"law": list(CASES)}
    return dataset({"cases": CASES}, **{name: (laws, of) for name, of in described.items()})


TRAVELLING = jumps(speed_travelling=[1.0, 1.5], speed_travelling_error=[1e-9, 3e-9])
# Sound: (3/2)^(1/2) behind Hertz's front, which runs into 0; 7^(1/2) and 1 for FPU.
SOUND, FAST = math.sqrt(1.5), math.sqrt(7.0)
VELOCITIES = {"beta": [1.0, 1.5], "velocity_ratio": [0.01, 1.0, 100.0]}
REGIMES = dataset(
    gamma=(VELOCITIES, [[0.1, 0.1, 0.1], [0.04, 0.2, 1.0]]),
    restitution=(VELOCITIES, [[0.0, 0.2, 0.3], [0.9, 0.5, 0.2]]),
)
VARIABLES = ["positions_and_w", "positions_and_velocities"]
SCHEMES = {"form": VARIABLES, "scheme": ["euler", "rk4"]}
QUOTIENTS = {"form": VARIABLES, "beta": [1.0, 1.5]}
CHOICE = dataset(
    observed_order=(SCHEMES, [[1.0, 2.5], [1.0, 1.5]]),
    observed_order_error=(SCHEMES, [[0.1, 0.2], [0.3, 0.4]]),
    quotient_power=(QUOTIENTS, [[0.0, 0.5], [-1.0, -0.5]]),
    quotient_power_error=(QUOTIENTS, [[0.1, 0.2], [0.3, 0.4]]),
)
WAVES = dataset(
    oscillation=({"gamma": [0.0, 0.06], "t": [1.0, 2.0, 4.0]}, [[4, 5, 6], [2, 1, 0.5]]),
    oscillation_error=({"gamma": [0.0, 0.06], "t": [1.0, 2.0, 4.0]}, np.full((2, 3), 0.1)),
    width=({"alpha": [1.0], "t": [1.0, 2.0, 4.0]}, [[10.0, 15.0, 20.0]]),
    width_error=({"alpha": [1.0], "t": [1.0, 2.0, 4.0]}, [[0.1, 0.2, 0.4]]),
)

TWO_METHODS = ("relative_displacement", "relative_displacement_shooting")
FRONT = dataset(
    attrs={"alpha": 1.5, "overshoot": 0.44, "error_estimate": 1e-3, "dissipated_power": 0.1}
    | {"dissipated_power_error": 2e-3},
    velocity=({"xi": [0.0]}, [0.0]),
    velocity_logarithmic=({"xi": [0.0]}, [0.0]),
)
FRONT["velocity_logarithmic"].attrs |= {"distance": 0.3, "distance_error": 5e-4}
# Vertices of the parabolas through 1, 1.4, 1.2 and, behind the middle, 0.8, 0.6, 0.9.
RIPPLED = dataset(velocity=({"xi": [-4, -3, -2, -1, 1, 2, 3]}, [0.8, 0.6, 0.9, 1, 1.4, 1.2, 0]))
SHOT = [dataset(error=e, **dict.fromkeys(TWO_METHODS, ({}, 0.0))) for e in (3e-14, 1e-14)]
for front, distance in zip(SHOT, (1e-14, 2e-14), strict=True):
    front["relative_displacement_shooting"].attrs["distance"] = distance
PEAKS = dataset(
    attrs={"overshoot_cut": 0.02},
    equal_peaks=({"alpha": [1.0, 1.25, 1.5, 1.75, 2.0]}, [np.nan, 0.0, 0.01, 0.04, 0.05]),
)
CURVES = dataset(
    attrs={"exchange_exponent": 1.25},
    critical_damping_tail=({"alpha": [1.02, 1.5]}, [0.08, 0.25]),
    critical_damping_long_wave=({"alpha": [1.02, 1.5]}, [0.1, 0.5]),
)
EXPONENTS = [1.02, 1.05, 1.5]
TRENDS = dataset(
    tail_frequency=({"beta": [1.0, 1.5], "piston_velocity": [1.0, 0.01]}, [[2, 0], [0.5, 3]]),
    gaussian_distance=({"exponent": EXPONENTS}, [0.01, 0.02, 0.13]),
    solitary_peak=({"exponent": EXPONENTS}, [1.0, 1.5, 2.25]),
    # Its powers of 1 − 1/α, which is 1/51, 1/21 and 1/3, are −1/2 and −1/4.
    width_of_exponent=({"exponent": EXPONENTS}, [51**0.5, 21**0.5, 21**0.5 / 7**0.25]),
    critical_gamma=({"displacement": [0.01, 1.0]}, [0.3 * 100**0.25, 0.3]),
    width_of_displacement=({"displacement": [0.01, 1.0]}, [1.0, 4.0]),
)
# The slope of the last pair is −7/4, that of the pair before −3/2.
STRONG = {"alpha": [1.5], "gamma": [0.5, 1.0, 2.0, 4.0]}
SURVEY = dataset(distance_unlimited=(STRONG, [[9.0, 1.0, 2.0**-1.5, 2.0**-3.25]]))
POWERS = dataset(
    power_expected=({"law": ["one", "other"]}, [2.0, -4.0]),
    power_exact=({"law": ["one", "other"]}, [2.0002, -4.004]),
    power_exact_error=({"law": ["one", "other"]}, [1e-3, 4e-5]),
)

# Fronts y = 1/(1 + e^(ks)), for which −y'/(y (1 − y)) = k; μ = 0 has the Gaussian of Remark 8.
MU, S, RATE = np.array([0.0, 0.3, 1.0, 2.5, 3.0]), np.linspace(-9.0, 9.0, 181), [1, 5, 4, 3, 2]
FORCE = 1.0 / (1.0 + np.exp(np.outer(RATE, S)))
SLOPE = -np.array(RATE)[:, None] * FORCE * (1.0 - FORCE)
FORCE[0] = np.exp(0.5 - 0.25 * (S + 2.0 * math.sqrt(0.5 + math.log(2.0))) ** 2)
FORCE[0, 50] += 0.25
ORBITS = dataset(
    squared_slope_at_one=({"mu": MU}, [5.0, 4.0, 3.0, 1e-40, 2e-40]),
    rescaled_force=({"mu": MU, "s": S}, FORCE),
    slope=({"mu": MU, "s": S}, SLOPE),
    growth_rate=({"mu": MU}, [0.0, 0.3, 0.0, 0.0, 3.0 - math.sqrt(5.0)]),
    growth_rate_error=({"mu": MU}, np.full(5, 0.15)),
    angular_frequency=({"mu": MU}, np.sqrt(np.maximum(1.0 - MU**2 / 4.0, 0.0))),
    angular_frequency_error=({"mu": MU}, np.full(5, 1e-6)),
)
# Behind a peak y falls and rises again, which does not count.
PEAKED = ORBITS.sel(mu=[2.5, 3.0]).copy(deep=True)
PEAKED["rescaled_force"][:, S < -5.0], PEAKED["rescaled_force"][:, S < -7.0] = 1.1, 0.5
PEAKED["slope"][:, S < -7.0] = 9.0
TABULATED = dataset(
    flux=({"alpha": [1.5], "force": [0.0, 0.5, 1.0]}, [[0.0, 0.1, 0.5]]),
    flux_limit=({"force": [0.0, 0.5, 1.0]}, [0.0, 0.3, 0.4]),
    front=({"alpha": [1.5], "xi": [0.0, 1.0, 2.0]}, [[1.0, 0.25, 0.0]]),
    front_limit=({"xi": [0.0, 1.0, 2.0]}, [1.0, 0.5, 0.0]),
)

# δ = 16, γ = 1/6: c = 2, γc = 1/3, ε = 1, μ = 2, velocities of 32; the frame moves 7 beads in 3.
RING = {
    "law": {"alpha": 1.5, "gamma": 1.0 / 6.0},
    "displacement": 16.0,
    "half_beads": 20,
    "start": {"kind": "plateau", "half_width": 10.0, "floor": math.exp(-2.0)},
    "end_time": 10.0,
    "tolerance": {"relative": 1e-9, "absolute": 1e-9},
    "equations": {"logarithmic": {"cells": 160, "tolerance": 1e-5}},
    "record": {"snapshots": [10.0], "grid": {"step": 1.0}},
}
UPWIND = {"equations": RING["equations"] | {"upwind": {"points": 100}}}


def shock(place, height, sites, floor=0.0, slope=0.25):
    """A plateau of 22 beads on the ring that falls through u = δ/2 at a place."""
    behind = (place - sites + 15.0) % 39.0 - 15.0
    return 16.0 * np.clip(0.5 + slope * behind, floor, height)


TIMES, BEADS, SITES = [0.0, 3.0, 6.0], np.arange(1.0, 40.0), np.arange(1.0, 40.0, 0.5)
AT_BEADS, AT_SITES = {"t": TIMES, "bead": BEADS}, {"t": TIMES, "site": SITES}
BUMPS = [(0.0, 25), (1.6, 25), (1.6, 24), (1.6, 23)]
SHOCKS = dataset(
    RING | UPWIND,
    relative_displacement=(AT_BEADS, [shock(place, 1.0, BEADS) for place in (22, 28, 36)]),
    relative_displacement_logarithmic=(
        AT_SITES,
        [shock(21, 1.25, SITES), shock(27, 0.8, SITES, 0.01, 0.5), shock(33.5, 0.8, SITES)],
    ),
    # A bump on the shock at bead 28 moves from bead 25 to 23.
    relative_displacement_grid=(
        {"t_grid": [0.0, 3.0, 4.0, 5.0], "bead": BEADS},
        [shock(28, 1, BEADS) + np.maximum(b - 0.8 * abs(BEADS - n), 0.0) for b, n in BUMPS],
    ),
    relative_displacement_upwind=(AT_SITES, [1.1 * shock(30, 1.0, SITES)] * 3),
    velocity=(AT_BEADS, np.full((3, 39), 32.0)),
    velocity_logarithmic=(AT_SITES, np.where(SITES == 5.0, -0.32, 38.4) * np.ones((3, 1))),
    velocity_upwind=(AT_SITES, np.full((3, 78), 40.0)),
)
SMALLER, TALLER = (
    SHOCKS.assign_attrs(config=json.dumps(RING | {"displacement": d})) for d in (1, 8)
)

# 1/(2 (5/8)^(3/5) B(8/5, 1/2)).
WEAK = math.gamma(2.1) / (2.0 * 0.625**0.6 * math.gamma(1.6) * math.gamma(0.5))
ONE_NUMBER = estimates(height=({"order": [1, 2]}, [1.0, 4.0]))

BY_HAND = [
    # measure, datasets, arguments, value, error
    (chain.predicted_speed, CHAIN, {}, 0.5, 2**-53),
    (chain.front_speed, CHAIN, {}, 0.7, 1e-3),
    (chain.force_overshoot, CHAIN, {}, 1.728, 1.5 * 1.2 * 1e-3 * 16),
    (chain.displacement_overshoot, CHAIN, {}, 0.28, 1e-3 * 16),
    (chain.first_gap_time, CHAIN, {}, 5.0, 1e-3),
    (chain.smallest_relative_displacement, CHAIN, {}, -3.0, 1e-3),
    (chain.smallest_relative_displacement_time, CHAIN, {}, 7.0, 1e-3),
    (chain.smallest_velocity, CHAIN, {}, -0.5, 1e-3),
    # At every other time no bead that the front has passed goes back.
    (chain.smallest_velocity_behind, CHAIN, {}, -8.0, (0.25 + 1e-3) * 32),
    (chain.crossings, CHAIN, {"bead": 3}, 3.0, 0.0),
    (chain.openings, CHAIN, {}, 2.0, 0.0),
    (chain.openings_after_the_widest_gap, CHAIN, {}, 1.0, 0.0),
    (chain.peak_spread, CHAIN, {"beads": [2, 4, 8]}, 0.32, 2e-3 * 16),
    (chain.peak_decay, CHAIN, {"first": 4, "last": 8}, math.log(9 / 7) / 4, 0.04 / 6.3),
    (chain.spacing_defect, CHAIN, {"beads": [2, 6, 8]}, 13 / 16, 2e-3 / 0.75),
    (chain.mean_compression, SWINGING, {}, 0.5, ANY),
    (chain.mean_compression, RISING, {}, math.nan, math.nan),
    (
        chain.middle_compression,
        SWINGING,
        {},
        0.5,
        0.25 * math.sin(0.05 * math.pi) * math.sin(0.45 * math.pi),
    ),
    (chain.middle_compression, RISING, {}, math.nan, math.nan),
    (chain.thickening, SPREADING, {}, 27 / 22, ANY),
    (chain.forward_thickening, SPREADING, {}, 18 / 13, ANY),
    (chain.backward_over_forward_width, SPREADING, {}, 27 / 18, ANY),
    (chain.momentum_growth, CHAIN, {}, 1.5, 1e-3 * 64 / 10),
    (chain.velocity_front, CHAIN, {}, 4.0, ANY),
    # The last arrival is at 3; the larger gain, at 4.5, comes before twice that time.
    (chain.second_arrival_time, CHAIN, {}, 8.5, 1.0),
    (laws.weak_damping_constant, LAWS, {}, WEAK, 4 * 2**-54),
    (laws.gamma, LAWS, {"material": "steel"}, 0.05, 1e-3),
    # The inverse of `gf.restitution`, which tests/model/test_collision.py holds to SciPy.
    (laws.gamma_of_restitution, LAWS, {"restitution": restitution(0.05)}, 0.05, ANY),
    (laws.order_of_agreement, LAWS, {}, 1.8, 1e-3),
    (laws.order_of_two_stages, LAWS, {}, 2.7, 1e-3),
    (laws.conserved_velocity_drift, LAWS, {}, 1e-13, 1e-3),
    (laws.contact_time_power, LAWS, {}, -0.2, ANY),
    (laws.indentation_power, LAWS, {}, 0.8, ANY),
    (laws.approach_power, LAWS, {}, 0.7, ANY),
    (laws.softening_speed, LAWS, {}, -1.0, 1e-3),
    (laws.signed_speed, LAWS, {"law": "softening"}, -0.75, 1e-3),
    (laws.velocity_power, REGIMES, {"beta": 1.5}, math.log10(25) / 4, 2**-49),
    (laws.restitution_gain, REGIMES, {"beta": 1.5}, 0.7, 2e-3),
    (laws.restitution_gain, REGIMES, {"beta": 1.0}, -0.3, 2e-3),
    (laws.observed_order, CHOICE, {"form": VARIABLES[1], "scheme": "rk4"}, 1.5, 0.4),
    (laws.order_gain, CHOICE, {"scheme": "rk4"}, 1.0, 0.6),
    (laws.quotient_power, CHOICE, {"form": VARIABLES[0], "beta": 1.5}, 0.5, 0.2),
    (laws.persistence, WAVES, {"gamma": 0.0}, 1.5, 0.1 / 4 + 1.5 * 0.1 / 4),
    (laws.persistence, WAVES, {"gamma": 0.06}, 0.25, 0.1 / 2 + 0.25 * 0.1 / 2),
    (laws.spreading, WAVES, {"alpha": 1.0}, 2.0, 0.06),
    (laws.worst_agreement, jumps((1.0, -2.12)), {"quantity": "speed"}, 3.0, ANY),
    (laws.worst_agreement, jumps((1.01, -2.02)), {"quantity": "speed"}, 0.5, ANY),
    (laws.sonic_margin, jumps(), {}, 1.0 - 1.0 / SOUND, 0.01 / SOUND),
    (laws.sonic_margin, jumps((1.3, -2.0)), {}, 1.0 - 1.3 / SOUND, 0.01 / SOUND),
    (laws.sonic_margin, jumps((1.0, -0.9)), {}, -0.1 / (FAST - 1.0), 0.03 / (FAST - 1.0)),
    (laws.sonic_margin, jumps(direction=(-1.0, 1.0)), {}, -1.0 / SOUND, 0.01 / SOUND),
    (laws.speed_spread, TRAVELLING, {"laws": ["hertz", "fpu"]}, 0.5, 6e-9),
    (laws.speed_spread, TRAVELLING, {"laws": ["hertz"]}, 0.0, 2e-9),
    (laws.largest_relative_distance, POWERS, {"quantity": "power", "way": "exact"}, 1e-3, 5e-4),
    (fronts.force_overshoot, FRONT, {}, 1.728, 1.5 * 1.728 * 1e-3),
    (fronts.displacement_overshoot, FRONT, {}, 0.44, 1e-3),
    (fronts.velocity_overshoot, RIPPLED, {}, 0.4 + 1 / 120, 0.6 / 8 + 1e-3),
    (fronts.smallest_velocity_behind, RIPPLED, {}, 0.5975, 0.5 / 8 + 1e-3),
    (fronts.dissipated_power, FRONT, {}, 0.1, 2e-3),
    (fronts.distance, FRONT, {"field": "velocity", "limit": "logarithmic"}, 0.3, 2.5e-3),
    (fronts.tail_over_long_wave, CURVES, {"alpha": 1.02}, 0.8, 8e-15),
    (fronts.critical_damping, CURVES, {"alpha": 1.5}, 0.25, 2.5e-15),
    (fronts.tail_contrast, TRENDS, {"beta": 1.5}, 2.5, 2e-3),
    (fronts.tail_contrast, TRENDS, {"beta": 1.0}, -2.0, 2e-3),
    (fronts.gaussian_distance, TRENDS, {"exponent": 1.02}, 0.01, 1e-3),
    (fronts.width_power, TRENDS, {}, -0.5, 0.25),
    (fronts.critical_power_of_pressure, TRENDS, {}, -0.25, 2e-3 / (0.3 * math.log(100))),
    (fronts.narrowing, TRENDS, {}, 0.25, 1e-3 / 4 + 0.25 * 1e-3 / 4),
    # A third of the way from 1.5 to 1.75, or a quarter of that to 2.
    (fronts.second_peak_seen_from, PEAKS, {}, 19 / 12, 1 / 24),
    (fronts.exchange_exponent, CURVES, {}, 1.25, 1.25e-14),
    (fronts.methods_apart, tuple(SHOT), {}, 2e-14, 3e-14),
    (fronts.strong_damping_power, SURVEY, {"alpha": 1.5}, -1.75, 0.25),
    (fronts.solitary_force, TRENDS, {"exponent": 1.5}, 3.375 * math.exp(-0.5), ANY),
    (continuum.squared_slope_overdamped, ORBITS, {}, 2e-40, 1e-3),
    (continuum.squared_slope_underdamped, ORBITS, {}, 3.0, 1e-3),
    (continuum.largest_overdamped_slope, ORBITS, {}, -2.0, 2e-3 / 1e-6),
    (continuum.smallest_steepness, PEAKED, {}, 2.0, 2e-3 / 1e-6),
    (continuum.gaussian_defect, ORBITS, {}, 0.25, 1e-3),
    (continuum.growth_rate, ORBITS, {"mu": 0.3}, 2.0, 1.0),
    (continuum.growth_rate, ORBITS, {"mu": 3.0}, 2.0, ANY),
    (continuum.frequency, ORBITS, {"mu": 1.0}, 1.0, 1e-6 / math.sqrt(0.75)),
    (continuum.angular_frequency, ORBITS, {"mu": 1.0}, math.sqrt(0.75), 1e-6),
    # ω² = 1 − μ²/4, of which the largest error is 2 · 1 · 1e-6, falls by 1 per unit of μ.
    (continuum.transition, ORBITS, {}, 2.0, 2e-6),
    (
        continuum.flux_distance,
        TABULATED,
        {"alpha": 1.5},
        (0.2 + 0.01 / 2.4) * math.e,
        0.3 / 8.0 * math.e,
    ),
    (continuum.flux_distance, TABULATED, {"alpha": 1.5, "smallest": 0.7}, 0.1 * math.e, 1e-15),
    (continuum.profile_distance, TABULATED, {"alpha": 1.5}, 0.25, 0.5 / 8.0),
    (ring.epsilon, SHOCKS, {}, 1.0, 2**-52),
    (ring.half_length, SHOCKS, {}, 19.5, 2**-48),
    (ring.ring_length, SHOCKS, {}, -376.0, 2**-44),
    (ring.upwind_spacing, SHOCKS, {}, 0.39, 2**-54),
    (ring.upwind_step, SHOCKS, {}, 0.8 * 0.39**2 / 2.78, 2**-57),
    (ring.small_parameter_ratio, SHOCKS, {}, 3.0, 2**-51),
    (ring.damping_parameter, SHOCKS, {}, 2.0, 4 * 2**-51),
    (ring.shock_travel, SHOCKS, {}, 14.0, ANY),
    (ring.shock_speed_ratio, SHOCKS, {}, 8.0 / 6.5, ANY),
    (ring.bump_birthplace, SHOCKS, {}, 3.0, ANY),
    (ring.bump_velocity, SHOCKS, {}, -1.0, ANY),
    (ring.shock_lead, SHOCKS, {}, 2.5, ANY),
    (ring.aftershock_distance, SHOCKS, {}, 0.2, ANY),
    (ring.displacement_excess, SHOCKS, {}, -20.0, 100 * 2e-3 / 16),
    (ring.velocity_excess, SHOCKS, {}, 20.0, 100 * 2e-3 / 32),
    (ring.displacement_excess_upwind, SHOCKS, {}, 10.0, 100 * 1e-3 / 16),
    (ring.velocity_excess_upwind, SHOCKS, {}, 25.0, 100 * 1e-3 / 32),
    (ring.bump_of_equation, SHOCKS, {}, 0.25, 1e-3 / 16),
    (ring.gap_of_equation, SHOCKS, {}, 0.0, 1e-3 / 16),
    (ring.smallest_velocity_of_equation, SHOCKS, {}, -0.01, 1e-3 / 32),
    (ring.plateau_ratio, (SHOCKS, SMALLER), {}, 0.5, 2**-53),
    (ring.peak_ratio, (SHOCKS, TALLER), {}, 2.0, 1e-3 / 8 + 2 * 1e-3 / 16),
    (tabulated, ONE_NUMBER, {"name": "height", "order": 2}, 4.0, 1e-3),
]


@pytest.mark.parametrize(("measure", "data", "arguments", "value", "error"), BY_HAND)
def test_measure_is_what_follows_by_hand(measure, data, arguments, value, error):
    assert_measures(measure, data, arguments, value, error)


def gaussian_orbit(defect=0.0, mu=0.0):
    """The Gaussian, which is the orbit of μ = 0, with a wrong slope."""
    s = np.arange(-8.0, 8.05, 0.1)
    logarithm, axes = 0.5 - 0.25 * s**2, {"mu": [mu], "s": s}
    y, wrong = np.exp(logarithm), 1.0 + defect
    return dataset(
        rescaled_force=(axes, [y]),
        slope=(axes, [-0.5 * s * y * wrong]),
        log_rescaled_force=(axes, [logarithm]),
    )


def test_residual_finds_an_orbit_that_is_none():
    exact = continuum.residual_of_orbits(gaussian_orbit(), 0.0)
    assert exact.value < 1e-7
    assert exact.value == pytest.approx(exact.error, rel=0.1)
    assert continuum.residual_of_orbits(gaussian_orbit(1e-3), 0.0).value > 1e-4
    assert continuum.residual_of_orbits(gaussian_orbit(mu=0.1), 0.0).value > 0.05


def profiles(chain, equation):
    """Snapshots of a ring of 39 beads and of the equation, from functions of the site."""
    at_beads, at_sites = ({axis: AT[axis] for axis in ("t", name)} for name in ("bead", "site"))
    return dataset(
        RING,
        relative_displacement=(at_beads, [chain(AT["bead"])]),
        relative_displacement_logarithmic=(at_sites, [equation(AT["site"])]),
    )


AT = {"t": [0.0], "bead": BEADS, "site": SITES}


def test_profiles_of_one_shape_are_correlated():
    def pulse(n):
        return 5.0 * np.exp(-(((n - 20.0) / 6.0) ** 2))

    alike = ring.profile_correlation(profiles(pulse, lambda n: 0.8 * pulse(n)))
    assert alike.value == pytest.approx(1.0, abs=1e-12)
    gap = ring.profile_correlation(profiles(lambda n: pulse(n) - 50.0 * (n == 1), pulse))
    assert gap.value > 0.999
    displaced = ring.profile_correlation(profiles(pulse, lambda n: pulse(n + 12.0)))
    assert displaced.value < 0.3


def test_every_measure_behind_a_statement_is_called_by_a_test():
    """In the table above, or by name: here, or where a measure has data of its own."""
    by_hand = {case[0] for case in BY_HAND}
    others = "".join(
        (ROOT / "tests" / f"{name}.py").read_text(encoding="utf-8")
        for name in (
            "chain/test_measures_by_hand",
            "studies/test_ring_against_equations",
        )
    )
    files = [ROOT / f"config/{name}.yaml" for name in ("paper_numbers", "findings")]
    for file in files:
        for statement in read_yaml(file):
            measure = find_measure(statement["measure"], file.parent)
            assert measure in by_hand or f".{measure.__name__}(" in others, measure
