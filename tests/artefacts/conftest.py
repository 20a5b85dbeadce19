"""What the tests of finished files are given; the rule check_results runs them."""

from pathlib import Path
from typing import NamedTuple

import pytest
import yaml

from granular_fronts.output.departures import physical_departures
from questions import questions

PROJECT = Path(__file__).parents[2]


class Made(NamedTuple):
    """Stems of what a plain call of the workflow makes, below the results folder."""

    figures: list[str]
    tables: list[str]


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
    return yaml.safe_load(request.config.getoption("--configuration").read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def as_in_the_paper(configuration):
    """Skip a test that expects the paper's parameters where some of its datasets have others."""
    default = yaml.safe_load((PROJECT / "config/default.yaml").read_text(encoding="utf-8"))
    asked, reference = questions(configuration), questions(default)

    def check(*names):
        for name in names:
            if physical_departures(asked[name], reference[name]):
                pytest.skip(f"{name} has other parameters than the paper")

    return check


@pytest.fixture(scope="session")
def made():
    """The figures and tables that must be there."""
    return listed_as_made()


def listed_as_made():
    """Read the lists of figures and tables."""
    figures, tables = (
        yaml.safe_load((PROJECT / "workflow" / name).read_text(encoding="utf-8"))
        for name in ("figures.yaml", "tables.yaml")
    )
    return Made(
        figures=[
            f"figures/{figure}_{described['name']}"
            for figure, described in figures.items()
            if not described.get("on_demand")
        ],
        tables=[
            f"tables/{table}"
            for table, described in tables.items()
            if not described.get("on_demand")
        ],
    )
