"""Where everything lies, and what several wings share."""

import hashlib
import os
import sys
from glob import glob
from pathlib import Path

SOURCE = os.path.join(workflow.basedir, "src")

# The package and its compiled kernels are found without an installation, here and by the jobs.
sys.path.insert(0, SOURCE)
os.environ.update(
    PYTHONPATH=os.pathsep.join(filter(None, [SOURCE, os.environ.get("PYTHONPATH")])),
    NUMBA_CACHE_DIR=os.path.join(workflow.basedir, ".numba_cache"),
)


wildcard_constraints:
    scene="[a-z][a-z0-9_]*",


def modules(*names):
    """Return the files of the package that a stage stands on, each name a file or a pattern.

    Snakemake sees that a script has changed, but not what the script imports.
    """
    return [
        os.path.relpath(file, workflow.basedir)
        for name in names
        for file in sorted(glob(os.path.join(SOURCE, "granular_fronts", name)))
    ]


def contents(files):
    """Return a digest of what files hold, so that a stage notices when files change that no rule makes for it."""
    digest = hashlib.sha256()
    for file in files:
        with open(file, "rb") as opened:
            digest.update(opened.read())
    return digest.hexdigest()
