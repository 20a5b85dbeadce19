"""Compiled code: a kernel's cache must notice a change in every function the kernel calls."""

import importlib
import os
import subprocess
import sys
from pathlib import Path

import numba
import pytest
from numba.core.registry import CPUDispatcher

from granular_fronts.compiled import CALLED_WINGS, SOURCES, cache_folder, kernel

WINGS = sorted({file.parent.name for file in SOURCES.glob("*/*.py")})


def kernels_in(wing):
    """Names and kernels of all modules of a wing, imported ones among them."""
    for file in sorted((SOURCES / wing).glob("*.py")):
        module = importlib.import_module(f"granular_fronts.{wing}.{file.stem}")
        for name, value in vars(module).items():
            if isinstance(value, CPUDispatcher):
                yield f"{module.__name__}.{name}", value


@pytest.mark.parametrize("wing", WINGS)
def test_a_wing_calls_kernels_of_declared_wings_only(wing):
    allowed = {wing, *CALLED_WINGS.get(wing, ())}
    for name, function in kernels_in(wing):
        home = Path(function.py_func.__code__.co_filename).parent.name
        assert home in allowed, f"{name} lives in {home}: declare it in CALLED_WINGS"


@pytest.mark.parametrize("wing", WINGS)
def test_every_kernel_is_cached_under_the_digest_of_its_wing(wing):
    for name, function in kernels_in(wing):
        home = Path(function.py_func.__code__.co_filename).parent.name
        assert Path(function.stats.cache_path).parent == cache_folder(home), name


def test_kernel_decorates_with_and_without_options():
    def double(x):
        return 2 * x

    with_options = kernel(fastmath=True)(double)
    assert kernel(double)(3) == with_options(3) == 6
    assert with_options.targetoptions["fastmath"]
    assert isinstance(with_options, numba.core.registry.CPUDispatcher)


STEP_ON_A_GRID = """
from granular_fronts.continuum import upwind
for _ in range(2):
    upwind.evolve_upwind([0.5] * 8, 1.0, 1.0e-3)
"""
NOTICE = (
    "Compiling the kernels of the amplitude equations; this happens once and takes up to a "
    "minute.\n"
)


def test_one_line_says_that_kernels_are_compiled_and_none_where_they_are_cached(tmp_path):
    environment = {
        **os.environ,
        "NUMBA_CACHE_DIR": str(tmp_path),
        "PYTHONPATH": str(SOURCES.parent),
    }
    command = [sys.executable, "-c", STEP_ON_A_GRID]
    for expected in (NOTICE, ""):
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        assert run.stderr == expected
        assert run.stdout == ""


def test_compiling_what_is_no_kernel_is_not_announced(capsys):
    @numba.njit
    def user_law(r):
        return r * r

    assert user_law(2.0) == 4.0
    assert capsys.readouterr().err == ""


COUNT_AFTER_WARM_UP = """
import sys
sys.path.insert(0, {tests!r})
from test_compiled import WINGS, kernels_in
from granular_fronts import chain, continuum, fronts
from granular_fronts.comparison import compare_with_chain
from granular_fronts.scenes.yaml_files import load_configuration
from granular_fronts.continuum.survey import survey_heteroclinic
from granular_fronts.fronts.comparison import compare_front

def count():
    return {{name: len(f.signatures) for wing in WINGS for name, f in kernels_in(wing)}}

chain.warm_up()
continuum.warm_up()
fronts.warm_up()
before = count()
scenes = load_configuration({default!r}, {smoke!r})["scenes"]
for scene in scenes["chain"].values():
    chain.simulate_chain(scene)
for scene in scenes["periodic"].values():
    compare_with_chain(scene)
for scene in scenes["heteroclinic"].values():
    survey_heteroclinic(scene)
for scene in scenes["front"].values():
    compare_front(scene)
print([name for name, found in count().items() if found > before[name]])
"""


def test_warm_up_compiles_all_that_the_scenes_need():
    """A fresh process, since other tests compile kernels for other arguments."""
    root = Path(__file__).parents[1]
    files = {name: str(root / f"config/{name}.yaml") for name in ("default", "smoke")}
    code = COUNT_AFTER_WARM_UP.format(tests=str(root / "tests"), **files)
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert run.stdout.strip() == "[]", run.stderr
