"""Pages, docstrings, comments and captions have sentences that are understood at once."""

import re

import pytest
from pages import load_script
from projects import ROOT

SENTENCES = load_script("sentences")
PAGES = {page: page.read_text(encoding="utf-8") for page in load_script("measured").pages()}
LENGTHS = {
    page.relative_to(ROOT).as_posix(): [
        len(SENTENCES.words(one)) for one in SENTENCES.sentences(text)
    ]
    for page, text in PAGES.items()
}


@pytest.mark.parametrize("page", [page for page, lengths in LENGTHS.items() if lengths])
def test_sentences_are_short(page):
    lengths = LENGTHS[page]
    assert max(lengths) <= SENTENCES.MOST_WORDS
    if len(lengths) >= 5:  # A mean of fewer says nothing.
        assert sum(lengths) / len(lengths) <= SENTENCES.MOST_WORDS_IN_THE_MEAN


def test_sentences_of_docstrings_comments_captions_and_descriptions_are_short():
    most, counted = SENTENCES.MOST_WORDS_IN_SOURCES, SENTENCES.plain_words
    found = {path: SENTENCES.source_sentences(path) for path in SENTENCES.sources()}
    assert {path.suffix for path in found if found[path]} == {"", ".py", ".smk", ".yaml", ".rst"}
    long = [(path, one) for path in found for one in found[path] if counted(one) > most]
    assert long == []


def test_what_counts_in_comments_descriptions_and_captions(tmp_path):
    texts = {
        "module.py": "# Two words\n# and three more.\nx = 1  # not counted\n",
        "listed.yaml": "# key: two words\n# other: three words\na: [alt: '(a) Four {{ x }}']\n",
        "caption.rst": "**Figure 1.** A line. (a) Two lines of ``code words`` (b) Three.\n",
    }
    counts = {}
    for name, text in texts.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
        found = SENTENCES.source_sentences(tmp_path / name)
        counts[name] = [n for n in map(SENTENCES.plain_words, found) if n]
    assert counts == {"module.py": [5], "listed.yaml": [3, 3, 1], "caption.rst": [1, 1, 4]}


PRIVATE = re.compile(
    r"\b(stands?(?! for| out)|beside|mend\w*|obstacles?|lacking|doubt|wings?|at hand|tells?)\b",
    re.IGNORECASE,
)
"""Words that readers from outside do not use in this way."""


def test_no_page_or_source_has_private_words():
    found = {page: SENTENCES.sentences(text) for page, text in PAGES.items()}
    found |= {path: SENTENCES.source_sentences(path) for path in SENTENCES.sources()}
    assert [(path, one) for path in found for one in found[path] if PRIVATE.search(one)] == []
    assert PRIVATE.search("This stands beside that.")


def test_what_counts_as_a_sentence():
    page = """# A heading is none

One sentence of $x + y$, `code of three words` and [a link](to/a/page.md) has eleven words. A second
one, with α = 1.5!

| neither | is |
|---|---|
| a | table. |

```sh
nor is code
```

- An entry of a list is one.
"""
    found = SENTENCES.sentences(page)
    assert [len(SENTENCES.words(one)) for one in found] == [11, 6, 7]


def test_what_counts_in_a_docstring():
    source = """
def one(x):
    '''Return :math:`x + y` of a chain in ``code of words``.  Four words are here.

    .. math:: x = y

        - z

    - An entry
      is one sentence of six words.

    Parameters
    ----------
    x : array, shape (beads,)
        Two words.

    >>> no prose
    '''
"""
    found = SENTENCES.docstring_sentences(source)
    assert [n for n in map(SENTENCES.plain_words, found) if n] == [4, 4, 8, 2]
