"""Floquet multipliers of fronts: translation, sound waves, and what is no front."""

import functools

import numpy as np
import pytest

import granular_fronts as gf
from granular_fronts.fronts.linear import floquet
from granular_fronts.fronts.linear.floquet import (
    compressed_chain_multipliers,
    front_multipliers,
    monodromy_matrix,
    reflection_radius,
)

WEAK, STRONG = (1.5, 0.06 * 0.1**0.25), (1.5, 0.65 * 0.1**0.25)
LAWS = [(*WEAK, 1.5), (3.0, 2.0, 3.0), (1.5, 0.3, 1.0)]
by_law = pytest.mark.parametrize(("alpha", "gamma", "beta"), LAWS)


solved = functools.cache(gf.solve_front)
solved_multipliers = functools.cache(lambda *law: front_multipliers(solved(*law)))


@by_law
def test_front_is_stable(alpha, gamma, beta):
    result = solved_multipliers(alpha, gamma, beta)
    assert result.attrs["translation_defect"] < 1.0e-8
    assert result.attrs["flow_residual"] < 1.0e-7
    assert result.attrs["translation_defect"] == abs(result.values[0] - 1.0)
    radius = result.attrs["spectral_radius_without_translation"]
    assert radius == np.abs(result.values[1:]).max() < 1.0
    assert result.attrs["verdict"].startswith("no unstable multiplier found")
    assert np.all(np.diff(np.abs(result.values[1:])) <= 1.0e-12)


def test_translation_defect_falls_with_the_window():
    defects = [
        front_multipliers(solved(3.0, 0.1, 3.0), beads_behind=b).attrs["translation_defect"]
        for b in (40, 80, 160)
    ]
    assert defects[1] < 1.0e-3 * defects[0]
    assert defects[2] < 1.0e-10


def test_largest_multiplier_is_that_of_reflected_sound():
    """B (1 − z) tends to the law of long waves, with an error that falls like 1/B."""
    errors = []
    for beads in (100, 200):
        result = front_multipliers(solved(3.0, 0.1, 3.0), beads_behind=beads)
        assert result.values[1].imag == 0.0
        expected = result.attrs["reflection_radius"]
        errors.append(abs(np.log(result.values[1].real) / np.log(expected) - 1.0))
    assert errors[1] < 0.05
    assert errors[1] < 0.65 * errors[0]


def test_rounding_moves_multipliers_no_farther_than_stated():
    """Windows that differ in beads at rest have the same multipliers, but for rounding."""
    front = solved(*STRONG, 1.5)
    usual = front_multipliers(front, beads_behind=40)
    more = front_multipliers(front, beads_behind=40, beads_ahead=usual.attrs["beads_ahead"] + 3)
    certain = usual["rounding"].values < 1.0e-2
    assert 10 < certain.sum() < usual.size
    for value, error in zip(usual.values[certain], usual["rounding"].values[certain], strict=True):
        assert np.abs(more.values - value).min() <= error
    # What a nilpotent block leaves is anywhere.
    assert (
        np.abs(usual.values[usual["rounding"].values > 1.0]).max()
        < np.abs(usual.values[certain]).min()
    )


def test_untouched_chain_is_nilpotent():
    """Shift and Jordan block: with nothing entering from ahead no power of T survives."""
    beads = 20
    matrix = monodromy_matrix(np.zeros(beads), np.zeros(beads), 1.5, 0.3, 1.5)
    shift_and_block = np.kron(np.eye(beads, k=1), [[1.0, 1.0], [0.0, 1.0]])
    ahead = slice(2 * 16, None)
    np.testing.assert_allclose(matrix[ahead], shift_and_block[ahead], rtol=0, atol=3.0e-15)
    assert not np.any(np.linalg.matrix_power(shift_and_block, beads))


def test_compressed_chain_is_that_of_the_monodromy_matrix():
    """In the middle of a long compressed window a plane wave is multiplied by z."""
    alpha, gamma, beta, q, beads = 1.5, 0.1, 1.0, 0.7, 60
    matrix = monodromy_matrix(np.ones(beads), np.zeros(beads), alpha, gamma, beta)
    kappa = 2.0 - 2.0 * np.cos(q)
    z = compressed_chain_multipliers(alpha, gamma, beta, q)[0]
    sigma = np.log(z * np.exp(-1j * q))
    wave = np.exp(1j * q * np.arange(beads))[:, np.newaxis] * [1.0, sigma + beta * gamma * kappa]
    moved = (matrix @ wave.ravel()).reshape(-1, 2)
    middle = slice(20, 40)
    np.testing.assert_allclose(moved[middle], z * wave[middle], rtol=0, atol=1.0e-13)


@pytest.mark.parametrize(
    ("values", "residual", "verdict"),
    [
        ([1.0, 0.9, 0.5], 1e-12, "no unstable multiplier found: "),
        ([1.0, 1.2j, -1.1], 1e-12, "unstable: 2 multipliers"),
        ([0.9, 0.5], 1e-12, "undecided: the multiplier of translation is 1.0e-01 away"),
        ([1.0, 0.5], 1e-1, "undecided: flow and shift change the state by 1.0e-01"),
    ],
)
def test_multipliers_are_judged(monkeypatch, values, residual, verdict):
    """The state itself is a front, whatever its multipliers are said to be."""
    monkeypatch.setattr(
        floquet, "multipliers", lambda *_: (np.array(values), np.zeros(len(values)))
    )
    monkeypatch.setattr(floquet, "flow_residual", lambda *_: residual)
    assert front_multipliers(solved(*STRONG, 1.5)).attrs["verdict"].startswith(verdict)


def test_what_is_no_front_is_reported():
    front = solved(*STRONG, 1.5).copy()
    front["relative_displacement"] = front["relative_displacement"] ** 2
    result = front_multipliers(front)
    assert result.attrs["translation_defect"] < 1.0e-6
    assert result.attrs["verdict"].startswith("undecided: flow and shift change the state by")


def test_reflection_radius_is_the_sound_round_trip():
    """z^(round trip) = (−1)·(reflection of the jump conditions)."""
    speed, beads = np.sqrt(1.5), 50
    round_trip = beads / (speed - 1.0) + beads / (speed + 1.0)
    reflected = ((speed - 1.0) / (speed + 1.0)) ** 2
    assert reflection_radius(1.5, beads) ** round_trip == pytest.approx(reflected, rel=1.0e-13)
