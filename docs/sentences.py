"""How long sentences of pages, docstrings, comments and captions are: python docs/sentences.py.

Only prose counts: no code, tables, headings or displayed formulas. A formula in a line, a piece of
code and a number are one word each in a page. None of them is a word anywhere else, nor is a single
letter, since docstrings and comments write many formulas as plain text.
"""

import ast
import re
from collections.abc import Iterator
from inspect import cleandoc
from itertools import groupby
from pathlib import Path
from typing import Any

import yaml
from measured import ROOT, pages

MOST_WORDS = 35
"""Words of the longest sentence that a page may have."""

MOST_WORDS_IN_THE_MEAN = 18

MOST_WORDS_IN_SOURCES = 22
"""Words of the longest sentence of package, workflow and configuration: docstrings, comments,
captions, descriptions.
"""

LEFT_OUT = re.compile(
    r"^( *)(```|~~~).*?^\1\2\s*$|^---\n.*?^---$|<!--.*?-->|\$\$.*?\$\$"
    r"|^ *(\||#|:|\(\w+\)=|</?).*?$|^    .*?$",
    re.MULTILINE | re.DOTALL,
)
ONE_WORD = re.compile(r"`[^`]*`|\$[^$]*\$")
LINK = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")
PARAGRAPH = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*>]|\d+\.) )")
NO_PROSE = re.compile(
    r"^( *)\.\. \w+::.*?(?=\n\1\S|\Z)|(?<=:):\n\n +\S.*?(?=\n\S|\Z)"
    r"|^ *(>>>|=+ +=).*?(?=\n\s*\n|\Z)|^[^\n]*\n *-{3,}$|^[\w*, ]+ : .*?$",
    re.MULTILINE | re.DOTALL,
)
"""Of a docstring: displayed formulas, code, tables, heads of sections and of parameters."""

CODE = re.compile(r"(:\w+:)?(``?)[^`]*\2")
ENTRY = re.compile(r"^( *)(?:[-*] |\d+\. |\w+ {2,}(?=\S))", re.MULTILINE)
END = re.compile(r"(?<=[.!?∎])[*_)\"”’]*\s+(?=[*_(\"“‘]*[^\Wa-z])")
WORD = re.compile(r"[^\W_][\w.,’'·⁻^*/−-]*")
PLAIN_WORD = re.compile(r"(?<!\w)[A-Za-z][a-zé-]+")

COMMENT = re.compile(r"(?:^ *# .*\n)+", re.MULTILINE)
MARK = re.compile(r"^ *# ", re.MULTILINE)
KEY = re.compile(r"^(?=\w+: )", re.MULTILINE)
"""Where a comment on a YAML file explains its next key."""

VALUE = re.compile(r"\{%.*?%\}|\{\{.*?\}\}|\([a-p]\)", re.DOTALL)
"""What a template fills in, and the letter of a panel, with which a sentence may begin."""

WORDED_KEYS = ("title", "alt", "caption", "meaning", "description", "message", "remark")
"""Keys of YAML files with texts that people read."""


def sentences(text: str) -> list[str]:
    """The sentences of a page in Markdown.

    Parameters
    ----------
    text : str

    Returns
    -------
    list of str
        A heading, a cell of a table and code are no sentences.
    """
    prose = LINK.sub(r"\1", ONE_WORD.sub("X", LEFT_OUT.sub("", text)))
    found = [part for one in PARAGRAPH.split(prose) for part in END.split(" ".join(one.split()))]
    return [one for one in found if len(words(one)) > 1]


def words(sentence: str) -> list[str]:
    """The words of a sentence."""
    return WORD.findall(sentence)


def sources() -> list[Path]:
    """Files of package, workflow and configuration that hold prose."""
    endings = {".py", ".smk", ".yaml", ".rst"}
    folders = [ROOT / name for name in ("src", "workflow", "config", "papers")]
    files = [path for folder in folders for path in folder.rglob("*") if path.suffix in endings]
    return sorted([*files, ROOT / "Snakefile", ROOT / "workflow" / "Snakefile"])


def source_sentences(path: Path) -> list[str]:
    """The sentences of docstrings, comments, captions and descriptions of a file."""
    text = path.read_text(encoding="utf-8")
    blocks = [part for block in COMMENT.findall(text) for part in KEY.split(MARK.sub("", block))]
    if path.suffix == ".rst":
        blocks.append(text)
    if path.suffix == ".yaml":
        blocks += _described(yaml.safe_load(text))
    plain = [CODE.sub("X", VALUE.sub("X", block)) for block in blocks]
    found = [one for block in plain for one in END.split(" ".join(block.split()))]
    return found + (docstring_sentences(text) if path.suffix == ".py" else [])


def _described(content: Any) -> Iterator[str]:
    """The texts of a YAML file that people read."""
    parts = content.items() if isinstance(content, dict) else []
    yield from (text for key, text in parts if key in WORDED_KEYS and isinstance(text, str))
    for below in content.values() if isinstance(content, dict) else content:
        if isinstance(below, dict | list):
            yield from _described(below)


def docstring_sentences(source: str) -> list[str]:
    """The sentences of the docstrings of a module, each formula and piece of code as X."""
    expressions = [node.value for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Expr)]
    texts = [one.value for one in expressions if isinstance(one, ast.Constant)]
    blocks = []
    for text in filter(lambda value: isinstance(value, str), texts):
        prose = ENTRY.sub(r"\n\1  ", CODE.sub("X", NO_PROSE.sub("\n\n", cleandoc(text))))
        lines = groupby(prose.splitlines(), _indentation)
        blocks += [" ".join(" ".join(group).split()) for _, group in lines]
    return [one for block in blocks for one in END.split(block)]


def _indentation(line: str) -> int:
    """Spaces before a line, −1 for an empty line."""
    return len(line) - len(line.lstrip()) if line.strip() else -1


def plain_words(sentence: str) -> int:
    """How many words a sentence has that is not a page's."""
    return len(PLAIN_WORD.findall(sentence))


def main() -> None:
    """Print the mean and the longest sentence of every page, and the longest of every source."""
    for page in pages():
        if found := sentences(page.read_text(encoding="utf-8")):
            longest = max(found, key=lambda one: len(words(one)))
            mean = sum(map(len, map(words, found))) / len(found)
            print(f"{mean:5.1f} {len(words(longest)):4} {page.relative_to(ROOT)}: {longest[:90]}")
    for path in sources():
        longest = max(source_sentences(path), key=plain_words, default="")
        print(f"{plain_words(longest):10} {path.relative_to(ROOT)}: {longest[:90]}")


if __name__ == "__main__":
    main()
