"""Compiled kernels do what their text says: the same numbers as the same lines in Python.

Where coverage is measured, the second process is what sees the lines of the kernels.
"""

import os
import subprocess
import sys

import numpy as np
import pytest
from kernel_cases import CASES, solve_cases
from projects import ROOT


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """All arrays of all cases by name, compiled and, in another process meanwhile, not."""
    file = tmp_path_factory.mktemp("uncompiled") / "cases.npz"
    folders = (ROOT / "src", ROOT / "workflow" / "lib", ROOT / "tests" / "support")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, folders))}
    solve = "import sys, uncompiled; from kernel_cases import save; save(sys.argv[1])"
    # Overflows that compiled code passes over in silence are warnings in Python.
    command = [sys.executable, "-W", "ignore", "-c", solve, file]
    with subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True) as process:
        compiled = solve_cases()
        _, errors = process.communicate()
    assert process.returncode == 0, errors
    with np.load(file) as arrays:
        return compiled, dict(arrays)


@pytest.mark.parametrize("case", [case.__name__ for case in CASES])
def test_compiled_and_uncompiled_kernels_agree(case, results):
    """Far below the tolerances, where a sum rounded once or twice changes the length of a step."""
    compiled, uncompiled = results
    assert compiled.keys() == uncompiled.keys()
    names = [name for name in compiled if name.split()[0] == case]
    assert any(compiled[name].size for name in names)
    for name in names:
        np.testing.assert_allclose(uncompiled[name], compiled[name], rtol=1e-9, atol=1e-9)
