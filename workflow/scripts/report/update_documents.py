"""Put numbers and the moving picture of a run into the README, times and proofs into the manual."""

import shutil
from pathlib import Path

import pandas as pd

from granular_fronts.output.files import complete_file
from step import run_step

PICTURE = "front.gif"

SHOWN = (
    "front speed c of eq. (21)",
    "front speed c measured in the chain, γ = 0.06",
    "largest elastic force of the front over the applied pressure, γ = 0.06",
    "time at which beads are first ejected, γ = 0.06",
    "smallest relative displacement, γ = 0.06",
    "time of the smallest relative displacement, γ = 0.06",
    "mean of (x_1 − x_N)/(N δ) over a period, γ = 0.06",
    "limit of γ/(1 − e) as e → 1, α = β = 3/2",
    "excess of the peak of u by the upwind scheme over the chain's, percent, α = 3/2",
    "damping μ at which the oscillations end",
)
"""The quantities that the README shows, one of each kind and the one that does not hold."""


def update_documents(readme: Path, performance: Path, proofs: Path, results: Path) -> None:
    """Replace the marked tables of the documents, and the moving picture of the README.

    Parameters
    ----------
    readme, performance, proofs : Path
        Files with a block between ``<!-- name -->`` and ``<!-- end of name -->``: numbers of the
        paper, times, and what is proved.
    results : Path
        Folder of a finished run of the target all; of precision, animation and proofs, what was
        not made stays as it is.
    """
    for page, name, table, make_block in (
        (readme, "numbers", "paper_numbers", paper_numbers),
        (performance, "speed", "speed_verdicts", speed),
        (proofs, "proved", "proofs", proved),
    ):
        if (results / "tables" / f"{table}.csv").exists():
            text = _replace_block(page.read_text(encoding="utf-8"), name, make_block(results))
            with complete_file(page) as unfinished:
                unfinished.write_text(text, encoding="utf-8")
    if (results / "animation" / PICTURE).exists():
        shutil.copyfile(results / "animation" / PICTURE, readme.parent / "docs" / PICTURE)


def paper_numbers(results: Path) -> str:
    """Numbers of the paper beside ours, and how many statements hold, as Markdown."""
    statements = pd.read_csv(results / "tables" / "paper_numbers.csv", keep_default_na=False)
    table = statements.set_index("quantity").loc[list(SHOWN)].reset_index()
    shown = pd.DataFrame(
        {
            "quantity": table["quantity"],
            "printed": table["printed"],
            "computed": [f"{float(value):.6g}" for value in table["computed"]],
            "numerical error": [bound(float(value)) for value in table["numerical error"]],
            "verdict": table["verdict"],
        }
    )
    rows = shown.to_markdown(index=False, disable_numparse=True)
    counts = statements["verdict"].value_counts()
    verdicts = ", ".join(f"{verdict} {count}" for verdict, count in counts.items())
    return f"{rows}\n\nVerdicts on all {len(statements)} numbers and statements: {verdicts}."


def bound(error: float) -> str:
    """Ten times an error, to one digit: another machine may find several times as much."""
    return f"< {10.0 * error:.0e}"


def speed(results: Path) -> str:
    """What to use for each problem and error, as Markdown."""
    verdicts = pd.read_csv(results / "tables" / "speed_verdicts.csv", dtype=str)
    return verdicts.to_markdown(index=False, disable_numparse=True)


def proved(results: Path) -> str:
    """Fronts and families of fronts that are proved, as Markdown."""
    return (results / "tables" / "proofs.md").read_text(encoding="utf-8").strip()


def _replace_block(text: str, name: str, content: str) -> str:
    """The text with what stands between the marks of a block replaced."""
    return text.replace(block(text, name), content)


def block(text: str, name: str) -> str:
    """Return the text between the marks of a block."""
    return text.split(f"<!-- {name} -->\n")[1].split(f"\n<!-- end of {name} -->")[0]


if __name__ == "__main__":
    run_step(update_documents, globals().get("snakemake"))
