"""Measured numbers of README and manual come from the tables of a run, or from a test."""

import time

import pandas as pd
import pytest
import yaml
from pages import load_script

from campaigns import solved_points
from granular_fronts.campaign.definition import check_campaign
from projects import ROOT

MEASURED = load_script("measured")
ENTRIES = yaml.safe_load(MEASURED.ENTRIES.read_text(encoding="utf-8"))
BY_TESTS = [name for names in ENTRIES.pop("by_tests").values() for name in names]
TEXTS = {page: page.read_text(encoding="utf-8") for page in MEASURED.pages()}
MARKED = [page for page, text in TEXTS.items() if MEASURED.names_in(text)]


def test_every_mark_has_an_entry_and_every_entry_a_mark():
    named = {name for text in TEXTS.values() for name in MEASURED.names_in(text)}
    assert named == ENTRIES.keys() | {*BY_TESTS}
    assert all(text.count("<!-- ") == len(MEASURED.names_in(text)) for text in TEXTS.values())


@pytest.mark.parametrize("page", MARKED, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_pages_hold_the_numbers_of_the_last_run(page):
    if not (ROOT / "results" / "report.html").exists():
        pytest.skip("the workflow has not run")
    numbers = MEASURED.load_numbers(ROOT / "results")
    assert MEASURED.fill(TEXTS[page], numbers) == TEXTS[page], "run python docs/measured.py"


def statements(name):
    return yaml.safe_load((ROOT / "config" / f"{name}.yaml").read_text(encoding="utf-8"))


def test_rows_are_those_of_the_statements():
    """Also those of tables that were not made."""
    for name in ("paper_numbers", "findings"):
        quantities = [statement["quantity"] for statement in statements(name)]
        for entry in ENTRIES.values():
            if entry.get("table") == name and "row" in entry:
                assert quantities.count(entry["row"]["quantity"]) == 1, entry


CAMPAIGNS = {
    "front": {"axes": {"gamma": {"logspace": [0.1, 1, 400]}}, "fixed": {"alpha": 1.5}},
    "chain": {
        "axes": {"gamma": {"logspace": [0.05, 1, 40]}},
        "fixed": {"alpha": 1.5, "delta": 0.1, "beads": 200},
        "tolerance": 1e-9,
    },
}


# It measures processor time, which depends on the machine and what else it does.
@pytest.mark.nightly
@pytest.mark.parametrize(("kind", "least"), [("front", 1000), ("chain", 40)])
def test_campaigns_are_as_fast_as_the_page_says(kind, least):
    page = TEXTS[ROOT / "docs" / "limits.md"]
    assert MEASURED.fill(page, {f"{kind}s_per_second": str(least)}) == page
    asked = check_campaign({"kind": kind, **CAMPAIGNS[kind]}, kind)
    solved_points(asked)  # compiles, and fills caches
    begun = time.process_time()
    solved_points(asked)
    assert asked.size / (time.process_time() - begun) > least


# The script itself.


@pytest.mark.parametrize(
    ("value", "form", "expected"),
    [
        (0.26325, ".3f", "0.263"),
        (-1.62, ".1f", "−1.6"),
        (2.23e-5, ".1e", "2.2·10⁻⁵"),
        (1e-6, ".0e", "10⁻⁶"),
        (-1e12, ".0e", "−10¹²"),
    ],
)
def test_numbers_in_print(value, form, expected):
    assert MEASURED.in_print(value, form) == expected


def load(results, **entry):
    """The number that one entry takes from a table of two rows."""
    (results / "tables").mkdir(exist_ok=True)
    rows = pd.DataFrame(
        {"quantity": ["a", "b"], "alpha": [1.5, 1.1], "computed": [0.25, 2e-7]}
        | {"numerical error": [1e-9, 1e-7]}
    )
    rows.to_csv(results / "tables" / "known.csv", index=False)
    (results / "measured.yaml").write_text(yaml.safe_dump({"one": {"table": "known", **entry}}))
    return MEASURED.load_numbers(results, results / "measured.yaml")


def test_a_number_is_taken_from_its_row_and_rows_are_counted(tmp_path):
    assert load(tmp_path, row={"alpha": 1.5}, times=100, form=".0f") == {"one": "25"}
    assert load(tmp_path, row={"quantity": "b"}, column="alpha", form=".2f") == {"one": "1.10"}
    assert load(tmp_path, table="unknown", row={"quantity": "b"}, form=".2f") == {}
    assert load(tmp_path, count={}) == {"one": "2"}
    assert load(tmp_path, count={"quantity": "b"}) == {"one": "1"}


def test_a_bound_is_kept_or_named_and_so_is_a_row_that_is_not_one(tmp_path):
    assert load(tmp_path, row={"quantity": "b"}, bound=3.1e-7) == {"one": "3·10⁻⁷"}
    with pytest.raises(SystemExit, match=r"one .* reaches 3e-07, above the bound 2e-07"):
        load(tmp_path, row={"quantity": "b"}, bound=2e-7)
    with pytest.raises(SystemExit, match="names 0 rows"):
        load(tmp_path, row={"quantity": "c"}, form=".2f")


def test_only_known_marks_are_filled():
    page = "(9.9<!-- one -->, −2·10⁻³<!-- two -->) and 3.0<!-- three -->."
    filled = MEASURED.fill(page, {"one": "0.25", "two": "4·10⁻⁵"})
    assert filled == "(0.25<!-- one -->, 4·10⁻⁵<!-- two -->) and 3.0<!-- three -->."
    assert MEASURED.names_in(page) == ["one", "two", "three"]
