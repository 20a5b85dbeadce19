"""README and manual show the tables of this run, as closely as another machine would make them."""

import re

import numpy as np
import pytest
import update_documents as updating
from conftest import PROJECT
from test_tables import read_table

from dataset_parameters import default_parameters
from granular_fronts.scenes.yaml_files import read_yaml

UPDATE = "call workflow/scripts/report/update_documents.py, as make readme does"
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


@pytest.fixture
def default(configuration):
    """Skip a test of pages, which show the default configuration, where another is computed."""
    if default_parameters(configuration) != default_parameters(
        read_yaml(PROJECT / "config" / "default.yaml")
    ):
        pytest.skip("the pages show the default configuration")


def shown_in(page, name):
    return updating.block((PROJECT / page).read_text(encoding="utf-8"), name)


def columns(text, *left_out):
    """Cells of a table in Markdown by the heads of their columns."""
    heads, _, *rows = ([c.strip() for c in line.split("|")[1:-1]] for line in text.splitlines())
    table = dict(zip(heads, zip(*rows, strict=True), strict=True))
    return {head: "\n".join(cells) for head, cells in table.items() if head not in left_out}


def assert_alike(shown, made, within):
    """The same words, and numbers that differ by less than a part."""
    assert shown.keys() == made.keys()
    for head, text in shown.items():
        assert NUMBER.sub("#", text) == NUMBER.sub("#", made[head])
        numbers = [[float(found) for found in NUMBER.findall(one)] for one in (text, made[head])]
        np.testing.assert_allclose(*numbers, rtol=within, err_msg=head)


def test_readme_shows_numbers_errors_and_verdicts_of_the_run(results, default):
    shown, made = shown_in("README.md", "numbers"), updating.paper_numbers(results)
    assert shown_in("README.md", "score") == updating.score(results), UPDATE
    assert columns(shown, "numerical error") == columns(made, "numerical error"), UPDATE
    errors = {
        row["quantity"]: float(row["numerical error"])
        for row in read_table(results, "paper_numbers")[1]
    }
    for quantity, bound in zip(
        *(columns(shown)[head].splitlines() for head in ("quantity", "numerical error")),
        strict=True,
    ):
        assert 1e-3 < errors[quantity] / float(bound.removeprefix("< ")) < 1.0, quantity


@pytest.mark.parametrize(
    ("page", "name", "table", "of_the_machine"),
    [
        (
            "docs/performance.md",
            "durations",
            "paper_numbers",
            ["jobs", "seconds, all jobs", "seconds, longest job"],
        ),
        ("docs/performance.md", "speed", "speed_verdicts", ["verdict"]),
        ("docs/proofs.md", "proved", "proofs", ["kB", "processor seconds"]),
    ],
)
def test_pages_show_what_does_not_depend_on_the_machine(
    results, default, page, name, table, of_the_machine
):
    if not (results / "tables" / f"{table}.csv").exists():
        pytest.skip(f"the table {table} was not asked for")
    made = getattr(updating, name)(results)
    assert_alike(*(columns(text, *of_the_machine) for text in (shown_in(page, name), made)), 0.02)
