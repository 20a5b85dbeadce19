r"""The note on proofs as LaTeX: `make note` runs python docs/note.py FOLDER, and latexmk there.

`note.tex` has the words between the lemmas.  The lemmas are the docstrings of
`granular_fronts.proofs`: where `note.tex` says ``\docstring{families}``, the docstring of that
module is set as a section.  Theorems and results are those of the manual's page on proofs, by
``\page{The theorems}``, and so is the bibliography.  Bounds are those of certificates, checked now.

Docstrings write formulas as plain text: |f|_w = sup |f| e^(−wt).  A word of at least two letters is
text, unless it is a function such as sup.  All else is a formula, except the article a.
"""

import re
import sys
from collections.abc import Iterable, Iterator
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from fractions import Fraction
from importlib import import_module
from itertools import groupby, takewhile
from pathlib import Path
from typing import Any
from unicodedata import normalize

from links import PAPERS, ROOT

from granular_fronts.proofs.arrays import written
from granular_fronts.proofs.balls import NotProvedError
from granular_fronts.proofs.checker import check_certificate

TEMPLATE = Path(__file__).with_suffix(".tex")
PAGE = Path(__file__).with_name("proofs.md")
BIBLIOGRAPHY = Path(__file__).with_name("bibliography.md")
CERTIFICATES = (
    *("monotone", "critical", "overshoot", "steep"),
    *("quadratic", "dashpots"),
    *("critical_damping/0.260000", "critical_damping/0.262000", "critical_damping/0.263400"),
)
FOLDERS = ROOT / "tests/proofs/test_proof_data", ROOT / "docs/certificates"

TO_SYMBOL = dict(
    re.findall(
        r"(\S)\s(\S+)",
        r"""α \alpha β \beta γ \gamma δ \delta ε \varepsilon ζ \zeta η \eta θ \theta κ \kappa
        λ \lambda μ \mu ν \nu ξ \xi π \pi ρ \rho σ \sigma τ \tau φ \varphi χ \chi ω \omega
        Γ \Gamma Δ \Delta Λ \Lambda Σ \sum Φ \Phi ∂ \partial ∫ \int ∞ \infty ∈ \in ≤ \le ≥ \ge
        → \to ↦ \mapsto ⊂ \subset ⊕ \oplus × \times ± \pm − - % \% ‖ \| · \cdot … \dots
        ℝ \mathbb{R} ℂ \mathbb{C} ℓ \ell ~ \sim""",
    )
)
ACCENTS = {"\u0304": "bar", "\u0302": "hat", "\u0303": "tilde", "\u0307": "dot"}
SMALL = {"^": ("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-"), "_": ("₀₁₂₃₄₅₆₇₈₉₊₋", "0123456789+-")}
FUNCTIONS = {*re.findall(r"\w+", "sup inf max min ln exp cos sin cosh sinh coth arg lim ker dim")}
OPERATORS = {*re.findall(r"\w+", "sgn sinc ess Re Im Ran ind codim span gain")}

INSIDE = r"(?:[^()]|\((?:[^()]|\([^()]*\))*\))*"
WORD = re.compile(r"(?!d[stq]$)[A-Za-zéó]{2,}(?:'s)?(?:[-–][A-Za-z]+)*|a")
EDGES = "()[].,;:“”"
SPAN = re.compile(
    r"``(?P<literal>[^`]+)``|`(?P<code>[^`]+)`|\$(?P<formula>[^$]+)\$"
    r"|(?<!\S)\*(?P<stressed>[A-Za-z]+)\*"
    r"|\[(?P<linked>[^\]]+)\]\([^)]*\)|(?P<named>(?:Lemma|Theorem)s? (?:\d+|[ABC]\b))"
    r"|(?P<article>(?:^|(?<=[.:] ))A(?= [a-z])(?! is | differs ))|"
    rf"(?P<paper>{'|'.join(map(re.escape, PAPERS))})"
)
HEAD = re.compile(r"\*\*(?:(Lemma|Theorem) (\w+)(?: \((.*?)\))?|(.*?))\.\*\* ", re.DOTALL)


def formula(text: str) -> str:
    """A formula in plain text, such as ``|f|_w = sup |f| e^(−wt)``, as LaTeX."""
    text = normalize("NFD", text).replace("=\u0338", r"\ne ").replace("γ_x", "γ_×")
    for mark, accent in ACCENTS.items():
        text = re.sub(rf"(\w){mark}", rf"\\{accent}{{\1}}", text)
    for place, (signs, plain) in SMALL.items():
        text = re.sub(f"[{signs}]+", rf"{place}{{\g<0>}}", text)
        text = text.translate(str.maketrans(signs, plain))
    text = re.sub(rf"([\^_])\(({INSIDE})\)", r"\1{\2}", text)
    text = re.sub(r"_([A-Za-z]+|\w)", r"_{\1}", text)
    text = re.sub(r"\^([^\W_]|∞)(_\{\w\})?", r"^{\1\2}", text)
    # A star is a convolution, except behind a solution, a root of one, or L at one.
    text = re.sub(r"(?<=[yPuLα])\*('?)", lambda m: r"^{*\prime}" if m[1] else "^{*}", text)
    text = re.sub(r"\b(?:1|([\d.]+))e-0?(\d+)", _power, re.sub(r"(?<=\w)±", "_±", text))
    text = re.sub(r"\|(?=Re|Im|ind)", r"\\lvert ", text)
    text = re.sub(r" (?=d[stqη]\b)", r"\\,", text)
    text = re.sub(r"(?<![\\A-Za-z])[A-Za-z]{2,}", _name, text)
    return "".join(f"{TO_SYMBOL[sign]} " if sign in TO_SYMBOL else sign for sign in text).strip()


def _name(found: re.Match[str]) -> str:
    """A name in a formula; two letters are a product."""
    name = found[0]
    if name in FUNCTIONS:
        return f"\\{name} "
    return rf"\operatorname{{{name}}}" if name in OPERATORS or len(name) > 2 else name


def _power(found: re.Match[str]) -> str:
    """A number with an exponent."""
    return (rf"{found[1]}\cdot " if found[1] else "") + f"10^{{-{found[2]}}}"


def prose(text: str, module: str = "") -> str:
    """A paragraph as LaTeX; names of modules are looked for beside that which it is from."""
    text, found, end = " ".join(text.split()), [], 0
    for span in SPAN.finditer(text):
        found += [_in_line(text[end : span.start()]), _span(span, module)]
        end = span.end()
    return "".join([*found, _in_line(text[end:])])


def _span(span: re.Match[str], module: str) -> str:
    """What is no plain text."""
    kind, words = span.lastgroup, span[span.lastgroup or 0]
    if kind in ("code", "literal"):
        return _code(words, module) if kind == "code" else rf"\texttt{{{_escaped(words)}}}"
    if kind == "named":
        return rf"\hyperref[{words.replace('s ', ' ')}]{{{words.replace(' ', '~')}}}"
    if kind == "paper":
        return rf"\hyperlink{{{words}}}{{{words}}}"
    if kind == "linked":
        return prose(words, module)
    return {"formula": f"${words}$", "stressed": rf"\emph{{{words}}}"}.get(kind or "", words)


def _code(name: str, module: str) -> str:
    """A module that is a section of the note, or another name of the code."""
    beside = f"{module.rpartition('.')[0]}.{name}".lstrip(".")
    for section in (beside, name.removeprefix("granular_fronts.proofs.")):
        if section in sections():
            return rf"Section~\ref{{{section}}}"
    return rf"\texttt{{{_escaped(name)}}}"


def _escaped(text: str) -> str:
    return re.sub(r"[_%&#]", r"\\\g<0>", text)


def _in_line(text: str) -> str:
    """Words and formulas."""
    runs = groupby(text.split(), _is_formula)
    found = " ".join(
        " ".join(_formulas(tokens)) if is_formula else _escaped(" ".join(tokens))
        for is_formula, tokens in runs
    )
    return " " * text[:1].isspace() + found + " " * text[1:][-1:].isspace()


def _is_formula(token: str) -> bool:
    word = token.strip(EDGES)
    if re.match(r"\([ab]\)", token):  # The number of an equation.
        return False
    return bool(word) and (word in FUNCTIONS | OPERATORS or not WORD.fullmatch(word))


def _formulas(tokens: Iterable[str]) -> Iterator[str]:
    """Formulas between commas, without brackets of the text around them."""
    run: list[str] = []
    for token in [*tokens, ""]:
        run += [token] if token else []
        text = " ".join(run)
        depth = sum(text.count(sign) for sign in "([{") - sum(text.count(sign) for sign in ")]}")
        if text and (not token or (token[-1] in ",;:." and depth <= 0)):
            inside = text.rstrip(".,;:")
            before, after = "", text[len(inside) :]
            if depth > 0 and inside.startswith("("):
                before, inside = "(", inside[1:]
            if depth < 0 and inside.endswith(")"):
                inside, after = inside[:-1], ")" + after
            yield f"{before}${formula(inside)}${after}"
            run = []


def display(block: str) -> str:
    """Lines of displayed formulas."""
    lines = (re.split(r"\s{3,}", line.strip()) for line in block.splitlines())
    rows = (r" \qquad ".join(map(_displayed, parts)) for parts in lines)
    return "\\begin{gather*}\n" + " \\\\\n".join(rows) + "\n\\end{gather*}"


def _displayed(text: str) -> str:
    if tag := re.fullmatch(r"\((\w)\)", text):
        return rf"\tag{{{tag[1]}}}"
    runs = groupby(text.split(), _is_formula)
    return "".join(
        formula(" ".join(tokens)) if is_formula else rf"\text{{ {' '.join(tokens)} }}"
        for is_formula, tokens in runs
    )


def body(text: str, module: str = "") -> Iterator[str]:
    """The blocks of a docstring or of a part of a page: lemmas, proofs, lists and paragraphs."""
    text = re.sub(r"\n(?=\*Proof|\*\*| \* |- )", "\n\n", text)
    text = re.sub(r"∎(?=\s*\S)", "∎\n\n", text)
    opened: list[str] = []

    def close(*kinds: str) -> Iterator[str]:
        while opened and (not kinds or opened[-1] in kinds):
            yield rf"\end{{{opened.pop()}}}"

    plain = False
    for block in filter(str.strip, re.split(r"\n\s*\n", text)):
        before, start, ended = plain, "", False
        plain = False
        if block.startswith("    "):
            yield display(block)
            continue
        if block.startswith("$$"):
            yield rf"\[{block.strip('$')}\]"
            continue
        if block.startswith(("|", "<")):
            continue
        if item := re.match(r" \* |- ", block):
            block, start = block[item.end() :], r"\item "
            if "itemize" not in opened:
                opened.append("itemize")
                yield r"\begin{itemize}"
        else:
            yield from close("itemize")
        if head := HEAD.match(block):
            yield from close()
            block = block[head.end() :].rstrip()
            if block[0] == "*":  # A page stresses the whole of a theorem.
                ended, block = block.endswith("*"), block.strip("*")
            kind, number, title, words = head.groups()
            if number:
                opened.append(kind.lower())
                yield rf"\begin{{{opened[-1]}}}{{{number}}}{{{prose(title or '')}}}"
            else:
                yield rf"\paragraph{{{prose(words)}.}}"
        elif block.startswith("*Proof.*"):
            yield from close()
            opened.append("proof")
            block = block.removeprefix("*Proof.*")
            yield r"\begin{proof}"
        else:
            plain = not start
            if plain and before:
                yield ""
        ended = ended or block.rstrip().endswith("∎")
        yield start + prose(block.rstrip().removesuffix("∎"), module)
        if ended:
            yield from close()
    yield from close()


def docstring(module: str) -> str:
    """The docstring of a module of proofs."""
    return import_module(f"granular_fronts.proofs.{module}".rstrip(".")).__doc__ or ""


def sections() -> list[str]:
    """The modules whose docstrings are sections of the note, in their order."""
    return re.findall(r"\\docstring\{([\w.]*)\}", TEMPLATE.read_text(encoding="utf-8"))


def section(module: str) -> str:
    """A docstring as a section; its first line is the title, with a sentence behind the colon."""
    first, _, rest = docstring(module).partition("\n\n")
    title, _, sentence = " ".join(first.split()).partition(": ")
    lines = [rf"\section{{{prose(title)}}}\label{{{module}}}"]
    lines += [prose(sentence[:1].upper() + sentence[1:], module), ""]
    return "\n".join([*lines, *body(rest, module)])


def page(title: str) -> str:
    """A part of the manual's page."""
    text = PAGE.read_text(encoding="utf-8")
    found = re.search(rf"^#+ {re.escape(title)}$(.*?)(?=^#|\Z)", text, re.MULTILINE | re.DOTALL)
    assert found, title
    return "\n".join(body(found[1]))


def records() -> list[dict[str, Any]]:
    """What the certificates of the project prove."""
    found = []
    for name in CERTIFICATES:
        [path] = (p for folder in FOLDERS if (p := folder / f"{name}.npz").exists())
        record = check_certificate(path)
        if not record["proved"]:
            raise NotProvedError(f"{path}: {record['reason']}")
        beta = "1" if "tail_start" in record["numbers"] else r"\alpha"
        found.append(record | {"name": path.stem, "beta": beta})
    return found


def rounded(number: float, rounding: str = ROUND_CEILING) -> str:
    """A number in LaTeX with three significant digits, rounded up by default."""
    decimal = Context(prec=3, rounding=rounding).create_decimal(number)
    return f"{decimal:f}" if decimal > 1e-4 else formula(f"{decimal:e}")


def bounds(record: dict[str, Any]) -> list[str]:
    """A row of the table of bounds: Y₀, Z₁, Z₂(r), r, sup |u − ū|, and W, which is from below."""
    left = {one["name"]: one["left"] for one in record["inequalities"]}
    Y0, Z1 = left["Y0 < (1 − Z1 − Z2(r)) r"], left["Z1 < 1"]
    numbers = record["numbers"]
    above = (Y0, Z1, left["Z1 + Z2(r) < 1"] - Z1, numbers["radius"], record["error"])
    parameters = (_interval(record[name]) for name in ("alpha", "gamma"))
    W = rounded(numbers["unique_within"], ROUND_FLOOR)
    row = [*parameters, record["beta"], *map(rounded, above), W]
    return [rf"\texttt{{{record['name']}}}", *(f"${cell}$" for cell in row)]


def _interval(ends: tuple[Fraction, Fraction]) -> str:
    low, high = map(written, ends)
    return low if low == high else f"[{low}, {high}]"


def page_rows(heading: str) -> list[list[str]]:
    """The cells of the table of the page whose first line begins so."""
    lines = PAGE.read_text(encoding="utf-8").partition(f"\n| {heading} ")[2].splitlines()
    rows = (line.strip("|").split("|") for line in takewhile(bool, lines[2:]) if line[0] == "|")
    return [[cell.strip() for cell in row] for row in rows]


def proved(row: list[str]) -> list[str]:
    """A row of the table of the last run."""
    name, alpha, beta, gamma, shape, error, count, *_ = row
    shape = prose(re.sub(r"gamma (\S+) to ([\d.]+)", r"γ ∈ [\1, \2]", shape))
    numbers = [alpha, beta, gamma.replace("to", r"\text{ to }"), formula(error), count]
    return [_escaped(name), *(f"${cell}$" for cell in numbers), shape]


def table(rows: Iterable[list[str]]) -> str:
    """Rows of a LaTeX table."""
    return " \\\\\n".join(map(" & ".join, rows)) + r" \\"


def bibliography(text: str) -> str:
    """The entries of the papers that a text cites."""
    entries = re.findall(
        r"^- <a id=\"[\w-]+\"></a>\*\*(.*?)\*\*: (.*?)(?=^- |^#|\Z)",
        BIBLIOGRAPHY.read_text(encoding="utf-8"),
        re.MULTILINE | re.DOTALL,
    )
    lines = []
    for name, entry in sorted((" ".join(name.split()), entry) for name, entry in entries):
        if rf"\hyperlink{{{name}}}" in text:
            entry = re.sub(r"\[(.*?)\]\((.*?)\)", r"\\href{\2}{\1}", " ".join(entry.split()))
            entry = re.sub(r"\*(.*?)\*", r"\\emph{\1}", entry)
            lines.append(rf"\item[\hypertarget{{{name}}}{{{name}}}] {entry}")
    return "\n".join(lines)


def note() -> str:
    """The whole note as LaTeX."""
    names = "|".join(r"\s+".join(map(re.escape, name.split())) for name in PAPERS)
    text = re.sub(
        rf"(?:Lemma|Theorem) (?:\d+|[ABC]\b)|{names}",
        lambda found: prose(found[0]),
        TEMPLATE.read_text(encoding="utf-8"),
    )
    made = {
        "bounds": lambda: table(map(bounds, records())),
        "crossings": lambda: table(
            [f"${cell}$" for cell in row] for row in page_rows(r"α | $\gamma_\times$,")
        ),
        "proved": lambda: table(map(proved, page_rows("front "))),
    }
    text = re.sub(r"\\docstring\{([\w.]*)\}", lambda found: section(found[1]), text)
    text = re.sub(r"\\page\{(.*?)\}", lambda found: page(found[1]), text)
    text = re.sub(r"\\rows\{(\w+)\}", lambda found: made[found[1]](), text)
    return text.replace(r"\papers", bibliography(text))


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "note.tex").write_text(note(), encoding="utf-8")
