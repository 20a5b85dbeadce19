"""Links of the manual: where "figure 2", "(41)", "Lemma 9" and "James (2021)" are shown."""

import re
from pathlib import Path

from equations import MEANINGS, REFERENCE
from generate import FIGURES, ROOT

TEXTS = {path: path.read_text("utf-8") for path in ROOT.glob("src/granular_fronts/proofs/**/*.py")}
PROVED = {  # "Lemma 9": the file and the line of its statement, or the page
    found[1]: f"sources/{path.relative_to(ROOT)}.html#L-{text.count(chr(10), 0, found.start()) + 1}"
    for path, text in TEXTS.items()
    for found in re.finditer(r"\*\*((?:Lemma|Theorem) \d+)", text)
} | {f"Theorem {letter}": "proofs.html#the-theorems" for letter in "ABC"}
PAPERS = {  # "James (2021)": its place in the bibliography
    found[2]: f"bibliography.html#{found[1]}"
    for found in re.finditer(
        r'<a id="([\w-]+)"></a>\*\*(.+? \(\d{4}\))\*\*',
        Path(__file__).with_name("bibliography.md").read_text("utf-8"),
    )
}
FIGURE_PLACES = {
    f"Figure {name[4]}": f"generated/figures.html#{name}" for name in FIGURES if name[:4] == "fig0"
}
EQUATIONS = {f"({number})": f"equations.html#eq-{number}" for number in MEANINGS}
PLACES = PROVED | PAPERS | FIGURE_PLACES | EQUATIONS

NAMED = re.compile(
    "|".join(
        [
            r"\b(?P<kind>[Ff]igure|Lemma|Theorem)s?\s(?P<number>\d+b?|[ABC])\b",
            r"(?:,| and| to|–)\s?(?P<next>\d+b?)\b",
            REFERENCE.pattern,
            *map(re.escape, PAPERS),
        ]
    )
)


def links_in(text):
    """Start, end and place of each part of a text that names something of the manual."""
    end, kind = -1, ""
    for found in NAMED.finditer(text):
        start = found.start()
        if found["next"]:  # figures 2 and 3
            if start != end:
                continue
            start = found.start("next")
        elif found["kind"]:
            kind = found["kind"].capitalize()
        end, number = found.end(), found["number"] or found["next"]
        name = f"{kind} {number}" if number else found[0]
        if name in PLACES:
            yield start, end, PLACES[name]
        elif name[0] == "(":  # (24)-(32)
            for one in re.compile(r"\(\d+\)").finditer(text, start, end):
                if one[0] in PLACES:
                    yield *one.span(), PLACES[one[0]]
