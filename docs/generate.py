"""Pages of the manual that follow from the code and from the results of a finished run.

The manual's build writes them into docs/generated, so that no name, range or number is typed twice.
"""

import inspect
import math
import re
from pathlib import Path
from typing import Any, NamedTuple

import pandas as pd
import yaml
from configuration import campaign_page, configuration_page
from measured import in_print

import granular_fronts
from granular_fronts.output.datasets import long_names

ROOT = Path(__file__).parents[1]
WORKFLOW = ROOT / "workflow"


def _read_yaml(name: str) -> Any:
    """A YAML file of the workflow."""
    return yaml.safe_load((WORKFLOW / name).read_text(encoding="utf-8"))


FIGURES = _read_yaml("figures.yaml")


def write_pages(folder: Path, results: Path) -> None:
    """Write every generated page.

    Parameters
    ----------
    folder : Path
        Where to; made where it is missing.
    results : Path
        Results of a finished run of the workflow.

    Raises
    ------
    SystemExit
        If the workflow has not run: its report is missing.
    """
    if not (results / "report.html").exists():
        raise SystemExit(f"The manual shows results, and {results} has none: run make first.")
    folder.mkdir(exist_ok=True)
    made = {
        "public_names": public_names(),
        **{f"api_{group.page}": group_page(group) for group in GROUPS},
        "configuration": configuration_page(),
        "campaigns": campaign_page(),
        "variables": _variables(),
        "figures": figures_page(results),
        "paper_numbers": _tables(results, ["paper_numbers"]),
        "findings": _tables(results, ["findings"]),
        "papers": papers_page(results),
        "tables": _tables(results, ["front_properties", "critical_damping", "jump_conditions"]),
    }
    for name, text in made.items():
        page = folder / f"{name}.md"
        # An unchanged page is not read again by the build.
        if not page.exists() or page.read_text(encoding="utf-8") != text:
            page.write_text(text, encoding="utf-8")


class Group(NamedTuple):
    """Public names that belong together, shown on a page with a picture."""

    page: str
    title: str
    words: str
    figure: str


GROUPS = (
    Group("chains", "Chains", "Integrate the motion of a chain or of a ring of beads.", "1"),
    Group("fronts", "Fronts", "Solve a front of the lattice, its tail and its stability.", "9"),
    Group("equations", "Amplitude equations", "Solve the long-wave equations of the chain.", "8"),
    Group("laws", "Laws and scaling", "Choose a contact law, and convert real beads.", "17"),
    Group("proofs", "Proofs", "Prove that a front exists, and check a proof.", "24"),
    Group("plots", "Plots", "Draw a dataset in one line.", "13"),
)

NAMES = {
    "chains": "simulate_chain Chain pulses",
    "fronts": """solve_front Front evaluate_front sweep_fronts tail_roots critical_damping
        front_multipliers""",
    "equations": "log_burgers_front heteroclinic evolve_log_burgers evolve_log_kdv_burgers Ring",
    "laws": """make_law Potential jump_conditions restitution damping_for_restitution
        Scaling sphere_stiffness contact_stiffness damping_from_restitution""",
    "proofs": "prove_front check_certificate",
    "plots": "plot",
}
"""Public names by the page of their group."""


def public_names() -> str:
    """The groups of public names, each name with the first sentence of its docstring."""
    lines = ["# Python", "", "```python", "import granular_fronts as gf", "```", ""]
    lines += [
        "Arguments and results are dimensionless. Only `gf.Scaling`, `gf.sphere_stiffness`,",
        "`gf.contact_stiffness` and `gf.damping_from_restitution` have units, those of real beads.",
        "A test runs every example.",
    ]
    for group in GROUPS:
        lines += ["", f"## {group.title}", "", group.words, "", "| name | what |", "|---|---|"]
        for name, value in _members(group):
            place = f"api_{group.page}.md#{name.lower().replace('.', '')}"
            sentence = " ".join(inspect.getdoc(value).split("\n\n")[0].split())
            sentence = re.sub(r":math:`([^`]*)`", r"$\1$", sentence).replace("|", "\\|")
            lines.append(f"| [`{name}`]({place}) | {sentence} |")
    pages = [f"api_{group.page}" for group in GROUPS]
    return "\n".join([*lines, "", "```{toctree}", ":hidden:", *pages, "```"]) + "\n"


def _members(group: Group) -> list[tuple[str, Any]]:
    """Names of a group as a user writes them, those of a module one by one."""
    found = []
    for name in NAMES[group.page].split():
        value = getattr(granular_fronts, name)
        inside = value.__all__ if inspect.ismodule(value) else []
        found += [(f"gf.{name}.{one}", getattr(value, one)) for one in inside]
        found += [] if inside else [(f"gf.{name}", value)]
    return found


def group_page(group: Group) -> str:
    """A group of public names with their docstrings."""
    lines = [f"# {group.title}", "", group.words, "", f"<!-- figure {group.figure} -->"]
    for name, value in _members(group):
        kind = "class" if inspect.isclass(value) else "function"
        members = ["   :members:"] if kind == "class" else []
        # Docstrings are reStructuredText.
        lines += ["", f"## {name}", "", "```{eval-rst}", f".. auto{kind}:: {name}", *members, "```"]
    return "\n".join(lines) + "\n"


VARIABLES = """# Variables

Names of variables and coordinates in the netCDF files below `results/data`, each with its attribute
`long_name`. A recording with coordinates of its own ends them with its name:
`relative_displacement_grid` on (`t_grid`, `bead`). What the letters stand for:
[symbols](../symbols.md).

| variable | what |
|---|---|
"""


def _variables() -> str:
    """Every variable of the result files, in words."""
    rows = [f"| `{name}` | {meaning} |" for name, meaning in sorted(long_names().items())]
    return VARIABLES + "\n".join(rows) + "\n"


def figures_page(results: Path) -> str:
    """Every figure, with the caption of what was computed, or with the command that draws it."""
    lines = ["# Figures"]
    for name in FIGURES:
        file = _drawn(name, results)
        lines += [
            "",
            f"({name})=",
            "",
            f"## {_title(name)}",
            "",
            *_picture(name, FIGURES[name]["alt"], file, "../.."),
        ]
        caption = file.with_suffix(".rst")
        if caption.exists():
            # Captions are reStructuredText.
            lines += ["", "```{eval-rst}", caption.read_text(encoding="utf-8").strip(), "```"]
    return "\n".join(lines) + "\n"


def _title(name: str) -> str:
    """Number and title of a figure."""
    return f"Figure {name[3:].lstrip('0')}. {FIGURES[name]['title']}"


def _drawn(name: str, results: Path) -> Path:
    """The file of a figure."""
    return results / "figures" / f"{name}_{FIGURES[name]['name']}.png"


def _picture(name: str, alt: str, file: Path, up: str) -> list[str]:
    """A figure as Markdown, or the command that draws it where it was not asked for."""
    if not file.exists():
        return [f"This figure is drawn on demand, by `snakemake -c2 {name}`."]
    return [f"![{alt}]({up}/results/figures/{file.name})"]


PICTURE = re.compile(r"<!-- figure (?P<number>\d+b?) -->")
"""Where a page shows a figure of the run."""


def fill_pictures(text: str, page: str, results: Path) -> str:
    """A page with the figures of a run where it asks for them.

    Parameters
    ----------
    text : str
        The page; ``<!-- figure 12 -->`` in a line of its own asks for a figure.
    page : str
        Its path below docs, from which the paths of pictures follow.
    results : Path

    Returns
    -------
    str
    """

    def fill(found: re.Match[str]) -> str:
        number = found["number"]
        name = f"fig{number.zfill(3 if number.endswith('b') else 2)}"
        up = "../" * page.count("/") + ".."
        file, title = _drawn(name, results), f"*{_title(name)}.*"
        picture = _picture(name, FIGURES[name]["alt"], file, up)
        return "\n".join([*picture, "", title] if file.exists() else [f"{title} {picture[0]}"])

    return PICTURE.sub(fill, text)


PAPERS = """# What was found beyond other papers

Each paper with a folder of its own has a table of numbers that were not in what was read of it;
the folder on weak damping is about no paper.
A finding holds if its value with its error meets the criterion. The last column names a second
method that was asked, and has a dash where none was. All of it is made on demand, by
`snakemake -c2 papers`. The page of a folder says what was read, and what else was found.
"""


def papers_page(results: Path) -> str:
    """What was found on the subject of each paper, and its figures, as far as they were made."""
    lines = [PAPERS]
    for file in sorted((ROOT / "papers").glob("*/paper.yaml")):
        paper, listed = file.parent.name, yaml.safe_load(file.read_text(encoding="utf-8"))
        lines += [f"## {listed['title']}", "", f"[Its page](../papers/{paper}.md)", ""]
        for name, table in listed.get("tables", {}).items():
            if table.get("statements") == "findings.yaml":
                statements = yaml.safe_load(file.with_name("findings.yaml").read_text("utf-8"))
                lines += _findings(statements, results / "tables" / f"{name}.csv")
        for name, one in listed.get("figures", {}).items():
            picture = _picture(name, one["alt"], results / "figures" / f"{name}.png", "../..")
            lines += ["", f"*{one['title']}.*", "", *picture]
        lines.append("")
    return "\n".join(lines)


def _findings(statements: list[dict[str, Any]], table: Path) -> list[str]:
    """Findings with what they are judged by, and with their values if these were computed."""
    rows = pd.read_csv(table).set_index("quantity").T if table.exists() else {}
    lines = ["| finding | value | holds if | second method |", "|---|---|---|---|"]
    for one in statements:
        name = one["quantity"]
        value = _with_error(rows[name]) if name in rows else "on demand"
        cells = name, value, one.get("criterion", "not judged"), one.get("check", "–")
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def _with_error(row: pd.Series) -> str:
    """A value to the digit of its error, and the error."""
    value, error = float(row["computed"]), float(row["numerical error"])
    if not 0.0 < error < math.inf:
        return in_print(value, ".6g")
    digits = max(0, math.ceil(-math.log10(error)))
    return f"{in_print(value, f'.{digits}f')} ± {in_print(error, '.0e')}"


def _tables(results: Path, names: list[str]) -> str:
    """Some tables with their titles and captions, as a page."""
    described = _read_yaml("tables.yaml")
    lines: list[str] = []
    for name in names:
        rows = (results / "tables" / f"{name}.md").read_text(encoding="utf-8").strip()
        rows = "\n".join(_kept_columns(rows.splitlines()))
        heading = "##" if lines else "#"
        lines += [f"{heading} {described[name]['title']}", "", described[name]["caption"], "", rows]
    return "\n".join(lines) + "\n"


LEFT_OUT = ("paper_place", "remark", "scene")
"""Columns of the tables of statements that no page is wide enough for; they stand in the report."""


def _kept_columns(rows: list[str]) -> list[str]:
    """Rows of a Markdown table without the columns that are left out."""
    cells = [row.strip("|").split("|") for row in rows]
    kept = [i for i, head in enumerate(cells[0]) if head.strip() not in LEFT_OUT]
    return [f"|{'|'.join(row[i] for i in kept)}|" for row in cells]
