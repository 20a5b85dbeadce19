"""Proofs are tested where python-flint is installed, and reported as skipped where it is not."""

import pytest


def pytest_pycollect_makemodule():
    pytest.importorskip("flint")
