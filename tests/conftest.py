"""What several test modules are given."""

import copy

import pytest
from configurations import DEFAULT

from granular_fronts.scenes.yaml_files import load_configuration
from projects import copy_project, lend_kernels, snakemake

DEFAULTS = load_configuration(DEFAULT)
LONGEST = (
    *("test_staleness", "test_campaign_run", "test_workflow"),
    *("test_proof_fronts", "test_a_further_law"),
    *("test_documents", "test_chain_reference", "test_interrupts"),
    *("test_proof_checker", "test_passes", "test_extending"),
)


def pytest_collection_modifyitems(items):
    """Start with the files that take longest: side by side, the short ones even out the end."""
    order = {name: place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: order.get(item.path.stem, len(order)))


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A copy of the project in which the smoke run is done."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    run = snakemake("--configfile", "config/smoke.yaml", folder=copy)
    assert run.returncode == 0, run.stderr
    return copy


@pytest.fixture
def default():
    """The default configuration, a test's own copy."""
    return copy.deepcopy(DEFAULTS)
