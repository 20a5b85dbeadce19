"""Compiled code: a kernel's cache must notice a change in every function the kernel calls."""

import importlib
import os
import runpy
import subprocess
import sys
from pathlib import Path

import llvmlite
import numba
import numpy as np
import pytest
from kernel_cases import CASES, solve_cases
from numba.core.registry import CPUDispatcher

from granular_fronts.numerics.compiled import (
    PACKAGES_IN_WORDS,
    SOURCES,
    Subroutine,
    cache_folder,
    file_of,
)
from granular_fronts.numerics.source_code import file_digest
from projects import ROOT

READ = Path.read_bytes
PACKAGES = sorted({file.parent.name for file in SOURCES.glob("*/__init__.py")})


def kernels_in(package):
    """Names and kernels of all modules of a package, imported ones among them."""
    for file in sorted((SOURCES / package).rglob("*.py")):
        dotted = ".".join(file.relative_to(SOURCES).with_suffix("").parts)
        module = importlib.import_module(f"granular_fronts.{dotted}")
        for name, value in vars(module).items():
            if isinstance(value, CPUDispatcher):
                yield f"{module.__name__}.{name}", value


@pytest.mark.parametrize("package", PACKAGES)
def test_every_kernel_is_cached_under_the_digest_of_its_module(package):
    for name, function in kernels_in(package):
        if not isinstance(function, Subroutine):
            folder = cache_folder(file_of(function.py_func))
            assert Path(function.stats.cache_path).parent == folder, name


def test_a_kernel_depends_on_the_modules_that_it_stands_on_and_on_no_other(monkeypatch):
    """A change of `band` concerns the profile equation's Newton steps and not the chain's."""
    newton, integrator = (SOURCES / "fronts/profile/newton.py", SOURCES / "chain/integrator.py")
    before = [cache_folder.__wrapped__(file) for file in (newton, integrator)]

    def changed(path):
        return READ(path) + (b"\nCHANGED = 1\n" if path == SOURCES / "numerics/band.py" else b"")

    monkeypatch.setattr(Path, "read_bytes", changed)
    file_digest.cache_clear()
    after = [cache_folder.__wrapped__(file) for file in (newton, integrator)]
    assert before[0] != after[0]
    assert before[1] == after[1]
    file_digest.cache_clear()


def test_a_kernel_depends_on_the_versions_of_its_compiler_and_of_numpy(monkeypatch):
    file = SOURCES / "chain/integrator.py"
    for package in (numba, llvmlite, np):
        with monkeypatch.context() as patched:
            patched.setattr(package, "__version__", "0.0")
            assert cache_folder.__wrapped__(file) != cache_folder(file), package.__name__


INNER = """
from granular_fronts.numerics.compiled import kernel

@kernel
def twice(x):
    return 2.0 * x
"""
OUTER = """
import runpy
import numba
from granular_fronts.numerics.compiled import kernel

twice = runpy.run_path({inner!r})["twice"]

@kernel
def four_times(x):
    return twice(twice(x))

numba.njit(lambda r: r * r)(2.0)  # A user's law is no kernel.
"""
NOTICE = "Compiling the kernels of mine; this happens once and takes up to a minute.\n"


def test_one_line_says_that_kernels_are_compiled_and_none_where_they_are_cached(
    tmp_path, monkeypatch, capsys
):
    """One for each package, and none for a kernel that is compiled for another's."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    inner, outer = (tmp_path / folder / "kernels.py" for folder in ("yours", "mine"))
    for file, text in ((inner, INNER), (outer, OUTER.format(inner=str(inner)))):
        file.parent.mkdir()
        file.write_text(text)
    for taken_from_the_cache in (0, 2):
        four_times = runpy.run_path(str(outer))["four_times"]
        assert four_times(3.0) == four_times(3) == 12.0
        assert sum(four_times.stats.cache_hits.values()) == taken_from_the_cache
    assert capsys.readouterr().err == NOTICE
    assert {"chain", "fronts"} <= PACKAGES_IN_WORDS.keys() <= set(PACKAGES)


COUNT_AFTER_COMPILATION = """
import sys
from importlib import import_module
sys.path[:0] = {tests!r}
from test_compiled import PACKAGES, kernels_in
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.continuum.log_kdv_burgers.survey import survey_heteroclinic
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.studies.fronts_compared import compare_front
from granular_fronts.studies.ring_against_equations import compare_with_chain

def count():
    return {{name: len(f.signatures) for package in PACKAGES for name, f in kernels_in(package)}}

for package in ("chain", "continuum", "fronts", "reference_methods"):
    import_module(f"granular_fronts.{{package}}.compilation").compile_kernels()
before = count()
scenes = load_configuration({default!r}, {smoke!r})["scenes"]
solvers = dict(chain=simulate_chain, periodic=compare_with_chain, heteroclinic=survey_heteroclinic,
               front=compare_front)
for kind, solve in solvers.items():
    for scene in scenes[kind].values():
        solve(scene)
print([name for name, found in count().items() if found > before[name]])
"""


@pytest.mark.slow
def test_compilation_covers_all_that_the_scenes_need():
    """A fresh process, since other tests compile kernels for other arguments."""
    files = {name: str(ROOT / f"config/{name}.yaml") for name in ("default", "smoke")}
    folders = [str(ROOT / "tests" / name) for name in ("support", "numerics")]
    code = COUNT_AFTER_COMPILATION.format(tests=folders, **files)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.stdout.strip() == "[]", run.stderr


CASES_IN_ORDER = """
import sys
sys.path[:0] = {folders!r}
from kernel_cases import CASES, save
save({file!r}, {cases})
"""
RUNS = {
    "compiled": ("CASES", 1),
    "loaded": ("CASES[::-1]", 2),
    "after other work": ("CASES * 2", 2),
}
"""Cases in order, the last results of which are kept, and the threads that libraries may take."""
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")


# Every kernel is compiled from nothing.
@pytest.mark.nightly
def test_the_same_question_gives_the_same_bits(tmp_path):
    """Compiled now or before, in whichever order, on one thread or two, and in this process."""
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "kernels")}
    folders = [str(ROOT / part) for part in ("src", "tests/support")]
    first = {name: np.asarray(each).tobytes() for name, each in solve_cases(CASES).items()}
    for when, (cases, threads) in RUNS.items():
        file = str(tmp_path / f"{when}.npz")
        code = CASES_IN_ORDER.format(folders=folders, file=file, cases=cases)
        limits = environment | dict.fromkeys(THREADS, str(threads))
        subprocess.run([sys.executable, "-c", code], env=limits, check=True)
        assert {name: each.tobytes() for name, each in np.load(file).items()} == first, when
