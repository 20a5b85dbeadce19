"""The examples in the docstrings of laws and of what follows from them."""

import doctest
from importlib import import_module

import pytest

MODULES = ["laws", "potentials", "jump_conditions", "collision"]


@pytest.mark.parametrize("name", MODULES)
def test_examples_give_what_they_show(name):
    found = doctest.testmod(import_module(f"granular_fronts.model.{name}"))
    assert found.attempted > 0
    assert found.failed == 0
