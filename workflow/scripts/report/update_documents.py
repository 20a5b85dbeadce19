"""Put numbers and the moving picture of a run into the README, times and proofs into the manual."""

import math
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

JOBS = {
    "compile kernels, once": ("compile_",),
    "solve scenes and studies": ("initiate_", "compare_", "compute_", "shoot_", "study"),
    "draw figures": ("plot_",),
    "write tables and report": ("tabulate_", "write_report"),
    "test the finished files": ("check_results",),
}
"""Parts of a plain call, by how the names of their rules begin."""


def update_documents(readme: Path, performance: Path, proofs: Path, results: Path) -> None:
    """Replace the marked tables of the documents, and the moving picture of the README.

    Parameters
    ----------
    readme, performance, proofs : Path
        Files with blocks between ``<!-- name -->`` and ``<!-- end of name -->``: verdicts and
        numbers of the paper, times, and what is proved.
    results : Path
        Folder of a finished run of the target all; of precision, animation and proofs, what was
        not made stays as it is.
    """
    for page, name, table, make_block in (
        (readme, "score", "paper_numbers", score),
        (readme, "numbers", "paper_numbers", paper_numbers),
        (performance, "durations", "paper_numbers", durations),
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
    """Ten numbers of the paper and ours, as Markdown."""
    table = _statements(results).set_index("quantity").loc[list(SHOWN)].reset_index()
    shown = pd.DataFrame(
        {
            "quantity": table["quantity"],
            "printed": table["printed"],
            "computed": [f"{float(value):.6g}" for value in table["computed"]],
            "numerical error": [bound(float(value)) for value in table["numerical error"]],
            "verdict": table["verdict"],
        }
    )
    return shown.to_markdown(index=False, disable_numparse=True)


def score(results: Path) -> str:
    """How many numbers and statements of the paper got which verdict, as Markdown."""
    verdicts = _statements(results)["verdict"]
    listed = " · ".join(f"**{n}** {verdict}" for verdict, n in verdicts.value_counts().items())
    return f"Verdicts on {len(verdicts)} numbers and statements of the paper: {listed}."


def _statements(results: Path) -> pd.DataFrame:
    return pd.read_csv(results / "tables" / "paper_numbers.csv", keep_default_na=False)


def bound(error: float) -> str:
    """The power of ten above three times an error: another machine may find a larger one."""
    return f"< 1e{math.ceil(math.log10(3.0 * error)):03d}" if error > 0.0 else "exact"


def durations(results: Path) -> str:
    """Jobs of a plain call and the seconds that they took, as Markdown."""
    folder = results / "benchmarks"
    jobs = [
        (file.relative_to(folder).parts[0], pd.read_csv(file, sep="\t")["s"].iloc[-1])
        for file in folder.rglob("*.tsv")
    ]
    rows = []
    for what, rules in JOBS.items():
        taken = [seconds for rule, seconds in jobs if rule.startswith(rules)]
        rows.append((what, len(taken), f"{sum(taken):.0f}", f"{max(taken, default=0.0):.0f}"))
    columns = ["what", "jobs", "seconds, all jobs", "seconds, longest job"]
    return pd.DataFrame(rows, columns=columns).to_markdown(index=False, disable_numparse=True)


def speed(results: Path) -> str:
    """What to use for each problem and error, as Markdown."""
    verdicts = pd.read_csv(results / "tables" / "speed_verdicts.csv", dtype=str)
    return verdicts.to_markdown(index=False, disable_numparse=True)


def proved(results: Path) -> str:
    """Fronts and families of fronts that are proved, as Markdown."""
    return (results / "tables" / "proofs.md").read_text(encoding="utf-8").strip()


def _replace_block(text: str, name: str, content: str) -> str:
    """The text, with another one between the marks of a block."""
    mark = f"<!-- {name} -->\n"
    return text.replace(mark + block(text, name), mark + content)


def block(text: str, name: str) -> str:
    """Return the text between the marks of a block."""
    return text.split(f"<!-- {name} -->\n")[1].split(f"\n<!-- end of {name} -->")[0]


if __name__ == "__main__":
    run_step(update_documents, globals().get("snakemake"))
