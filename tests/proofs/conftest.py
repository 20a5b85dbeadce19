"""Proofs are tested where python-flint is installed."""

from importlib.util import find_spec

collect_ignore_glob = [] if find_spec("flint") else ["test_*.py"]
