"""Campaigns on unlike beads are small, and find the masses that carry and scatter pulses."""

from pathlib import Path

import numpy as np
import pytest

from campaigns import campaign, solved_points
from granular_fronts.scenes.yaml_files import read_yaml

CAMPAIGNS = Path(__file__).parent / "campaigns"


@pytest.mark.parametrize("file", sorted(CAMPAIGNS.glob("*.yaml")), ids=lambda file: file.stem)
def test_campaigns_are_possible_and_small(file):
    asked = campaign(read_yaml(file))
    assert asked.size * asked.kind.seconds_per_point < 60.0


@pytest.mark.slow
def test_a_dimer_carries_and_scatters_pulses_at_the_masses_of_the_page():
    """A solitary wave near the mass 0.34, and the largest losses near 0.59."""
    best, worst = [0.28, 0.31, 0.34, 0.37, 0.4], [0.53, 0.56, 0.59, 0.62, 0.65]
    given = read_yaml(CAMPAIGNS / "dimer_ratio.yaml")
    solved = solved_points(campaign(given, axes={"beads.mass.cell.2": best + worst}))
    force = solved.values["largest_force"][0]
    assert best[np.argmax(force[:5])] == 0.34
    assert worst[np.argmin(solved.values["transmitted_energy"][0, 5:])] == 0.59
