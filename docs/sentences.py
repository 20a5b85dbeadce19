"""How long the sentences of README, manual and docstrings are: python docs/sentences.py.

Only prose counts: no code, tables, headings, displayed formulas or comments. A formula in a line, a
piece of code and a number are one word each in a page. None of them is a word in a docstring, nor
is a single letter, since a docstring writes many formulas as plain text.
"""

import ast
import re
from inspect import cleandoc
from itertools import groupby
from pathlib import Path

from measured import ROOT, pages

MOST_WORDS = 35
"""Words of the longest sentence that a page may have."""

MOST_WORDS_IN_THE_MEAN = 18

MOST_WORDS_IN_A_DOCSTRING = 22
"""Words of the longest sentence that a module of the package or a script may have."""

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
DOCSTRING_WORD = re.compile(r"(?<!\w)[A-Za-z][a-zé-]+")


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
    """Modules of the package, and the workflow's own Python."""
    return sorted([*(ROOT / "src").rglob("*.py"), *(ROOT / "workflow").rglob("*.py")])


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


def docstring_words(sentence: str) -> int:
    """How many words a sentence of a docstring has."""
    return len(DOCSTRING_WORD.findall(sentence))


def main() -> None:
    """Print the mean and the longest sentence of every page, and the longest of every module."""
    for page in pages():
        if found := sentences(page.read_text(encoding="utf-8")):
            longest = max(found, key=lambda one: len(words(one)))
            mean = sum(map(len, map(words, found))) / len(found)
            print(f"{mean:5.1f} {len(words(longest)):4} {page.relative_to(ROOT)}: {longest[:90]}")
    for module in sources():
        found = docstring_sentences(module.read_text(encoding="utf-8"))
        longest = max(found, key=docstring_words, default="")
        print(f"{docstring_words(longest):10} {module.relative_to(ROOT)}: {longest[:90]}")


if __name__ == "__main__":
    main()
