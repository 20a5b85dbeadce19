"""Pages of the manual that follow from the code and from the results of a finished run.

The manual's build writes them into docs/generated, so that no name, range or number is typed twice.
"""

import inspect
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

import granular_fronts
from granular_fronts.output.datasets import long_names
from granular_fronts.scenes.schema import load_schema

ROOT = Path(__file__).parents[1]
WORKFLOW = ROOT / "workflow"


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
        "configuration": _configuration(load_schema("config")),
        "variables": _variables(),
        "figures": _figures(results),
        "paper_numbers": _tables(results, ["paper_numbers"]),
        "findings": _tables(results, ["findings"]),
        "tables": _tables(results, ["front_properties", "critical_damping", "jump_conditions"]),
    }
    for name, text in made.items():
        page = folder / f"{name}.md"
        # An unchanged page is not read again by the build.
        if not page.exists() or page.read_text(encoding="utf-8") != text:
            page.write_text(text, encoding="utf-8")


def _read_yaml(name: str) -> Any:
    """A YAML file of the workflow."""
    return yaml.safe_load((WORKFLOW / name).read_text(encoding="utf-8"))


def public_names() -> str:
    """Every public name with its docstring."""
    lines = ["# Python", "", "Names of `granular_fronts`, each imported when it is first used."]
    for name in granular_fronts.__all__:
        # Docstrings are reStructuredText.
        lines += ["", f"## {name}", "", "```{eval-rst}", *_directive(name), "```"]
    return "\n".join(lines) + "\n"


def _directive(name: str) -> list[str]:
    """What documents a public name: a function, or a class or a module with its members."""
    value = getattr(granular_fronts, name)
    if inspect.ismodule(value):
        return [f".. automodule:: {value.__name__}", "   :members:"]
    if inspect.isclass(value):
        return [f".. autoclass:: {value.__module__}.{name}", "   :members:"]
    return [f".. autofunction:: {value.__module__}.{name}"]


def _configuration(schema: Mapping[str, Any]) -> str:
    """Write a section for each key at the top of a JSON Schema, and an entry for each below it."""
    lines = ["# Configuration", "", schema["description"], ""]
    lines += ["A key in ⟨ ⟩ is a name of your choice; … stands for the entries of a list."]
    for key, part in schema["properties"].items():
        lines += ["", f"## {key}", "", part["description"]]
        # A key that several cases share is named once, by its first description.
        entries = {}
        for path, text in keys(part, schema):
            entries.setdefault(path, text)
        for path, text in entries.items():
            lines += ["", f"`{path}`", f": {text}"]
    return "\n".join(lines) + "\n"


def keys(
    part: Mapping[str, Any], schema: Mapping[str, Any], seen: tuple[str, ...] = (), path: str = ""
) -> Iterator[tuple[str, str]]:
    """The keys below a part of the schema, in its order.

    Parameters
    ----------
    part : mapping
        The part.
    schema : mapping
        The whole, in which `$ref` points.
    seen : tuple of str
        References that the part stands in; one that comes back is not followed again.
    path : str
        Keys of the part, joined by dots.

    Yields
    ------
    path, description : str
    """
    reference = part.get("$ref")
    if reference and reference not in seen:
        yield from keys(_pointed_at(reference, schema), schema, (*seen, reference), path)
    below = dict(part.get("properties", {}))
    if isinstance(part.get("additionalProperties"), dict):
        below["⟨name⟩"] = part["additionalProperties"]
    for key, value in below.items():
        longer = f"{path}.{key}".removeprefix(".")
        named = _pointed_at(value["$ref"], schema) if "$ref" in value else {}
        yield longer, {**named, **value}.get("description", "")
        yield from keys(value, schema, seen, longer)
    if "items" in part:
        yield from keys(part["items"], schema, seen, f"{path}.…")
    for choice in ("oneOf", "anyOf", "allOf"):
        for one in part.get(choice, []):
            yield from keys(one, schema, seen, path)
    # What stands below `if` only distinguishes the cases.
    for case in ("then", "else"):
        if case in part:
            yield from keys(part[case], schema, seen, path)


def _pointed_at(reference: str, schema: Mapping[str, Any]) -> Mapping[str, Any]:
    """The part of the schema that a JSON pointer such as ``#/$defs/bead`` names."""
    part = schema
    for key in reference.removeprefix("#/").split("/"):
        part = part[key]
    return part


VARIABLES = """# Variables

Names of variables and coordinates in the files below `results/data`, each with its attribute
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


def _figures(results: Path) -> str:
    """Every figure that was drawn, with the caption of what was computed."""
    lines = ["# Figures"]
    for provenance in sorted((results / "figures").glob("*.json")):
        texts = json.loads(provenance.read_text(encoding="utf-8"))
        caption = provenance.with_suffix(".rst").read_text(encoding="utf-8").strip()
        lines += ["", f"## {texts['title']}", ""]
        lines += [f"![{texts['alt']}](../../results/figures/{provenance.stem}.png)", ""]
        # Captions are reStructuredText.
        lines += ["```{eval-rst}", caption, "```"]
    return "\n".join(lines) + "\n"


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
