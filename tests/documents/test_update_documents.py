"""README and manual take numbers and the moving picture from the last run, and keep the rest."""

import re

import numpy as np
import pandas as pd
import pytest
import update_documents as updating
from projects import ROOT

README = """# Title

<!-- score -->
stale
<!-- end of score -->
<!-- numbers -->
stale
<!-- end of numbers -->
End.
"""
PERFORMANCE = """Before.
<!-- durations -->
stale
<!-- end of durations -->
<!-- speed -->
stale
<!-- end of speed -->
"""


@pytest.fixture
def updated(tmp_path):
    """Both documents and the copied picture after an update from a small results folder."""
    results, readme = tmp_path / "results", tmp_path / "README.md"
    performance, proofs = tmp_path / "performance.md", tmp_path / "proofs.md"
    for folder in ("results/tables", "results/animation", "results/benchmarks/study", "docs"):
        (tmp_path / folder).mkdir(parents=True)
    for job, seconds in (("study/piston", 3), ("study/survey", 4), ("plot_fig01", 1)):
        (results / "benchmarks" / f"{job}.tsv").write_text(f"s\th:m:s\n{seconds}\t0\n")
    rows = [(quantity, "0.56", 0.562341325, 3e-12, "reproduced") for quantity in updating.SHOWN]
    rows += [("fronts exist", "", 1.0, 0.0, "holds")] * 2
    columns = ["quantity", "printed", "computed", "numerical error", "verdict"]
    table = pd.DataFrame(rows, columns=columns)
    table.to_csv(results / "tables" / "paper_numbers.csv", index=False)
    verdicts = results / "tables" / "speed_verdicts.csv"
    verdicts.write_text("problem,error,verdict\nring,1e-09,use it\n", encoding="utf-8")
    (results / "animation" / updating.PICTURE).write_bytes(b"picture")
    readme.write_text(README, encoding="utf-8")
    performance.write_text(PERFORMANCE, encoding="utf-8")
    proofs.write_text("<!-- proved -->\nstale\n<!-- end of proved -->\n", encoding="utf-8")
    table = "| front | shape |\n|---|---|\n| figure 3 | monotone |\n"
    updating.update_documents(readme, performance, proofs, results)
    assert "stale" in proofs.read_text(encoding="utf-8"), "its table is not made yet"
    for ending in ("csv", "md"):
        (results / "tables" / f"proofs.{ending}").write_text(table, encoding="utf-8")
    updating.update_documents(readme, performance, proofs, results)
    assert proofs.read_text(encoding="utf-8") == f"<!-- proved -->\n{table}<!-- end of proved -->\n"
    picture = tmp_path / "docs" / updating.PICTURE
    return readme.read_text(encoding="utf-8"), performance.read_text(encoding="utf-8"), picture


def cells(text):
    return [[cell.strip() for cell in line.split("|")] for line in text.splitlines()]


def test_blocks_are_replaced_and_nothing_else(updated):
    readme, performance, picture = updated
    assert "stale" not in readme + performance
    assert readme.startswith("# Title\n\n<!-- score -->\nVerdicts on 12 ")
    assert "<!-- end of score -->\n<!-- numbers -->\n|" in readme
    assert readme.endswith("<!-- end of numbers -->\nEnd.\n")
    assert performance.startswith("Before.\n<!-- durations -->\n|")
    assert picture.read_bytes() == b"picture"


def test_chosen_numbers_are_shown_and_all_verdicts_counted(updated):
    readme, performance, _ = updated
    for quantity in updating.SHOWN:
        assert ["", quantity, "0.56", "0.562341", "< 1e-11", "reproduced", ""] in cells(readme)
    assert not any("fronts exist" in row for row in cells(readme))
    assert "12 numbers and statements of the paper: **10** reproduced · **2** holds." in readme
    assert ["", "ring", "1e-09", "use it", ""] in cells(performance)


@pytest.mark.parametrize("error", [2.07e-3, 1.1e-16, 3.34e-13, 9.9e-12, 1.0])
def test_a_shown_error_is_the_next_power_of_ten_above_three_times_the_error(error):
    shown = float(updating.bound(error).removeprefix("< "))
    assert 3.0 * error <= shown < 30.0 * error
    assert np.log10(shown) == pytest.approx(round(np.log10(shown)))
    assert updating.bound(0.0) == "exact"


def test_durations_are_sums_of_jobs(updated):
    _, performance, _ = updated
    assert ["", "solve scenes and studies", "2", "7", "4", ""] in cells(performance)
    assert ["", "draw figures", "1", "1", "1", ""] in cells(performance)


def test_prose_on_proofs_has_the_bounds_of_its_table():
    page = (ROOT / "docs" / "proofs.md").read_text(encoding="utf-8")
    shapes = {row[1]: row[5] for row in cells(updating.block(page, "proved"))}
    above = {name: float(shapes[name].split(" > ")[1]) for name in ("figure_1", "hertz_0_2")}
    words = " ".join(page.split())
    assert f"maximum above {1.0 + above['figure_1']:.4f}" in words
    [printed] = re.findall(r"= 0\.2\b\$? [^.]*overshoots,? by more than (\d+\.\d\d) %", words)
    assert printed == f"{100 * above['hertz_0_2']:.2f}"
    for name in ("figure_3", "hertz_0_3", "hertz_0_3333"):
        assert shapes[name].startswith("monotone")
