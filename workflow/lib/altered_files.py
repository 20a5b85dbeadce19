"""Files that are no longer as their job left them: edited, cut, or put there from elsewhere.

Snakemake itself takes any file that is younger than its inputs for the one that it made.
"""

import os
from typing import Any

from snakemake.persistence import ParamsChange
from snakemake.persistence.file import FilePersistence

MARGIN = 2.0
"""Seconds by which an archive or a file system may round the time of a file."""


def make_altered_files_again() -> None:
    """Let Snakemake repeat a job whose files are altered, as one whose parameters have changed."""
    params_changed = FilePersistence.params_changed

    def changed(self: Any, job: Any, file: Any = None) -> Any:
        altered = {path for path in job.output if is_altered(path, self.metadata(path))}
        if job.benchmark and _is_empty(job.benchmark):
            altered.add(job.benchmark)
        found = params_changed(self, job, file)
        return found | ParamsChange(only_new=altered, files=altered) if altered else found

    FilePersistence.params_changed = changed


def is_altered(path: str, metadata: Any) -> bool:
    """Return whether the time of a file is not the one that was noted when its job had ended."""
    if metadata is None or metadata.endtime is None or not os.path.exists(path):
        return False
    return abs(os.stat(path).st_mtime - metadata.endtime) > MARGIN


def _is_empty(path: str) -> bool:
    """Return whether there is a file with nothing in it."""
    return os.path.exists(path) and os.path.getsize(path) == 0
