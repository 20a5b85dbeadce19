"""How long the sentences of README and manual are: python docs/sentences.py.

Only prose counts: no code, tables, headings, displayed formulas or comments. A formula in a line, a
piece of code and a number are one word each.
"""

import re

from measured import ROOT, pages

MOST_WORDS = 35
"""Words of the longest sentence that a page may have."""

MOST_WORDS_IN_THE_MEAN = 18

LEFT_OUT = re.compile(
    r"^( *)(```|~~~).*?^\1\2\s*$|^---\n.*?^---$|<!--.*?-->|\$\$.*?\$\$"
    r"|^ *(\||#|:|\(\w+\)=|</?).*?$|^    .*?$",
    re.MULTILINE | re.DOTALL,
)
ONE_WORD = re.compile(r"`[^`]*`|\$[^$]*\$")
LINK = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")
PARAGRAPH = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*>]|\d+\.) )")
END = re.compile(r"(?<=[.!?])[*_)\"”’]*\s+(?=[*_(\"“‘]*[^\Wa-z])")
WORD = re.compile(r"[^\W_][\w.,’'·⁻^*/−-]*")


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


def main() -> None:
    """Print the mean, and the longest sentence, of every page."""
    for page in pages():
        if found := sentences(page.read_text(encoding="utf-8")):
            longest = max(found, key=lambda one: len(words(one)))
            mean = sum(map(len, map(words, found))) / len(found)
            print(f"{mean:5.1f} {len(words(longest)):4} {page.relative_to(ROOT)}: {longest[:90]}")


if __name__ == "__main__":
    main()
