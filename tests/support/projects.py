"""The project as its tests see it: its folder, copies of it, calls of its workflow."""

import contextlib
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pandas as pd
import psutil

ROOT = Path(__file__).parents[2]
REBUILT = [".git", ".venv", ".snakemake", "results", ".*_cache", "__pycache__"]


def copy_project(folder):
    """A copy of the project, with nothing computed."""
    copy = folder / "copy"
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*REBUILT))
    return copy


def lend_kernels(copy):
    """Let a copy use the kernels of this project: what either compiles, both have.

    Numba names the folders of its cache after those of the sources.  What the code of a changed
    copy compiles has a digest of its own, and stays in the copy.
    """
    # Every process of pytest imports this file, the one too that only hands out tests.
    from numba.core.caching import UserProvidedCacheLocator

    from granular_fronts.numerics.compiled import cache_folder

    for file in (ROOT / "src").rglob("*.py"):
        if "granular_fronts.numerics.compiled import" not in file.read_text(encoding="utf-8"):
            continue
        kernels, path = cache_folder(file), copy / file.relative_to(ROOT)
        own, lent = map(UserProvidedCacheLocator.get_suitable_cache_subpath, (file, path))
        (kernels / own).mkdir(parents=True, exist_ok=True)
        link = copy / ".numba_cache" / kernels.name / lent
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(kernels / own, target_is_directory=True)
    return copy


def snakemake(*arguments, folder=ROOT):
    """Call the workflow in a folder and wait for its end."""
    command = [sys.executable, "-m", "snakemake", "--cores", "2", *map(str, arguments)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def rules_due(plan):
    """Names of the rules that a dry run would run."""
    return set(re.findall(r"^(\w+) +\d+$", plan.stdout, re.MULTILINE)) - {"total"}


def jobs_due(*arguments, folder=ROOT):
    """The jobs due behind each job of a plan, by their rules and wildcards.

    One start answers for many targets: whether a job is due follows from what lies upstream of it,
    and not from the other targets.
    """
    run = snakemake("--dag", *arguments, folder=folder)
    assert run.returncode == 0, run.stderr
    nodes = re.findall(r'^\t(\d+)\[label = "(.*?)".*style="(.*?)"\];$', run.stdout, re.MULTILINE)
    names = {number: label.replace("\\n", " ") for number, label, _ in nodes}
    upstream = {number: {number} for number in names}
    edges = re.findall(r"^\t(\d+) -> (\d+)$", run.stdout, re.MULTILINE)
    while any(not upstream[above] <= upstream[below] for above, below in edges):
        for above, below in edges:
            upstream[below] |= upstream[above]
    due = {number for number, _, style in nodes if "dashed" not in style}
    return {
        name: {names[above] for above in upstream[number] & due} for number, name in names.items()
    }


def run_project(name, folder):
    """The results of a project of its own, computed in a copy, and its page."""
    copy = lend_kernels(copy_project(folder))
    run = snakemake(name, folder=copy)
    assert run.returncode == 0, run.stderr
    readme = (copy / "projects" / name / "README.md").read_text(encoding="utf-8")
    return copy / "results", readme.replace("−", "-")


def assert_readme_shows_statements(name, folder):
    """A row of the page names a statement; its error is the computed one, or of the last digit."""
    results, readme = run_project(name, folder)
    [table] = (results / "tables").glob(f"{name}_*.csv")
    rows = pd.read_csv(table).set_index("quantity")
    shown = re.findall(r"^\| (.+) \| (-?[\d.]+) ± ([\d.e-]+) \|$", readme, re.MULTILINE)
    assert shown
    for quantity, value, error in shown:
        computed, stated = rows.loc[quantity, ["computed", "numerical error"]]
        assert abs(float(value) - computed) <= float(error), quantity
        digit = 10.0 ** -len(value.partition(".")[2])
        assert stated <= float(error) <= max(2.0 * stated, 1.01 * digit), quantity


def wait_for_job(process, name):
    """The process of a running job, whose command line holds `name`."""
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        for child in psutil.Process(process.pid).children(recursive=True):
            with contextlib.suppress(psutil.NoSuchProcess):
                if any(name in word for word in child.cmdline()):
                    return child
        time.sleep(0.1)
    raise AssertionError(f"{name} did not start.")
