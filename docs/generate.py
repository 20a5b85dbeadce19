"""Pages of the manual that follow from the code and from the results of a finished run.

The manual's build writes them into docs/generated, so that no name, range or number is typed twice.
"""

import inspect
import re
import shutil
import sys
from pathlib import Path
from typing import Any, NamedTuple

from configuration import campaign_page, configuration_page

import granular_fronts
from granular_fronts.output.datasets import long_names

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT / "workflow" / "lib"))

from captions import read_texts  # noqa: E402

PROJECTS = sorted(ROOT.glob("projects/*/README.md"))


def write_pages(folder: Path, results: Path) -> None:
    """Write every generated page.

    Parameters
    ----------
    folder : Path
        Where to; what is there goes.
    results : Path
        Results of a finished run of the workflow.

    Raises
    ------
    SystemExit
        If the workflow has not run: its report is missing.
    """
    if not (results / "report.html").exists():
        raise SystemExit(f"The manual shows results, and {results} has none: run make first.")
    # The page of a project that was deleted is not kept.
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    made = {
        "public_names": public_names(),
        **{f"api_{group.page}": group_page(group) for group in GROUPS},
        "configuration": configuration_page(),
        "campaigns": campaign_page(),
        "variables": _variables(),
        "tables": _tables(results),
        **pages_elsewhere(),
    }
    for name, text in made.items():
        (folder / f"{name}.md").write_text(text, encoding="utf-8")


class Group(NamedTuple):
    """Public names that belong together, shown on a page."""

    page: str
    title: str
    words: str


GROUPS = (
    Group("chains", "Chains", "Integrate the motion of a chain or of a ring of beads."),
    Group("fronts", "Fronts", "Solve a front of the lattice, its tail and its stability."),
    Group("equations", "Amplitude equations", "Solve the long-wave equations of the chain."),
    Group("laws", "Laws and scaling", "Choose a contact law, and convert real beads."),
    Group("proofs", "Proofs", "Prove that a front exists, and check a proof."),
    Group("plots", "Plots", "Draw a dataset in one line."),
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
    lines = [f"# {group.title}", "", group.words]
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
[symbols](../glossary.md#symbols).

| variable | what |
|---|---|
"""


def _variables() -> str:
    """Every variable of the result files, in words."""
    rows = [f"| `{name}` | {meaning} |" for name, meaning in sorted(long_names().items())]
    return VARIABLES + "\n".join(rows) + "\n"


def pages_elsewhere() -> dict[str, str]:
    """Pages of other folders; the links of a README stand as deep there as they will here."""
    places = [ROOT / "config/README.md", *PROJECTS]
    found = {f"readme_{page.parent.name}": page.read_text(encoding="utf-8") for page in places}
    for name in ("CONTRIBUTING", "CHANGELOG"):
        text = (ROOT / f"{name}.md").read_text(encoding="utf-8")
        found[name] = text.replace("](docs/", "](../").replace("](config/", "](../../config/")
    return found


TABLES = ("paper_numbers", "findings", "front_properties", "critical_damping", "jump_conditions")

LEFT_OUT = ("paper_place", "remark", "scene")
"""Columns of the tables of statements that no page is wide enough for; they stand in the report."""


def _tables(results: Path) -> str:
    """Tables of a run with their titles and captions, as a page."""
    lines = ["# Tables"]
    for name in TABLES:
        texts = read_texts(ROOT / "workflow" / "captions" / f"table_{name}.rst")
        rows = (results / "tables" / f"{name}.md").read_text(encoding="utf-8").strip()
        rows = "\n".join(_kept_columns(rows.splitlines()))
        lines += ["", f"## {texts.title}", "", texts.caption, "", rows]
    return "\n".join(lines) + "\n"


def _kept_columns(rows: list[str]) -> list[str]:
    """Rows of a Markdown table without the columns that are left out."""
    cells = [row.strip("|").split("|") for row in rows]
    kept = [i for i, head in enumerate(cells[0]) if head.strip() not in LEFT_OUT]
    return [f"|{'|'.join(row[i] for i in kept)}|" for row in cells]
