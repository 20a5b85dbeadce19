"""What the tests of finished files are given; the rule check_results runs them."""

from pathlib import Path

import pytest


def pytest_addoption(parser):
    parser.addoption("--results", type=Path, default=Path("results"), help="the results folder")


@pytest.fixture(scope="session")
def results(request):
    """The folder that holds data, figures and tables."""
    return request.config.getoption("--results")
