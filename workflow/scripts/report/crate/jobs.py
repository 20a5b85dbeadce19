"""The jobs behind some results, from the records that Snakemake keeps of what it made.

Of each file that a job made Snakemake keeps rule, inputs, log file, start and end in the folder
``.snakemake``.  Followed from the results back along the inputs, these records name every job of a
run, with what it read and wrote.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from snakemake.io import IOFile
from snakemake.persistence import MetadataRecord
from snakemake.persistence.file import FilePersistence


@dataclass(frozen=True)
class Job:
    """One job that has run: a script with its inputs and outputs."""

    rule: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    log: str
    start: datetime
    end: datetime


def jobs_behind(files: Iterable[str], results: Path) -> list[Job]:
    """Find the jobs that made some files, and those that made what these were made from."""
    records = FilePersistence(nolock=True)
    made: dict[str, dict[str, MetadataRecord]] = {}
    waiting, seen = set(files), set()
    while waiting:
        seen |= waiting
        found = {file: records.metadata(IOFile(file)) for file in waiting}
        waiting = set()
        for file, record in found.items():
            if record:
                made.setdefault(record.log[0], {})[file] = record
                waiting.update(record.input)
            elif _is_made_by_a_job(file, results):
                raise ValueError(
                    f"Snakemake has no record of how {file} was made: remove {results} and run "
                    "the workflow again."
                )
        waiting -= seen
    jobs = (_job_of(log, outputs) for log, outputs in made.items())
    return sorted(jobs, key=lambda job: (job.start, job.log))


def _job_of(log: str, outputs: dict[str, MetadataRecord]) -> Job:
    """Put together what the records of its outputs say of a job; each job has a log of its own."""
    records = outputs.values()
    return Job(
        rule=next(record.rule for record in records),
        inputs=tuple(sorted({file for record in records for file in record.input})),
        outputs=tuple(sorted(outputs)),
        log=log,
        start=_moment(min(record.starttime for record in records)),
        end=_moment(max(record.endtime for record in records)),
    )


def _is_made_by_a_job(file: str, results: Path) -> bool:
    """Whether a file is a job's output; of run times Snakemake keeps no record."""
    path = Path(file)
    return path.is_relative_to(results) and not path.is_relative_to(results / "benchmarks")


def _moment(seconds: float) -> datetime:
    """A time as Snakemake counts it, to the second."""
    return datetime.fromtimestamp(round(seconds), tz=UTC)
