"""What the tests of finished files are given; the rule check_results runs them."""

from functools import cache
from pathlib import Path

import pytest

from dataset_parameters import default_parameters
from granular_fronts.output import datasets
from granular_fronts.output.departures import physical_departures
from granular_fronts.scenes.yaml_files import read_yaml

PROJECT = Path(__file__).parents[2]

# Each file once for all tests, which leave what they are given as it is.
read_dataset = cache(datasets.read_dataset)


def pytest_addoption(parser):
    parser.addoption("--results", type=Path, default=Path("results"), help="the results folder")
    parser.addoption(
        "--configuration",
        type=Path,
        default=PROJECT / "config/default.yaml",
        help="a YAML file with the merged configuration that was computed",
    )


@pytest.fixture(scope="session")
def results(request):
    """The folder that holds data, figures and tables."""
    return request.config.getoption("--results")


@pytest.fixture(scope="session")
def configuration(request):
    """The merged configuration."""
    return read_yaml(request.config.getoption("--configuration"))


@pytest.fixture(scope="session")
def as_in_the_paper(configuration):
    """Skip a test that expects the paper's parameters where some of its datasets have others."""
    default = read_yaml(PROJECT / "config/default.yaml")
    present, reference = default_parameters(configuration), default_parameters(default)

    def check(*names):
        for name in names:
            if physical_departures(present[name], reference[name]):
                pytest.skip(f"{name} has other parameters than the paper")

    return check


def listed_as_made(kind):
    """Stems of the figures or tables that a plain call of the workflow makes, below the results."""
    return [
        f"{kind}/{f'{key}_' if 'name' in described else ''}{described.get('name', key)}"
        for key, described in read_yaml(PROJECT / "workflow" / f"{kind}.yaml").items()
        if not described.get("on_demand")
    ]
