"""Texts of a figure or a table, each written once, in one file of reStructuredText.

The file begins with the title.  A comment follows, which a reader of the caption does not see: of
a figure what somebody who cannot see it should know, of a table what it means.  The caption ends
the file; that of a figure is a Jinja template.  ::

    A front starts
    ==============

    .. Compression of single beads against time, far from the compressed end and near it.

    A front starts at the compressed end of a chain (α = {{ data.law.alpha }}).
"""

import hashlib
import re
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

FORM = re.compile(r"(?P<title>.+)\n=+\n\n\.\. (?P<comment>.+(?:\n   .+)*)\n\n(?P<caption>(?s:.+))")


class Texts(NamedTuple):
    """Title, comment and caption of a figure or a table."""

    title: str
    comment: str
    caption: str


def read_texts(file: Path | str) -> Texts:
    """Read the texts of a figure or a table; a ValueError says which file has another form."""
    form = FORM.fullmatch(Path(file).read_text(encoding="utf-8"))
    if form is None:
        raise ValueError(
            f"{file} needs a title with a line of = below, an empty line, a comment that begins "
            "with two dots, an empty line, and the caption."
        )
    return Texts(form["title"], re.sub(r"\s+", " ", form["comment"]), form["caption"])


def files_of(texts: Path | str, results: Path | str) -> list[Path]:
    """Return the files of the figure or table of some texts, in a results folder."""
    name = Path(texts).stem
    if name.startswith("table_"):
        table = Path(results, "tables", name.removeprefix("table_"))
        return [table.with_suffix(ending) for ending in (".csv", ".md")]
    figure = Path(results, "figures", name)
    return [figure.with_suffix(ending) for ending in (".pdf", ".png", ".rst")]


def contents(every: Iterable[Path | str], results: Path | str) -> str:
    """Return a digest of the figures and tables of some texts, for a job that they do not cause."""
    digest = hashlib.sha256()
    for file in [file for texts in every for file in files_of(texts, results)]:
        digest.update(file.read_bytes())
    return digest.hexdigest()
