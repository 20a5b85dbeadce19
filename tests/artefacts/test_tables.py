"""The tables of statements are complete, read the same in both formats, and hold no surprise."""

import csv

import pytest

from granular_fronts.output.statements import (
    ANSWERS,
    NOT_JUDGED,
    OTHER_PARAMETERS,
    UNDECIDED,
    unexpected_verdicts,
)

JUDGED = ["computed", "numerical error", "verdict", "criterion", "remark", "scene"]
COLUMNS = {
    "paper_numbers": ["quantity", "paper_place", "printed", *JUDGED, "kind", "expected"],
    "findings": ["quantity", "paper_place", *JUDGED, "kind", "expected"],
}
TABLES = pytest.mark.parametrize("name", COLUMNS)


def read_table(results, name):
    with (results / "tables" / f"{name}.csv").open(newline="", encoding="utf-8") as lines:
        reader = csv.DictReader(lines)
        return reader.fieldnames, list(reader)


@TABLES
def test_statements_are_complete(results, name):
    heads, rows = read_table(results, name)
    assert heads == COLUMNS[name]
    for row in rows:
        answers = (*ANSWERS[row["kind"]], UNDECIDED, NOT_JUDGED, OTHER_PARAMETERS)
        assert row["verdict"] in answers
        assert row["scene"]
        assert row["remark"]
    markdown = (results / "tables" / f"{name}.md").read_text(encoding="utf-8").splitlines()
    assert len(markdown) == len(rows) + 2


@TABLES
def test_verdicts_are_the_expected_ones(results, name):
    _, rows = read_table(results, name)
    assert unexpected_verdicts(rows) == []
