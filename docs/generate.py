"""Pages of the manual that follow from the code and from the results of a finished run.

The manual's build writes them into docs/generated, so that no name, range or number is typed twice.
"""

import inspect
import re
import sys
from pathlib import Path
from typing import Any, NamedTuple

from configuration import campaign_page, configuration_page

import granular_fronts
from granular_fronts.output.datasets import long_names

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT / "workflow" / "lib"))

from captions import read_texts  # noqa: E402

CAPTIONS = {
    file.stem: read_texts(file)
    for folder in ("workflow/captions", *sorted(ROOT.glob("projects/*/captions")))
    for file in sorted((ROOT / folder).glob("*.rst"))
}
TABLES = {name.removeprefix("table_"): CAPTIONS[name] for name in CAPTIONS if "table_" in name}
FIGURES = {name: CAPTIONS[name] for name in CAPTIONS if "table_" not in name}
"""Texts of all tables and figures by the names of their files."""


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
        **project_pages(),
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
    Group(
        "fronts",
        "Fronts",
        "Solve a front of the lattice, its tail and its stability.",
        "exact_fronts",
    ),
    Group("equations", "Amplitude equations", "Solve the long-wave equations of the chain.", "8"),
    Group(
        "laws",
        "Laws and scaling",
        "Choose a contact law, and convert real beads.",
        "jump_conditions",
    ),
    Group("proofs", "Proofs", "Prove that a front exists, and check a proof.", "critical_damping"),
    Group("plots", "Plots", "Draw a dataset in one line.", "multipliers"),
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
        lines += ["", f"({name})=", "", f"## {_title(name)}", "", *_picture(name, results, "../..")]
        caption = (results / "figures" / name).with_suffix(".rst")
        if caption.exists():
            # Captions are reStructuredText.
            lines += ["", "```{eval-rst}", caption.read_text(encoding="utf-8").strip(), "```"]
    return "\n".join(lines) + "\n"


def target_of(name: str) -> str:
    """The target that draws a figure: fig01 of fig01_initiation_underdamped."""
    return name.partition("_")[0] if name.startswith("fig0") else name


def _title(name: str) -> str:
    """Number and title of a figure of the paper, title of another."""
    number = re.match(r"fig0(\d)_", name)
    return f"Figure {number[1]}. {FIGURES[name].title}" if number else FIGURES[name].title


def _picture(name: str, results: Path, up: str) -> list[str]:
    """A figure as Markdown, or the command that draws it where it was not asked for."""
    if not (results / "figures" / f"{name}.png").exists():
        return [f"This figure is drawn on demand, by `snakemake -c2 {target_of(name)}`."]
    return [f"![{FIGURES[name].comment}]({up}/results/figures/{name}.png)"]


PICTURE = re.compile(r"<!-- figure (?P<target>\w+) -->")
"""Where a page shows a figure of the run."""


def fill_pictures(text: str, page: str, results: Path) -> str:
    """A page with the figures of a run where it asks for them.

    Parameters
    ----------
    text : str
        The page; ``<!-- figure 1 -->`` or ``<!-- figure critical_damping -->`` in a line of its own
        asks for a figure.
    page : str
        Its path below docs, from which the paths of pictures follow.
    results : Path

    Returns
    -------
    str
    """

    def fill(found: re.Match[str]) -> str:
        target = f"fig0{found['target']}" if found["target"].isdigit() else found["target"]
        [name] = [name for name in FIGURES if target_of(name) == target]
        title = f"*{_title(name)}.*"
        picture = _picture(name, results, "../" * page.count("/") + "..")
        return "\n".join([*picture, "", title] if "![" in picture[0] else [f"{title} {picture[0]}"])

    return PICTURE.sub(fill, text)


def project_pages() -> dict[str, str]:
    """The page of each project, whose links stand as deep in the repository as they will."""
    return {
        f"project_{page.parent.name}": page.read_text(encoding="utf-8")
        for page in sorted(ROOT.glob("projects/*/README.md"))
    }


def _tables(results: Path, names: list[str]) -> str:
    """Some tables with their titles and captions, as a page."""
    lines: list[str] = []
    for name in names:
        rows = (results / "tables" / f"{name}.md").read_text(encoding="utf-8").strip()
        rows = "\n".join(_kept_columns(rows.splitlines()))
        heading = "##" if lines else "#"
        lines += [f"{heading} {TABLES[name].title}", "", TABLES[name].caption, "", rows]
    return "\n".join(lines) + "\n"


LEFT_OUT = ("paper_place", "remark", "scene")
"""Columns of the tables of statements that no page is wide enough for; they stand in the report."""


def _kept_columns(rows: list[str]) -> list[str]:
    """Rows of a Markdown table without the columns that are left out."""
    cells = [row.strip("|").split("|") for row in rows]
    kept = [i for i, head in enumerate(cells[0]) if head.strip() not in LEFT_OUT]
    return [f"|{'|'.join(row[i] for i in kept)}|" for row in cells]
