"""What several test modules are given."""

import copy
import fcntl
import os

import pytest
from configurations import DEFAULT
from projects import CACHES, copy_project, lend_kernels, snakemake

from granular_fronts.scenes.yaml_files import load_configuration

DEFAULTS = load_configuration(DEFAULT)
LONGEST = (
    *("test_staleness", "test_campaign_run", "test_proof_mutants", "test_workflow"),
    *("test_container", "test_proof_fronts", "test_a_further_law", "test_hard_cases"),
    *("test_documents", "test_chain_reference", "test_interrupts"),
    *("test_uncompiled", "test_proof_checker", "test_passes", "test_extending"),
)


def pytest_collection_modifyitems(items):
    """Start with the files that take longest: side by side, the short ones even out the end."""
    order = {name: place for place, name in enumerate(LONGEST)}
    items.sort(key=lambda item: order.get(item.path.stem, len(order)))


@pytest.fixture(scope="session")
def smoke_run(tmp_path_factory):
    """A copy of the project in which the smoke run is done, one for all processes that test."""
    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent
    with (folder / "smoke_run.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        project = folder / "smoke_run" / "copy"
        if not (project / "results/smoke/report.html").exists():
            lend_kernels(copy_project(project.parent))
            run = snakemake("--configfile", "config/smoke.yaml", folder=project)
            assert run.returncode == 0, run.stderr
    return project


@pytest.fixture(scope="module")
def finished(smoke_run, tmp_path_factory):
    """The smoke run, a copy for each module that may change it."""
    copy = copy_project(tmp_path_factory.mktemp("project"), of=smoke_run, leave_out=CACHES)
    return lend_kernels(copy)


@pytest.fixture
def default():
    """The default configuration, a test's own copy."""
    return copy.deepcopy(DEFAULTS)
