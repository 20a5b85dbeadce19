"""Draw architecture.svg: the way from a configuration to the report, and the package's folders.

The folders, what each is for and which imports which are read from the code: names of folders,
first words of docstrings, imports.  An arrow leads from a folder to one that it imports.  Where a
way over other folders leads there too, it is left out.

python docs/architecture.py
"""

import ast
import re
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path
from textwrap import wrap

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "src"))

from granular_fronts.numerics.imports import module_files, named_in  # noqa: E402

PACKAGE = ROOT / "src" / "granular_fronts"
PICTURE = Path(__file__).with_suffix(".svg")

FLOW = (
    ("configuration", "config/default.yaml"),
    ("rules", "workflow/rules"),
    ("scripts", "workflow/scripts"),
    ("datasets", "results/data"),
    ("scripts that draw", "workflow/scripts/figures"),
    ("figures and tables", "results/figures, results/tables"),
    ("report", "results/report.html"),
)
"""The way of the data, from above."""

CALLS, WRITES = 2, 3
"""Steps of the way that call the package and that it fills."""

WIDTH, TOP, FLOW_WIDTH = 785, 10, 200
FRAME = (245, 525)
"""Left edge and width of the frame around the package."""

LEVEL, BOX = 84, 54
"""Distance of two levels, and height of a box."""

LETTER = 6.4
"""Width of a letter of the second and third line of a box."""

STYLE = """
text { font-family: sans-serif; fill: #222; text-anchor: middle; }
.name { font-size: 14px; font-weight: bold; }
.what { font-size: 11px; fill: #555; }
rect { fill: #fff; stroke: #4477aa; rx: 5px; }
.page { stroke: none; rx: 0; }
.frame { fill: #f3f6fa; stroke: #bbccdd; }
path { fill: none; stroke: #4477aa; stroke-width: 1.3; marker-end: url(#head); }
#head path { fill: #4477aa; stroke: none; marker-end: none; }
"""

Imports = Mapping[str, set[str]]


def read_packages(package: Path = PACKAGE) -> dict[str, set[str]]:
    """Imports of the package, and those that each imports."""
    files = module_files(package.parent)
    imports: dict[str, set[str]] = defaultdict(set)
    for name, file in sorted(files.items()):
        if "." in name:
            found = {other for other in named_in(file) if other in files and "." in other}
            imports[_folder_of(name)] |= {_folder_of(other) for other in found} - {_folder_of(name)}
    return dict(imports)


def _folder_of(name: str) -> str:
    """The folder of a module."""
    return name.split(".")[1]


def _purpose(folder: str) -> str:
    """First words of the docstring of a folder."""
    place = PACKAGE / folder
    file = place / "__init__.py" if place.is_dir() else place.with_suffix(".py")
    text = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or ""
    return re.split(r"[:,.(]", text)[0].strip()


def _reached(folder: str, imports: Imports) -> set[str]:
    """All folders that a folder stands on."""
    return imports[folder].union(*(_reached(other, imports) for other in imports[folder]))


def _without_detours(imports: Imports) -> dict[str, set[str]]:
    """Imports that no other way leads along."""
    return {
        folder: found - set().union(*(_reached(other, imports) for other in found))
        for folder, found in imports.items()
    }


def _levels(imports: Imports) -> list[list[str]]:
    """Imports by level, from above: each stands on what it imports; what imports nothing hangs."""

    def height(folder):
        return 1 + max(map(height, imports[folder]), default=-1)

    heights = {folder: height(folder) for folder in imports}
    for folder, found in imports.items():
        if not found:
            heights[folder] = min(heights[name] for name in imports if folder in imports[name]) - 1
    rows = range(max(heights.values()), -1, -1)
    return [[folder for folder in imports if heights[folder] == row] for row in rows]


def _places(imports: Imports) -> dict[str, tuple[float, float, float]]:
    """Middle of each folder's box and its width; a folder stands near those that import it."""
    found: dict[str, tuple[float, float, float]] = {}
    left, width = FRAME
    for row, folders in enumerate(_levels(imports)):

        def wanted(folder):
            above = [found[name][0] for name in found if folder in imports[name]]
            return sum(above) / len(above) if above else left + width

        for place, folder in enumerate(sorted(folders, key=wanted)):
            share = width / len(folders)
            middle = left + (place + 0.5) * share
            found[folder] = middle, TOP + 40 + row * LEVEL, min(250, share - 8)
    return found


def _box(x: float, y: float, width: float, name: str, what: str) -> Iterator[str]:
    """A box around its middle, with a name and up to two lines of what it is."""
    yield f'<rect x="{x - width / 2:.0f}" y="{y:.0f}" width="{width:.0f}" height="{BOX}"/>'
    yield f'<text class="name" x="{x:.0f}" y="{y + 19:.0f}">{escape(name)}</text>'
    for row, line in enumerate(wrap(what, int(width / LETTER))):
        yield f'<text class="what" x="{x:.0f}" y="{y + 34 + 13 * row:.0f}">{escape(line)}</text>'


def _arrow(x0: float, y0: float, x1: float, y1: float) -> str:
    """An arrow that begins and ends upright."""
    bend = 0.5 * (y1 - y0)
    points = f"{x0:.0f},{y0 + bend:.0f} {x1:.0f},{y1 - bend:.0f} {x1:.0f},{y1:.0f}"
    return f'<path d="M{x0:.0f},{y0:.0f} C{points}"/>'


def _draw_wings(imports: Imports) -> Iterator[str]:
    """Boxes of the folders, and arrows to what they import."""
    at = _places(imports)
    for folder, found in imports.items():
        x, y, _ = at[folder]
        for other in sorted(found):
            yield _arrow(x, y + BOX, at[other][0], at[other][1] - 6)
    for folder, (x, y, width) in at.items():
        yield from _box(x, y, width, folder, _purpose(folder))


def _draw_flow(height: float) -> Iterator[str]:
    """The way of the data beside the package, over a height."""
    middle, step = TOP + FLOW_WIDTH / 2, (height - BOX) / (len(FLOW) - 1)
    rows = [TOP + step * row for row in range(len(FLOW))]
    for (name, where), y in zip(FLOW, rows, strict=True):
        yield from _box(middle, y, FLOW_WIDTH, name, where)
        if y != rows[-1]:
            yield _arrow(middle, y + BOX, middle, y + step - 6)
    edge, frame = TOP + FLOW_WIDTH, FRAME[0] - 10
    for row, (start, end) in ((CALLS, (edge, frame - 6)), (WRITES, (frame, edge + 6))):
        yield f'<path d="M{start},{rows[row] + BOX / 2:.0f} H{end}"/>'


def draw(imports: Imports) -> str:
    """The whole picture."""
    height = 40 + (len(_levels(imports)) - 1) * LEVEL + BOX + 16
    left, width = FRAME
    text = "Data flow from the configuration down to the report; scripts call the package, whose "
    text += f"folders stand on each other: {', '.join(imports)}."
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height + 2 * TOP:.0f}">',
        f"<title>Architecture</title><desc>{text}</desc>",
        f"<style>{STYLE}</style>",
        '<defs><marker id="head" viewBox="0 0 10 10" refX="4" refY="5" markerWidth="6" '
        'markerHeight="6" orient="auto"><path d="M0,0 L10,5 L0,10 z"/></marker></defs>',
        '<rect class="page" width="100%" height="100%"/>',
        f'<rect class="frame" x="{left - 10}" y="{TOP}" width="{width + 20}" height="{height}"/>',
        f'<text class="name" x="{left + width / 2:.0f}" y="{TOP + 22}">src/granular_fronts</text>',
        *_draw_flow(height),
        *_draw_wings(_without_detours(imports)),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PICTURE.write_text(draw(read_packages()), encoding="utf-8")
