"""Verdicts on printed numbers, and the list of them."""

import math
from pathlib import Path

import pytest
import yaml
from tabulate_paper_numbers import (
    NOT_JUDGED,
    NOT_REPRODUCED,
    REPRODUCED,
    find_measure,
    judge,
)

from granular_fronts.measured import Measured

ENTRIES = yaml.safe_load(
    (Path(__file__).parents[1] / "config/paper_numbers.yaml").read_text("utf-8")
)


@pytest.mark.parametrize(
    ("printed", "value", "within", "verdict"),
    [
        ("0.56", 0.5649, None, REPRODUCED),
        ("0.56", 0.5651, None, NOT_REPRODUCED),
        ("-9.83", -9.8325, None, REPRODUCED),
        ("2326", 2326.6, None, NOT_REPRODUCED),
        ("750", 746.0, 5, REPRODUCED),
        ("1.6", 1.66, None, NOT_REPRODUCED),
        ("> 1", 1.5, None, REPRODUCED),
        (">= 0", -1e-3, None, NOT_REPRODUCED),
        ("very small", 0.3, None, NOT_JUDGED),
        ("0.56", math.nan, None, NOT_REPRODUCED),
        ("> 1", math.nan, None, NOT_REPRODUCED),
    ],
)
def test_half_a_unit_of_the_last_digit_decides(printed, value, within, verdict):
    assert judge(printed, Measured(value, 0.0), within) == verdict


def test_error_counts_in_favour_of_the_printed_number():
    assert judge("0.56", Measured(0.567, 0.003)) == REPRODUCED


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry["quantity"])
def test_every_entry_names_a_measure_and_a_place(entry):
    assert callable(find_measure(entry["measure"]))
    assert entry["paper_place"]
    assert entry["remark"]
    assert isinstance(entry["printed"], str)
