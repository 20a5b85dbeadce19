"""Write one page with the score, figures, captions, tables, configuration and run times.

The page holds everything in itself, so it can be mailed or archived as one file. Its links lead to
the files next to it. Snakemake's own report shows neither the configuration nor the figures before
a click, hence this one. What is made on demand is shown as it was made last.
"""

import json
import os
import re
from base64 import b64encode
from collections import Counter
from pathlib import Path
from typing import Any

import jinja2
import pandas as pd
import yaml
from docutils.core import publish_parts

from captions import read_texts
from granular_fronts.output.files import complete_file
from granular_fronts.output.statements import (
    COMPATIBLE,
    DOES_NOT_HOLD,
    HOLDS,
    NOT_COMPATIBLE,
    NOT_JUDGED,
    NOT_REPRODUCED,
    OTHER_PARAMETERS,
    OUT_OF_REACH,
    REPRODUCED,
    UNDECIDED,
)
from job import job

TABLE = "table_"
"""Begins the name of a file with the texts of a table."""

PAPER_TABLE = "paper_numbers"
SIGNS = {
    HOLDS: ("good", "✓"),
    REPRODUCED: ("good", "✓"),
    COMPATIBLE: ("good", "✓"),
    NOT_JUDGED: ("open", "–"),
    OUT_OF_REACH: ("open", "–"),
    OTHER_PARAMETERS: ("open", "–"),
    UNDECIDED: ("open", "?"),
    DOES_NOT_HOLD: ("bad", "✗"),
    NOT_REPRODUCED: ("bad", "✗"),
    NOT_COMPATIBLE: ("bad", "✗"),
}
"""Class and sign of each verdict, so that it can be read without its colour."""

FOR_MACHINES = ["kind", "expected"]


def write_report(
    template: str,
    texts: list[str],
    results: str,
    benchmarks: list[str],
    verdict: str,
    configuration: dict,
    page: str,
) -> None:
    """Fill the template of the page.

    Parameters
    ----------
    template : str
        Jinja2 template of the page.
    texts : list of str
        Files with the texts of all figures and tables: NAME.rst is about the figure NAME, and
        table_NAME.rst about the table NAME.
    results : str
        The folder that holds data, figures and tables.
    benchmarks : list of str
        Snakemake's measurements, a TSV file for each job.
    verdict : str
        File with what the tests of the finished files said.
    configuration : dict
        The merged configuration that was computed.
    page : str
        The HTML file to write.
    """
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined)
    tables = [
        _describe_table(Path(results), text) for text in texts if Path(text).stem.startswith(TABLE)
    ]
    figures = [
        _describe_figure(Path(results), text)
        for text in texts
        if not Path(text).stem.startswith(TABLE)
    ]
    html = environment.from_string(Path(template).read_text(encoding="utf-8")).render(
        parts=[
            {
                "name": name,
                "title": title,
                "figures": [one for one in figures if one["of_paper"] == of_paper],
                "tables": [one for one in tables if one["of_paper"] == of_paper],
            }
            for name, title, of_paper in (
                ("paper", "The paper", True),
                ("beyond", "Beyond the paper", False),
            )
        ],
        judged=[table for table in tables if table["score"]],
        signs=SIGNS,
        run_times=_tabulate_run_times([Path(file) for file in benchmarks]),
        verdict=Path(verdict).read_text(encoding="utf-8"),
        configuration=_dump_configuration(configuration),
    )
    with complete_file(page) as unfinished:
        unfinished.write_text(html, encoding="utf-8")


def _dump_configuration(configuration: dict) -> str:
    """The configuration as YAML, with every value where it is used."""
    # What two keys share would else be written once, and named by an anchor.
    plain = json.loads(json.dumps(configuration))
    return yaml.safe_dump(plain, sort_keys=False, allow_unicode=True, default_flow_style=None)


def _describe_figure(results: Path, text: str) -> dict[str, Any]:
    """What the page shows of a figure."""
    name, texts = Path(text).stem, read_texts(text)
    numbered = re.match(r"fig0*(\d+)_", name)
    picture = b64encode((results / f"figures/{name}.png").read_bytes()).decode("ascii")
    return {
        "name": name,
        "of_paper": numbered is not None,
        "title": f"{numbered[1]}. {texts.title}" if numbered else texts.title,
        "alt": texts.comment,
        "image": f"data:image/png;base64,{picture}",
        "caption": _render((results / f"figures/{name}.rst").read_text(encoding="utf-8")),
        "files": [f"figures/{name}.{ending}" for ending in ("pdf", "png")],
    }


def _describe_table(results: Path, text: str) -> dict[str, Any]:
    """What the page shows of a table, and the score of a table of statements."""
    name, texts = Path(text).stem.removeprefix(TABLE), read_texts(text)
    cells = pd.read_csv(results / f"tables/{name}.csv", dtype=str, keep_default_na=False)
    verdicts = cells["verdict"] if "expected" in cells else []
    failed = (
        cells[[SIGNS[verdict][0] == "bad" for verdict in verdicts]] if len(verdicts) else cells[:0]
    )
    return {
        "name": name,
        "of_paper": name == PAPER_TABLE,
        "title": texts.title,
        "meaning": texts.comment,
        "caption": _render(texts.caption),
        "score": Counter(verdicts),
        "failed": failed.to_dict("records"),
        "files": [f"tables/{name}.{ending}" for ending in ("csv", "md")],
        **_readable(cells),
    }


def _render(caption: str) -> str:
    """Turn the reStructuredText of a caption into HTML."""
    # Browsers draw MathML themselves; the default wants a style sheet of its own. A caption holds
    # values of data files, which may come from anywhere.
    settings = {"math_output": "MathML", "raw_enabled": False, "file_insertion_enabled": False}
    return publish_parts(caption, writer="html5", settings_overrides=settings)["fragment"]


def _readable(cells: pd.DataFrame) -> dict[str, Any]:
    """Heads and rows of a table for reading: rounded, numbers to the right, errors after ±."""
    cells = cells.drop(columns=FOR_MACHINES, errors="ignore")
    for column in cells:
        digits = ".1e" if "error" in column else ".7g"
        cells[column] = [_shorten(cell, digits) for cell in cells[column]]
    for error in [column for column in cells if column.removesuffix("_error") in cells.columns]:
        if error.endswith("_error"):
            value = error.removesuffix("_error")
            cells[value] = cells[value] + " ± " + cells.pop(error)
    heads = [
        (column.replace("_", " "), all(_is_number(cell) for cell in cells[column]))
        for column in cells
    ]
    return {"heads": heads, "rows": cells.to_numpy().tolist()}


def _is_number(cell: str) -> bool:
    """Whether a cell holds a number, perhaps with its error, or nothing."""
    try:
        return not cell or float(cell.partition(" ± ")[0]) is not None
    except ValueError:
        return False


def _shorten(cell: str, digits: str) -> str:
    """Round a number of more than eight characters; leave words and short numbers as they are."""
    try:
        return f"{float(cell):{digits}}" if len(cell) > 8 else cell
    except ValueError:
        return cell


def _tabulate_run_times(benchmarks: list[Path]) -> dict[str, Any]:
    """Snakemake's measurements as a table, their sum last."""
    folder = os.path.commonpath([file.parent for file in benchmarks])
    rows, total = [], 0.0
    for file in benchmarks:
        measured = pd.read_csv(file, sep="\t", dtype=str, keep_default_na=False).iloc[0]
        job = file.relative_to(folder).with_suffix("").as_posix()
        rows.append([job, f"{float(measured['s']):.1f}", measured["max_rss"]])
        total += float(measured["s"])
    heads = [("job", False), ("wall time, s", True), ("largest memory, MiB", True)]
    return {"heads": heads, "rows": [*rows, ["all jobs", f"{total:.1f}", ""]]}


if __name__ == "__main__":
    with job(snakemake):
        write_report(
            snakemake.input.template,
            snakemake.params.texts,
            snakemake.params.results,
            snakemake.input.benchmarks,
            snakemake.input.verdict,
            snakemake.params.configuration,
            snakemake.output.page,
        )
