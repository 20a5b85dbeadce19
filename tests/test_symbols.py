"""The glossary: each symbol has one meaning, and none that files or pages use is missing."""

import re

import yaml
from projects import ROOT
from test_documents import DOCUMENTS
from test_schema import SCHEMA, schema_nodes

from granular_fronts.output.datasets import LONG_NAMES

PAGE = ROOT / "docs" / "symbols.md"
GREEK = ["alpha", "beta", "gamma", "delta", "epsilon", "eta"]
GREEK += ["theta", "lambda", "mu", "xi", "sigma", "tau"]


def rows(heading):
    """Cells of the table below a heading, its own head left out."""
    _, _, below = PAGE.read_text(encoding="utf-8").partition(f"{heading}\n")
    lines = re.findall(r"^\| (.*) \|$", below.partition("\n## ")[0], re.MULTILINE)
    return [[cell.strip() for cell in line.split("|")] for line in lines[1:]]


SYMBOLS, SECOND = rows("# Symbols"), rows("## Letters with a second meaning")
LETTERS = [letter for symbol, *_ in SYMBOLS for letter in symbol.split(", ")]
TEXTS = [text for _, names, *_ in SYMBOLS for text in re.findall(r"`([^`]+)`", names)]


def test_every_row_says_symbol_meaning_unit_and_place():
    assert len(SYMBOLS) > 30
    assert {len(row) for row in SYMBOLS} == {5}
    assert all(row[2] for row in SYMBOLS)


def test_one_symbol_has_one_meaning():
    assert len(set(LETTERS)) == len(LETTERS)
    assert len(set(TEXTS)) == len(TEXTS)


def test_letters_with_a_second_meaning_have_a_first_or_are_local():
    local = {"P", "K", "A", "R", "g", "φ", "ρ", "ω"}
    second = {letter for row in SECOND for letter in row[0].split(", ")}
    assert second - local <= set(LETTERS)
    assert all(len(row) == 3 and row[1] and row[2] for row in SECOND)


def tokens(text):
    """Symbols in the text of a file: Greek names, and letters with or without an index."""
    text = re.sub(r"\b[aA]\b(?= \w)|per cent", " ", text)
    return set(re.findall(rf"\b(?:{'|'.join(GREEK)}|[A-Za-z](?:_\w+)?)\b", text))


def test_symbols_of_variables_are_explained():
    for variable, meaning in LONG_NAMES.items():
        used = tokens(meaning) | (tokens(variable) & {variable})
        assert used <= {*TEXTS, *LETTERS}, variable


def greek_letters(text):
    return set(re.findall(r"[α-ωϵ]", text))


def test_greek_letters_of_pages_captions_and_configuration_are_explained():
    explained = greek_letters(" ".join(LETTERS)) | greek_letters(str(SECOND)) | {"π"}
    # In the docstrings that pages show, a letter is defined where it is used.
    for page in [*DOCUMENTS, *(ROOT / "workflow" / "report").glob("*.rst"), SCHEMA]:
        assert greek_letters(page.read_text(encoding="utf-8")) <= explained, page


def test_names_in_the_glossary_are_those_of_files_or_keys():
    schema = yaml.safe_load(SCHEMA.read_text(encoding="utf-8"))
    keys = {key for _, node in schema_nodes(schema) for key in node.get("properties", {})}
    known = keys | LONG_NAMES.keys() | {"exchange_exponent", "epsilon", "slow_time", "delta"}
    long = {text for text in TEXTS if len(text) > 3 and text not in GREEK}
    symbols = {"R_minus", "R_plus", "f_alpha", "gamma_0"}
    symbols |= {"impact_velocity", "front_profiles", "quadratic"}
    assert long - known - symbols == set()
