"""Write one page with figures, captions, tables, configuration and run times.

The page holds everything in itself, so it can be mailed or archived as one file. Snakemake's own
report shows neither the configuration nor the figures before a click, hence this one.
"""

import csv
import os
from base64 import b64encode
from pathlib import Path

import jinja2
import yaml
from docutils.core import publish_parts
from tabulate import tabulate

from granular_fronts.files import complete_file
from step import run_step


def write_report(
    template: Path,
    figures: list[Path],
    captions: list[Path],
    tables: list[Path],
    speed: list[Path],
    speed_caption: Path,
    benchmarks: list[Path],
    verdict: Path,
    configuration: dict,
    page: Path,
) -> None:
    """Fill the template of the page.

    Parameters
    ----------
    template : Path
        Jinja2 template of the page.
    figures : list of Path
        PNG files, in the order of the page.
    captions : list of Path
        A reStructuredText file for each figure.
    tables : list of Path
        CSV files with a header.
    speed : list of Path
        Figure and tables of the target precision, as far as they are there.
    speed_caption : Path
        A reStructuredText file for that figure.
    benchmarks : list of Path
        Snakemake's measurements, a TSV file for each job.
    verdict : Path
        What the tests of the finished files said.
    configuration : dict
        The merged configuration that was computed.
    page : Path
        The HTML file to write.
    """
    speed_figures = [file for file in speed if file.suffix == ".png"]
    shown = [
        *zip(figures, captions, strict=True),
        *((file, speed_caption) for file in speed_figures),
    ]
    tables = [*tables, *(file for file in speed if file.suffix == ".csv")]
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined)
    html = environment.from_string(template.read_text(encoding="utf-8")).render(
        figures=[
            {"name": figure.stem, "image": embed(figure), "caption": render(caption)}
            for figure, caption in shown
        ],
        tables=[
            {"name": table.stem.replace("_", " "), "html": tabulate_csv(table)} for table in tables
        ],
        run_times=tabulate_run_times(benchmarks),
        verdict=verdict.read_text(encoding="utf-8"),
        configuration=yaml.safe_dump(
            configuration, sort_keys=False, allow_unicode=True, default_flow_style=None
        ),
    )
    with complete_file(page) as unfinished:
        unfinished.write_text(html, encoding="utf-8")


def embed(figure: Path) -> str:
    """Put a PNG file into text.

    Parameters
    ----------
    figure : Path
        The file.

    Returns
    -------
    str
        A data URL.
    """
    return f"data:image/png;base64,{b64encode(figure.read_bytes()).decode('ascii')}"


def render(caption: Path) -> str:
    """Turn a caption into HTML.

    Parameters
    ----------
    caption : Path
        A reStructuredText file.

    Returns
    -------
    str
        The HTML of its paragraphs.
    """
    return publish_parts(caption.read_text(encoding="utf-8"), writer="html5")["fragment"]


def tabulate_csv(table: Path) -> str:
    """Turn a CSV file with a header into HTML, its numbers rounded for reading.

    Parameters
    ----------
    table : Path
        The file.

    Returns
    -------
    str
        An HTML table.
    """
    with table.open(newline="", encoding="utf-8") as lines:
        header, *rows = csv.reader(lines)
    digits = [".1e" if "error" in column else ".7g" for column in header]
    rounded = [[shorten(*cell) for cell in zip(row, digits, strict=True)] for row in rows]
    headers = [column.replace("_", " ") for column in header]
    return tabulate(rounded, headers, tablefmt="html", disable_numparse=True)


def shorten(text: str, digits: str) -> str:
    """Round a number that is written with more digits than a page should show.

    Parameters
    ----------
    text : str
        A cell of a table; words and short numbers are left alone.
    digits : str
        Format of a longer number.

    Returns
    -------
    str
        The cell to show.
    """
    try:
        return f"{float(text):{digits}}" if len(text) > 8 else text
    except ValueError:
        return text


def tabulate_run_times(benchmarks: list[Path]) -> str:
    """Turn Snakemake's measurements into an HTML table.

    Parameters
    ----------
    benchmarks : list of Path
        A TSV file for each job, of one line; its path below the common folder names the job.

    Returns
    -------
    str
        An HTML table with a line for each job, and their sum.
    """
    folder = os.path.commonpath([file.parent for file in benchmarks])
    rows = []
    for file in benchmarks:
        with file.open(newline="", encoding="utf-8") as lines:
            measured = next(csv.DictReader(lines, delimiter="\t"))
        job = file.relative_to(folder).with_suffix("").as_posix()
        rows.append([job, float(measured["s"]), measured["max_rss"]])
    rows.append(["all jobs", sum(seconds for _, seconds, _ in rows), ""])
    return tabulate(
        [[job, f"{seconds:.1f}", memory] for job, seconds, memory in rows],
        headers=["job", "wall time, s", "largest memory, MiB"],
        colalign=["left", "right", "right"],
        tablefmt="html",
        disable_numparse=True,
    )


if __name__ == "__main__":
    run_step(write_report, globals().get("snakemake"))
