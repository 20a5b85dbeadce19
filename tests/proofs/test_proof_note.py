"""The note on proofs: each lemma once and in order, bounds of certificates, and what LaTeX says."""

import re
import shutil
import subprocess
from decimal import Decimal

import pytest
from certificates import proved
from pages import load_script
from projects import ROOT

NOTE = load_script("note")
LATEX = shutil.which("latexmk") and shutil.which("pdflatex")
HEADS = re.compile(r"\*\*(?:Lemma|Theorem) (\d+)\b")


@pytest.fixture(scope="module")
def text():
    """The note with the bounds of one certificate."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(NOTE, "CERTIFICATES", ("monotone",))
        return NOTE.note()


def test_every_lemma_of_the_docstrings_is_in_the_note_once_and_in_order(text):
    found = re.findall(r"\\begin\{(lemma|theorem)\}\{(\w+)\}", text)
    numbers = [number for _, number in found]
    assert numbers[:5] == [*"ABCDE"]
    assert numbers[5:] == [str(k) for k in range(1, len(numbers) - 4)]
    sources = sorted((ROOT / "src/granular_fronts/proofs").rglob("*.py"))
    written = [n for path in sources for n in HEADS.findall(path.read_text(encoding="utf-8"))]
    assert sorted(written, key=int) == numbers[5:]
    assert text.count(r"\begin{proof}") == text.count(r"\end{proof}") == len(numbers) - 5
    named = set(re.findall(r"\\hyperref\[(.*?)\]", text))
    assert named <= {f"{kind.capitalize()} {number}" for kind, number in found}


def test_all_signs_of_formulas_are_known(text):
    assert {sign for sign in text if not sign.isascii()} <= {*"–éó"}
    assert not re.search(r"\$\s*\$|\\operatorname\{(?:the|and|of|is|for)\}", text)


@pytest.mark.parametrize(
    ("plain", "latex"),
    [
        ("|f|_w = sup |f| e^(−wt)", r"|f|_{w} = \sup |f| e^{-wt}"),
        ("u*' − ū'", r"u^{*\prime}-\bar{u}'"),
        ("K*P, L*A", r"K*P, L^{*}A"),
        ("∫_(t−1)^0 z", r"\int_{t-1}^{0} z"),
        ("e^ν₁ + rest_i 1_{i ≥ n}", r"e^{\nu_{1}} + \operatorname{rest}_{i} 1_{i\ge n}"),
        ("e^((v − ε)s)", r"e^{(v-\varepsilon)s}"),
        ("2.5e-07", r"2.5\cdot 10^{-7}"),
        ("u_{i−n} ≠ g₀", r"u_{i-n}\ne g_{0}"),
    ],
)
def test_formulas_are_set_as_they_are_meant(plain, latex):
    found, meant = ("".join(text.split()) for text in (NOTE.formula(plain), latex))
    assert found == meant


def test_words_and_formulas_are_told_apart():
    found = NOTE.prose(
        "Let a cell (of width h), f(x, y) and K*P be as in `balls`; by Lemma 3, P = 1"
    )
    assert found == (
        r"Let a cell (of width $h$), $f(x, y)$ and $K*P$ be as in Section~\ref{balls}; by"
        r" \hyperref[Lemma 3]{Lemma~3}, $P = 1$"
    )


def test_numbers_of_the_tables_are_rounded_bounds_of_certificates():
    record = proved("monotone") | {"name": "monotone", "beta": "α"}
    numbers, sides = record["numbers"], {one["name"]: one for one in record["inequalities"]}
    Z1, both = sides["Z1 < 1"]["left"], sides["Z1 + Z2(r) < 1"]["left"]
    exact = [sides["Y0 < (1 − Z1 − Z2(r)) r"]["left"], Z1, both - Z1]
    exact += [numbers["radius"], record["error"], numbers["unique_within"]]
    cells = [cell.strip("$").replace(r"\cdot 10^{", "e") for cell in NOTE.bounds(record)]
    cells = [cell.rstrip("}") for cell in cells]
    assert cells[1:4] == ["1.5", "0.3", "α"]
    shown = [Decimal(cell) / Decimal(number) for cell, number in zip(cells[4:], exact, strict=True)]
    assert all(1 <= ratio < Decimal("1.01") for ratio in shown[:-1])
    assert Decimal("0.99") < shown[-1] <= 1
    template = NOTE.TEMPLATE.read_text(encoding="utf-8")
    rows = re.findall(r"\\midrule\s*(.*?)\s*\\bottomrule", template, re.DOTALL)
    assert rows == [rf"\rows{{{name}}}" for name in ("bounds", "crossings", "proved")]


def test_a_certificate_that_is_refused_makes_no_note(monkeypatch):
    monkeypatch.setattr(NOTE, "CERTIFICATES", ("monotone",))
    refused = {"proved": False, "reason": "Z1 < 1"}
    monkeypatch.setattr(NOTE, "check_certificate", lambda path: refused)
    with pytest.raises(NOTE.NotProvedError, match=r"monotone\.npz: Z1 < 1"):
        NOTE.records()


@pytest.mark.slow
@pytest.mark.skipif(not LATEX, reason="there is no LaTeX with latexmk to set the note")
def test_latex_sets_the_note(tmp_path):
    (tmp_path / "note.tex").write_text(NOTE.note(), encoding="utf-8")
    command = ["latexmk", "-pdf", "-interaction=nonstopmode", "-halt-on-error", "note.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    log = (tmp_path / "note.log").read_text(encoding="latin-1")
    [pages] = re.findall(r"Output written on note\.pdf \((\d+) pages", log)
    assert 20 <= int(pages) <= 25
    assert "Warning: Reference" not in log
    assert "Hyper reference" not in log
    assert "Missing character" not in log
    assert not re.search(r"Overfull \\hbox \((?:[5-9]|\d\d)", log)
