"""What several test modules are given, and which marks do not fit."""

import collections
import copy

import pytest
from configurations import DEFAULT

from granular_fronts.scenes.yaml_files import load_configuration

DEFAULTS = load_configuration(DEFAULT)
SECONDS_OF_FAST, SECONDS_OF_SLOW = 3.0, 0.5


def pytest_terminal_summary(terminalreporter):
    """Name fast tests that took too long, and slow ones that need not be slow."""
    seconds, prepared = collections.Counter(), set()
    for report in (*terminalreporter.getreports(""), *terminalreporter.getreports("passed")):
        if "nightly" not in report.keywords:
            seconds[report.nodeid, "slow" in report.keywords] += report.duration
        if report.when == "setup" and report.duration > SECONDS_OF_SLOW:
            prepared.add(report.location[0])  # what was made there serves other tests too
    for (name, slow), taken in sorted(seconds.items()):
        if slow and taken < SECONDS_OF_SLOW and name.split("::")[0] not in prepared:
            terminalreporter.line(f"{name} took {taken:.1f} s: unmark it as slow.")
        if not slow and taken > SECONDS_OF_FAST:
            terminalreporter.line(f"{name} took {taken:.1f} s: make it faster, or mark it slow.")


@pytest.fixture
def default():
    """The default configuration, a test's own copy."""
    return copy.deepcopy(DEFAULTS)
