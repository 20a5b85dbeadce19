"""Stated errors of random problems hold, and would be noticed if they were too small."""

import numpy as np
import pytest

import granular_fronts as gf
import true_chains
import true_fronts
import true_rings
from granular_fronts.chain.simulate import simulate_chain
from measure_honest_errors import ratio

TODA = {"elastic": {"kind": "toda", "rate": 2.6}, "viscous": {"kind": "linear", "gamma": 6.53}}
# A long front, a weakly nonlinear and a sharp one, and one of another law.
FRONTS = [
    ({"alpha": 2.0, "beta": 2.0, "gamma": 6.0}, (-1.0, -0.39)),
    ({"alpha": 1.024, "beta": 1.024, "gamma": 0.02}, (-1.0, 0.0)),
    ({"alpha": 4.42, "beta": 1.54, "gamma": 4.89}, (-1.0, 0.0)),
    (TODA, (-1.84, 0.43)),
]


def hold(found, share=1.0):
    """Whether stated errors are honest: a share within twice, all within ten times, none wide.

    Of one number in a hundred nothing may be claimed. A refusal is no honest answer.
    """
    numbers = np.array([number for _, *number in found])
    ratios = np.array([ratio(*number) for number in numbers])
    stated, true, _ = numbers[numbers[:, 1] < np.inf].T
    wide = np.median(stated / np.fmax(true, 1e-300))
    few_wide = wide <= 10.0 and np.mean(np.isinf(stated)) <= 0.01
    return np.mean(ratios <= 2.0) >= share and (ratios <= 10.0).all() and few_wide


def smaller(found, factor):
    """The same numbers with smaller stated errors."""
    return [(name, stated / factor, *rest) for name, stated, *rest in found]


@pytest.mark.parametrize(
    ("cases", "seed", "count", "factor"),
    [(true_chains.cases, 11, 6, 30.0), (true_rings.cases, 1, 8, 20.0)],
)
def test_a_few_problems_state_honest_errors(cases, seed, count, factor):
    """Places on rings by themselves, too, among so many other numbers."""
    found = list(cases(seed, count))
    assert hold(found, 0.98)
    assert not hold(smaller(found, factor), 0.98)
    places = [one for one in found if one[0].startswith("place")]
    assert bool(places) == (cases is true_rings.cases)
    assert not places or hold(places, 0.98)


def test_errors_of_fronts_and_of_their_measures_hold():
    """Each number by itself; whether errors are wide is judged by the median of all of them."""
    together = []
    for law, states in FRONTS:
        front = gf.solve_front(law=law, states=states)
        found = list(true_fronts.judge(front, np.random.default_rng(3)))
        assert len(found) == 8
        assert not hold(smaller(found, 100.0))
        together += found
    assert hold(together)


def test_reference_knows_the_dissipated_power():
    """(α − 1)/(2(α + 1)), eq. (16), to more digits than a double has."""
    front = gf.solve_front(alpha=1.5, beta=1.0, gamma=0.4)
    power = true_fronts.TrueFront(front).measures()["dissipated_power"]
    assert abs(power - true_fronts.REAL(1) / 10) < 2e-18


def test_a_gap_of_truncation_alone_is_never_certain():
    """A piston presses dashpots of Kuwabara and Kono, that never part, but seem to by 1e-11."""
    scene = true_chains.random_scene(np.random.default_rng([1, 334])) | {"end_time": 1.0}
    motion = simulate_chain(scene | {"record": {"snapshots": [], "extremes": True}})
    assert -1e-10 < motion["smallest_relative_displacement"] < 0.0
    assert motion["first_gap_time"].attrs["error_estimate"] == np.inf


@pytest.mark.parametrize("problem", [(1, 220), (1, 432), (3, 17), (3, 43)])
def test_a_number_on_which_two_runs_agree_by_chance_states_its_error(problem):
    """A turn, the rate of a gap, a mean, an arrival: others nearby show what one does not."""
    found = true_chains.judge(true_chains.random_scene(np.random.default_rng(problem)))
    assert max(ratio(*number) for _, *number in found) <= 2.0


# Hundreds of problems; each push tries a few.
@pytest.mark.nightly
@pytest.mark.parametrize(
    ("cases", "seed", "count"),
    [(true_chains.cases, 2, 150), (true_fronts.cases, 11, 40), (true_fronts.cases, 12, 40)],
)
def test_many_problems_state_honest_errors(cases, seed, count):
    assert hold(cases(seed, count), 0.995)
