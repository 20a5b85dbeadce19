"""Chains that start in exact solitary waves carry them unchanged."""

import numpy as np
import pytest

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.solitary_waves import solitary_wave, start_in_waves


@pytest.mark.parametrize(("centre", "speed"), [(8.0, 1.0), (8.3, 1.4), (27.5, -1.0)])
@pytest.mark.parametrize("alpha", [1.5, 2.0])
def test_a_chain_carries_the_wave_in_which_it_starts(alpha, centre, speed):
    """Every contact has its values 12 contacts farther after the time 12/|c|."""
    crossed = 12
    start = start_in_waves(alpha, 36, [(centre, speed)])
    scene = {
        "law": {"alpha": alpha, "beta": alpha, "gamma": 0.0},
        "beads": 36,
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": start,
        "end_time": crossed / abs(speed),
        "tolerance": {"relative": 1e-12, "absolute": 1e-14},
        "record": {"snapshots": [crossed / abs(speed)]},
    }
    later = simulate_chain(scene)["relative_displacement"].values[0, :-1]
    wanted = np.roll(start["relative_displacement"], crossed if speed > 0.0 else -crossed)
    np.testing.assert_allclose(later, wanted, atol=1e-9 * wanted.max())


def test_two_waves_are_the_sum_of_both_and_carry_their_momenta():
    """A wave of speed c has the height c⁴ of that of speed 1 and the momentum c⁵ ∫ F."""
    alone = [start_in_waves(1.5, 60, [wave]) for wave in ((10.0, 1.0), (45.25, -2.0))]
    both = start_in_waves(1.5, 60, [(10.0, 1.0), (45.25, -2.0)])
    for name in ("relative_displacement", "velocity"):
        total = np.sum([one[name] for one in alone], axis=0)
        np.testing.assert_allclose(both[name], total, atol=1e-12)
    first, second = (sum(one["velocity"]) for one in alone)
    wave = solitary_wave(1.5)
    assert first == pytest.approx(np.sum(np.maximum(wave.u, 0.0) ** 1.5) / 16, rel=1e-9)
    assert second == pytest.approx(-(2.0**5) * first, rel=1e-9)
