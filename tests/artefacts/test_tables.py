"""The table of the paper's numbers is complete and reads the same in both formats."""

import csv

COLUMNS = [
    "quantity",
    "paper_place",
    "printed",
    "computed",
    "error_estimate",
    "scene",
    "verdict",
    "remark",
]
VERDICTS = {"reproduced", "not reproduced", "no number printed"}


def test_paper_numbers(results):
    with (results / "tables" / "paper_numbers.csv").open(newline="", encoding="utf-8") as lines:
        reader = csv.DictReader(lines)
        rows = list(reader)
    assert reader.fieldnames == COLUMNS
    assert {row["verdict"] for row in rows} <= VERDICTS
    for row in rows:
        assert row["computed"] == "" or float(row["computed"]) == float(row["computed"])
        assert row["scene"]
    markdown = (results / "tables" / "paper_numbers.md").read_text(encoding="utf-8").splitlines()
    assert len(markdown) == len(rows) + 2
