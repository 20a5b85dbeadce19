"""The tables of statements are complete, read the same in both formats, and hold no surprise."""

import csv
import math

import pytest

from granular_fronts.output.statements import (
    ANSWERS,
    NOT_JUDGED,
    OTHER_PARAMETERS,
    UNDECIDED,
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
def test_what_has_no_lower_limit_is_not_negative(results, name):
    for row in read_table(results, name)[1]:
        if row["criterion"].startswith(("at most", "below")) and row["computed"]:
            assert float(row["computed"]) >= 0.0, row["quantity"]


@TABLES
def test_readers_see_the_numbers_and_errors_that_machines_do(results, name):
    _, rows = read_table(results, name)
    markdown = (results / "tables" / f"{name}.md").read_text(encoding="utf-8").splitlines()
    heads, _, *lines = ([cell.strip() for cell in line.split("|")[1:-1]] for line in markdown)
    for row, line in zip(rows, lines, strict=True):
        shown = dict(zip(heads, line, strict=True))
        for head, rounding in (("computed", 1e-5), ("numerical error", 0.1)):
            exact = float(row[head]) if row[head] else math.nan
            found = float("nan" if shown[head] == "–" else shown[head])
            assert found == pytest.approx(exact, rel=rounding, abs=0.0, nan_ok=True)


@TABLES
def test_verdicts_are_the_expected_ones(results, name):
    _, rows = read_table(results, name)
    judged = [row for row in rows if row["verdict"] != OTHER_PARAMETERS]
    assert [row["quantity"] for row in judged if row["verdict"] != row["expected"]] == []
