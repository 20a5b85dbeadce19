"""The project as its tests see it: its folder, copies of it, and the step of a script."""

import importlib.util
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
REBUILT = [".git", ".venv", ".snakemake", "results", ".*_cache", "__pycache__"]


def copy_project(folder):
    """A copy of the project, with nothing computed."""
    copy = folder / "copy"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*REBUILT))
    return copy


def load_step(script):
    """Import a script without running it; the step carries the script's name."""
    spec = importlib.util.spec_from_file_location(script.stem, script)
    module = importlib.util.module_from_spec(spec)
    sys.modules[script.stem] = module
    spec.loader.exec_module(module)
    return getattr(module, script.stem)
