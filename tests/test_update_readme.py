"""The README takes its numbers and its figure from the last run, and keeps the rest."""

import pandas as pd
import pytest
import update_readme as updating

README = """# Title

<!-- numbers -->
stale
<!-- end of numbers -->
Between.
<!-- speed -->
stale
<!-- end of speed -->
End.
"""
STATEMENTS = [
    ("speed of the front", "number", "0.56", 0.562341325, 3e-12, "reproduced"),
    ("fronts exist", "words", "", 1.0, 0.0, "holds"),
    ("fronts are steep", "words", "", 2.5, 1e-3, "does not hold"),
]


@pytest.fixture
def updated(tmp_path):
    """The README and the copied figure after an update from a small results folder."""
    results, readme = tmp_path / "results", tmp_path / "README.md"
    for folder in (results / "tables", results / "figures", tmp_path / "workflow" / "report"):
        folder.mkdir(parents=True)
    columns = ["quantity", "kind", "printed", "computed", "numerical error", "verdict"]
    table = pd.DataFrame(STATEMENTS, columns=columns)
    table.to_csv(results / "tables" / "paper_numbers.csv", index=False)
    verdicts = results / "tables" / "speed_verdicts.csv"
    verdicts.write_text("problem,error,verdict\nring,1e-09,use it\n", encoding="utf-8")
    (results / "figures" / updating.FIGURE).write_bytes(b"picture")
    readme.write_text(README, encoding="utf-8")
    updating.update_readme(readme, results)
    return readme.read_text(encoding="utf-8"), tmp_path / "workflow" / "report" / updating.FIGURE


def test_blocks_are_replaced_and_nothing_else(updated):
    text, figure = updated
    assert "stale" not in text
    assert text.startswith("# Title\n\n<!-- numbers -->\n|")
    assert "<!-- end of numbers -->\nBetween.\n<!-- speed -->\n" in text
    assert text.endswith("<!-- end of speed -->\nEnd.\n")
    assert figure.read_bytes() == b"picture"


def test_numbers_are_shown_and_words_that_hold_are_counted(updated):
    rows = [[cell.strip() for cell in line.split("|")] for line in updated[0].splitlines()]
    assert ["", "speed of the front", "0.56", "0.562341", "3e-12", "reproduced", ""] in rows
    assert ["", "fronts are steep", "", "2.5", "1e-03", "does not hold", ""] in rows
    assert not any("fronts exist" in row for row in rows)
    assert "1 further statements in words hold" in updated[0]
    assert ["", "ring", "1e-09", "use it", ""] in rows
