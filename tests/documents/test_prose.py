"""README and manual are written in sentences of a length that is understood at once."""

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
