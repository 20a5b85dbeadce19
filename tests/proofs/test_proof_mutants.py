"""A sample of mutants of the checker of proofs; `tools/mutation.py` tries them all."""

import pytest

from mutation import LONG, SHORT, TREES, Examples, mutants, noticed


@pytest.fixture(scope="module")
def examples(tmp_path_factory):
    return Examples(tmp_path_factory.mktemp("certificates"))


@pytest.mark.slow
def test_checker_itself_is_no_mutant(examples):
    assert not noticed(TREES, LONG, examples.differ, examples.believed)


@pytest.mark.slow
def test_most_mutants_are_noticed(examples):
    """Every 53rd changes what is proved, or is one of few that are equivalent or need more.

    A refusal that is left out only wrong certificates notice, which the tool tries.
    """
    sample = [one for one in mutants(every=53) if ": raise" not in one[0]]
    survivors = [name for name, trees in sample if not noticed(trees, SHORT, examples.differ)]
    assert len(survivors) <= 0.15 * len(sample), survivors
