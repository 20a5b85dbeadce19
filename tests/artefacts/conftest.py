"""What the tests of finished files are given; the rule check_results runs them."""

import json
from functools import cache
from pathlib import Path

import pytest

from granular_fronts.output import datasets
from granular_fronts.output.departures import physical_departures

# Each file once for all tests, which leave what they are given as it is.
read_dataset = cache(datasets.read_dataset)


def pytest_addoption(parser):
    parser.addoption("--results", type=Path, help="the results folder")
    parser.addoption("--made", type=Path, help="a JSON file that lists datasets and figures")


@pytest.fixture(scope="session")
def results(request):
    """The folder that holds data, figures and tables."""
    return request.config.getoption("--results")


@pytest.fixture(scope="session")
def made(request):
    """The datasets that should be there, each with its parameters and the paper's; the figures."""
    return json.loads(request.config.getoption("--made").read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def as_in_the_paper(made):
    """Skip a test that expects the paper's parameters where some of its datasets have others."""

    def check(*names):
        for name in names:
            if physical_departures(*made["datasets"][name]):
                pytest.skip(f"{name} has other parameters than the paper")

    return check
