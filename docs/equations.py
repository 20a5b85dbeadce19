"""Write equations.md: which modules hold each equation of the paper, from their docstrings.

A docstring names an equation by its number in parentheses, as in "eq. (31)", "eqs. (24)-(32)" or
"obeys (57)"; numbers inside formulas do not count.  An equation is written out in the docstring of
a module of the folders that its section belongs to; elsewhere it is used.

python docs/equations.py
"""

import ast
import re
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "granular_fronts"
PAGE = Path(__file__).with_suffix(".md")

SECTIONS = (
    ("1 Introduction", ("model",), range(1, 3)),
    ("2 Fronts in dissipative lattices", ("model", "chain"), range(3, 24)),
    ("3.1 Granular chains: model and scaling", ("model", "chain"), range(24, 31)),
    ("3.2 Choice of variables", ("chain", "studies"), range(31, 35)),
    ("4 The logarithmic Burgers equation", ("continuum", "model"), range(35, 52)),
    ("5 The logarithmic KdV–Burgers equation", ("continuum",), range(52, 60)),
)
"""Title, the folders in which the equations of a section are written out, and their numbers."""

MEANINGS = {
    1: "Newton's law of a chain with contact forces F",
    2: "contact force, elastic with exponent α and viscous with exponent β",
    3: "contact force from an elastic potential V and a dissipation potential W",
    4: "generalised Hertz potentials",
    5: "the lattice, in condensed form",
    6: "local balance of energy",
    7: r"travelling wave, $x_n(t) = X(n - ct)$",
    8: "advance–delay equation, integrated once",
    9: "balance of energy of a travelling wave",
    10: r"states of a front, $X' \to R_\pm$ far away",
    11: "limits of the differences of $X$",
    12: r"velocities far away, $-cR_\pm$",
    13: "speed from the jump of the force",
    14: r"speed and direction, $c = \sigma|c|$",
    15: "balance of energy, integrated over a front",
    16: "dissipation is positive",
    17: "direction σ, the sign of the area between force and chord",
    18: "condition for a front: the area does not vanish",
    19: "that area as an integral",
    20: "conservative lattice: the area vanishes",
    21: "front of generalised Hertz contacts: speed from compression",
    22: "the same: velocity of the beads from compression",
    23: "the same: speed from velocity",
    24: "the dissipative granular chain of $N$ beads",
    25: "pressure at the ends",
    26: "ring of beads",
    27: "units of time and length",
    28: "the dimensionless chain",
    29: "dimensionless damping γ",
    30: r"γ in units of a front, $\gamma_0 c$",
    31: "generalised velocity w",
    32: "its equation of motion",
    33: "velocities behind a front",
    34: "w and velocity agree far behind a front",
    35: r"generalised Kuwabara–Kono chain, $\beta = \alpha$",
    36: "its relative displacements",
    37: r"slowly varying waves, $u = \delta\,y^{1/\alpha}$",
    38: "orders kept in the expansion",
    39: "the expansion, integrated once",
    40: r"amplitude equation at α above 1, with the flux $f_\alpha$",
    41: "logarithmic Burgers equation",
    42: "acceleration of the beads in slow variables",
    43: "velocity of the beads to first order",
    44: "the same on a stationary front",
    45: "front of the logarithmic Burgers equation",
    46: "front at α above 1, with a compact foot",
    47: "u of the front (45)",
    48: "velocity on the front (45)",
    49: "plateau as initial condition on a ring",
    50: "logarithmic Burgers equation in the moving frame",
    51: "chain variables from its solution",
    52: "slowly varying waves with dispersion",
    53: "the expansion",
    54: "damping parameter μ",
    55: "logarithmic KdV–Burgers equation",
    56: "stationary waves: a particle in a double well, with negative damping",
    57: "the planar system",
    58: "$q = z^2$ along an orbit",
    59: "the same, continued through $q = 0$",
}

PREAMBLE = (
    "This index is made from the docstrings of the package by `python docs/equations.py`. Paths",
    "are below `src/granular_fronts`. **Bold** modules write the equation out, the others use it.",
    "The pages of sections [2](theory/fronts_in_lattices.md), [3](theory/granular_chains.md),",
    "[4](theory/logarithmic_burgers.md) and [5](theory/logarithmic_kdv_burgers.md) show most of",
    "them with their formulas. Our copy of the paper has no section 6: see [exact",
    "fronts](theory/exact_fronts.md).",
)

BAR = r"\|"
"""A bar inside a cell of a table."""

REFERENCE = re.compile(r"(?<![\w)\]'’′])\((\d{1,2})\)(?:\s*[-–]\s*\((\d{1,2})\))?")
FORMULA = re.compile(r":math:`[^`]*`|^( *)\.\. math::.*\n(?:\1 +.*\n|\n)*", re.MULTILINE)


def _numbers(docstring):
    """Equations that a docstring names, ranges included."""
    for first, last in REFERENCE.findall(FORMULA.sub(" ", docstring + "\n")):
        yield from range(int(first), int(last or first) + 1)


def _docstrings(path):
    """Strings that stand alone in a module: those of the module, functions, classes, constants."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        match node:
            case ast.Expr(value=ast.Constant(value=str(text))):
                yield text


def find_equations(package=PACKAGE):
    """Modules that write out each equation, and those that use it, as paths below the package."""
    folders_of = {number: folders for _, folders, section in SECTIONS for number in section}
    written, used = defaultdict(list), defaultdict(list)
    for path in sorted(package.rglob("*.py")):
        name = path.relative_to(package)
        heading, *others = [set(_numbers(text)) for text in _docstrings(path)] or [set()]
        for number in sorted(heading.union(*others) & MEANINGS.keys()):
            at_home = name.parts[0] in folders_of[number] and number in heading
            (written if at_home else used)[number].append(name.as_posix())
    return written, used


def make_page(written, used):
    """The index as Markdown."""
    lines = ["# Equations of the paper and their modules", "", *PREAMBLE]
    for title, _, section in SECTIONS:
        lines += ["", f"## {title}", "", "| equation | what it says | modules |", "|---|---|---|"]
        for number in section:
            modules = _modules_in_words(written[number], used[number])
            row = f'<a id="eq-{number}"></a>({number})', MEANINGS[number], modules
            lines.append(f"| {' | '.join(cell.replace('|', BAR) for cell in row)} |")
    return "\n".join(lines) + "\n"


def _modules_in_words(written, used):
    """Links to modules, those that write an equation out first."""
    links = [f"**{_link(name)}**" for name in written] + [_link(name) for name in used]
    return ", ".join(links) or "a step of the derivation, not used"


def _link(name):
    """A module as a link from the page."""
    return f"[{name}](../src/granular_fronts/{name})"


if __name__ == "__main__":
    PAGE.write_text(make_page(*find_equations()), encoding="utf-8")
