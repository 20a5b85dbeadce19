"""The numbers of README.md are those of the study."""

import re
from pathlib import Path

import numpy as np
import pytest
from pages import load_script

from granular_fronts.referee.problems import collision_time
from granular_fronts.scenes.yaml_files import read_yaml
from half_step_motions import Case
from half_step_study import compare_half_steps, measure_excess
from projects import ROOT

HERE = Path(__file__).parent
PAGE = (HERE / "README.md").read_text(encoding="utf-8")
OWN = read_yaml(HERE / "config.yaml")
MEASURED = load_script("measured")
COLUMNS = ("excess_overshoot", "excess_tail", "restitution_defect", "energy_defect")
COLUMNS += ("speed_defect", "momentum_defect")


def numbers(sentence):
    """The numbers of a sentence of the page, wherever its lines end."""
    return tuple(map(float, re.search(sentence, " ".join(PAGE.split())).groups()))


def last_digit(number):
    """Half a unit of the last digit of a decimal number."""
    return 0.5 * 10.0 ** -len(number.partition(".")[2])


@pytest.fixture(scope="module")
def measured():
    shown = OWN["shown"]
    assert (shown["beta"], shown["gamma"]) == (1.5, 0.05)
    return compare_half_steps(**OWN | {"steps_per_collision": [10, 20, 50, 100]})


def test_table_of_checks(measured):
    rows = re.findall(r"^\| 1/(\d+) \| (.*) \|$", PAGE, re.MULTILINE)
    assert [int(count) for count, _ in rows] == [10, 20, 50, 100]
    for count, cells in rows:
        at = measured.sel(beta=1.5, gamma=0.05).sel(step=1.0 / int(count), method="nearest")
        for name, cell in zip(COLUMNS, cells.split(" | "), strict=True):
            if cell.startswith("<"):
                assert float(at[name]) < float(cell[1:])
                continue
            number = cell.removesuffix(" %")
            assert 100.0 * float(at[name]) == pytest.approx(float(number), abs=last_digit(number))
    excess = measured["excess_overshoot"].sel(beta=1.5, gamma=0.05)
    written = {
        "damping_of_the_lag": f"{100.0 * excess.sel(step=0.05, method='nearest').item():.0f}"
    }
    page = (ROOT / "README.md").read_text(encoding="utf-8")
    assert MEASURED.fill(page, written) == page


def holds_tightly(ratio, low, high):
    """Whether printed limits are those of some ratios, to the digits printed."""
    return low <= ratio.min() < low + 0.015 and high - 0.015 < ratio.max() <= high


RULE = re.search(
    r"(\S+) to (\S+) times this in the middle of (\d+) beads. In the middle of (\d+) beads, .*?"
    r" it is (\S+) to (\S+) times \$h/t_c\$ with β = 5/4, and (\S+) to (\S+) times with β = 1\.",
    " ".join(PAGE.split()),
)


def test_overshoot_and_tail_in_a_short_chain(measured):
    """A table, and the share of the tail, which grows with γ."""
    rows = re.findall(r"^  \| (0\.\d+) \| (.*) \|$", PAGE, re.MULTILINE)
    assert [float(gamma) for gamma, _ in rows] == measured["gamma"].values.tolist()
    fine = measured[["excess_overshoot", "excess_tail"]].sel(step=slice(0.0201, None))
    fine = fine.transpose("gamma", "beta", "step")
    printed = [[cell.split(", ") for cell in cells.split(" | ")] for _, cells in rows]
    ratios = fine["excess_overshoot"] / fine["step"]
    np.testing.assert_allclose(ratios, np.array(printed, float), rtol=0, atol=0.005)
    share = (fine["excess_tail"] / fine["excess_overshoot"]).values
    assert holds_tightly(share, *numbers(r"excess is (\S+) to (\S+) times that of the overshoot"))
    assert np.all(np.diff(share, axis=0) > 0.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("beta", "gammas", "beads", "end", "printed"),
    [
        (1.5, (0.01, 0.03, 0.13), RULE[3], 208, RULE.group(1, 2)),
        (1.25, (0.01, 0.13), RULE[4], 108, RULE.group(5, 6)),
        (1.0, (0.01, 0.13), RULE[4], 108, RULE.group(7, 8)),
    ],
)
def test_rule_of_thumb_in_a_long_chain(beta, gammas, beads, end, printed):
    unit, counts = collision_time(1.5), np.array([50.0, 100.0, 200.0])
    chains = [Case(1.5, beta, gamma, int(beads), end * unit) for gamma in gammas]
    ratios = [measure_excess(case, unit / counts)["excess_overshoot"] * counts for case in chains]
    ratios = np.array(ratios)[:, : None if beta == 1.5 else 2]
    assert holds_tightly(ratios, *map(float, printed))
