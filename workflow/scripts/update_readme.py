"""Put the numbers and the figure of the last run into the README."""

import shutil
from pathlib import Path

import pandas as pd

from granular_fronts.output.files import complete_file
from granular_fronts.output.statements import HOLDS
from step import run_step

FIGURE = "fig01_initiation_underdamped.png"


def update_readme(readme: Path, results: Path) -> None:
    """Replace the marked tables of the README, and the figure beside it.

    Parameters
    ----------
    readme : Path
        File with blocks between ``<!-- name -->`` and ``<!-- end of name -->``.
    results : Path
        Folder of a finished run of the targets all and precision.
    """
    text = readme.read_text(encoding="utf-8")
    for name, table in (("numbers", paper_numbers(results)), ("speed", speed(results))):
        text = replace_block(text, name, table)
    with complete_file(readme) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
    shutil.copyfile(results / "figures" / FIGURE, readme.parent / "workflow" / "report" / FIGURE)


def paper_numbers(results: Path) -> str:
    """The numbers of the paper, and its words that do not hold, beside ours, as Markdown."""
    statements = pd.read_csv(results / "tables" / "paper_numbers.csv", keep_default_na=False)
    held = (statements["kind"] == "words") & (statements["verdict"] == HOLDS)
    table = statements[~held]
    shown = pd.DataFrame(
        {
            "quantity": table["quantity"],
            "printed": table["printed"],
            "computed": [f"{float(value):.6g}" for value in table["computed"]],
            "numerical error": [f"{float(value):.0e}" for value in table["numerical error"]],
            "verdict": table["verdict"],
        }
    )
    rows = shown.to_markdown(index=False, disable_numparse=True)
    return f"{rows}\n\n{held.sum()} further statements in words hold by the criteria of the table."


def speed(results: Path) -> str:
    """What to use for each problem and error, as Markdown."""
    verdicts = pd.read_csv(results / "tables" / "speed_verdicts.csv", dtype=str)
    return verdicts.to_markdown(index=False, disable_numparse=True)


def replace_block(text: str, name: str, content: str) -> str:
    """The text with what stands between the marks of a block replaced."""
    start, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    before, rest = text.split(start)
    _, after = rest.split(end)
    return f"{before}{start}\n{content}\n{end}{after}"


if __name__ == "__main__":
    run_step(update_readme, globals().get("snakemake"))
