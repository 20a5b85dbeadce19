"""Paths of all files, and functions that several rules share."""

import hashlib
import os
import sys
from functools import cache
from glob import glob
from pathlib import Path

PROJECT = workflow.basedir
SOURCE = os.path.join(PROJECT, "src")
LIBRARY = os.path.join(PROJECT, "workflow", "lib")
SCRIPTS = os.path.join(PROJECT, "workflow", "scripts")
DRAWING = os.path.join(SCRIPTS, "figures")
# Each paper of others has its own scripts.
PAPERS = sorted(glob(os.path.join(PROJECT, "papers", "*", "")))

# The package and its compiled kernels are found without an installation, here and by the jobs.
sys.path[:0] = [SOURCE, LIBRARY]
# Jobs start in this folder. Relative paths hold no colon, at which PYTHONPATH would be cut.
PATHS = map(os.path.relpath, [SOURCE, LIBRARY, DRAWING, *PAPERS])
os.environ.update(
    PYTHONPATH=os.pathsep.join(filter(None, [*PATHS, os.environ.get("PYTHONPATH")])),
    NUMBA_CACHE_DIR=os.path.join(PROJECT, ".numba_cache"),
    # A notebook hands its child processes a backend that the pinned packages lack.
    MPLBACKEND="agg",
    # Pydantic would look for plugins in every installed package, at each start of a job.
    PYDANTIC_DISABLE_PLUGINS="__all__",
)

# Snakemake starts its jobs by this name, without quotation marks.
if " " in sys.executable:
    sys.exit(
        f"Snakemake starts no job by {sys.executable}, since there is a blank in this path: move "
        "the folder, or make the environment elsewhere."
    )

# Of an option that is given twice Snakemake drops the first, without a word.
for names, form in (
    (("--configfile", "--configfiles"), "--configfile a.yaml b.yaml"),
    (("--config", "-C"), "--config results=results/mine campaign=smoke"),
):
    if sum(word.partition("=")[0] in names for word in sys.argv) > 1:
        sys.exit(f"{names[0]} is given twice, but Snakemake reads only the last: write {form}.")

from granular_fronts.numerics.source_code import code_digest
from granular_fronts.numerics.imports import import_closure, module_files

MODULES = module_files(
    *map(Path, [SOURCE, LIBRARY, SCRIPTS, *sorted(glob(os.path.join(SCRIPTS, "*", ""))), *PAPERS])
)
# It hands a script what the rule names, and has no part in what comes out.
del MODULES["step"]


def script_file(name):
    """Return the path of a script from this folder, for a rule that a loop makes."""
    return os.path.relpath(MODULES[name], os.path.join(PROJECT, "workflow", "rules"))


# Of a timing, which must run alone: Snakemake cuts it down to the cores of the call.
ALL_CORES = os.cpu_count()


@cache
def digest_of(*names):
    """Return a digest of the code of some modules and of all that these import."""
    files = [MODULES[name] for name in import_closure(names, MODULES)]
    return code_digest(files, Path(PROJECT))


def code(*names):
    """Return a function for `params`: a digest of what a script and all that it imports do.

    A job is repeated when this code changes, and not for a docstring or a comment. What a script
    imports by a string is named after it, with wildcards. Nothing is read before a job is planned.
    """
    return lambda wildcards: digest_of(*(name.format(wildcards=wildcards) for name in names))


def contents(files):
    """Return a digest of what files hold, so that a stage notices when files change that no rule makes for it."""
    digest = hashlib.sha256()
    for file in files:
        with open(file, "rb") as opened:
            digest.update(opened.read())
    return digest.hexdigest()
