"""README, manual and docstrings are written in sentences that are understood at once."""

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


def test_sentences_of_docstrings_are_short():
    for module in SENTENCES.sources():
        found = SENTENCES.docstring_sentences(module.read_text(encoding="utf-8"))
        longest = max(found, key=SENTENCES.docstring_words, default="")
        assert SENTENCES.docstring_words(longest) <= SENTENCES.MOST_WORDS_IN_A_DOCSTRING, module


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
    assert [n for n in map(SENTENCES.docstring_words, found) if n] == [4, 4, 8, 2]
