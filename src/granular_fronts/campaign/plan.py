"""The plan of a campaign: which chunks it consists of, and how far their jobs have come.

The plan is a small file beside the chunks.  The workflow reads from it which jobs there are, and
every job that ends says how much is left.
"""

import json
import os
from pathlib import Path
from typing import NamedTuple

from granular_fronts.output.files import complete_file, read_json


class Plan(NamedTuple):
    """The chunks of a campaign.

    Attributes
    ----------
    points : int
        Size of the grid.
    solved : list of str
        Names of the chunks that were solved when the plan was made.
    missing : dict of str to int
        Names of all others, with their numbers of points.
    """

    points: int
    solved: list[str]
    missing: dict[str, int]

    @property
    def chunks(self) -> list[str]:
        """Names of all chunks, solved ones first."""
        return [*self.solved, *self.missing]


def write_plan(plan: Plan, file: Path) -> None:
    """Write a plan."""
    with complete_file(file) as unfinished:
        unfinished.write_text(json.dumps(plan._asdict()) + "\n", encoding="utf-8")


def read_plan(file: Path | str) -> Plan:
    """Read a plan."""
    return Plan(**read_json(file))


def describe_progress(file: Path, seconds_per_point: float) -> str:
    """Points and chunks that are solved, and what is left, as one line.

    Parameters
    ----------
    file : Path
        The plan; the chunks lie beside it.
    seconds_per_point : float
        Processor time of the points solved last.

    Returns
    -------
    str
    """
    plan = read_plan(file)
    with os.scandir(file.parent) as entries:
        done = {entry.name.removesuffix(".nc") for entry in entries if entry.name.endswith(".nc")}
    left = sum(size for name, size in plan.missing.items() if name not in done)
    solved_chunks = len(plan.solved) + len(done.intersection(plan.missing))
    return (
        f"Campaign {file.parent.name}: {plan.points - left:,} of {plan.points:,} points, "
        f"{solved_chunks:,} of {len(plan.chunks):,} chunks, "
        f"{_duration(left * seconds_per_point)} of processor time left."
    )


def _duration(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes:02d} min" if hours else f"{minutes} min {rest:02d} s"
