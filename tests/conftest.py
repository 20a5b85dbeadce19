"""What several test modules are given."""

import pytest
from configurations import DEFAULT
from projects import copy_project, snakemake

from granular_fronts.scenes.yaml_files import load_configuration


@pytest.fixture(scope="session")
def finished(tmp_path_factory):
    """A copy of the project in which the smoke run is done."""
    copy = copy_project(tmp_path_factory.mktemp("project"))
    run = snakemake("--configfile", "config/smoke.yaml", folder=copy)
    assert run.returncode == 0, run.stderr
    return copy


@pytest.fixture
def default():
    """The default configuration, a test's own copy."""
    return load_configuration(DEFAULT)
