"""Count what the workflow's jobs ran as lines of their scripts.

Snakemake runs a copy of each script with three lines before it, in a file that it removes:
``.snakemake/scripts/tmp….NAME.py``.  After ``coverage combine``, this adds what was seen of the
copies to the scripts themselves.
"""

import re
from pathlib import Path

from coverage import Coverage

WORKFLOW = Path(__file__).parents[1] / "workflow"
COPY = re.compile(r".*/\.snakemake/scripts/\w+\.(\w+\.py)")
PREAMBLE = 3


def line_in_script(line):
    """The line of a script from that of its copy; negative where a block is entered or left."""
    if abs(line) > PREAMBLE:
        return line - PREAMBLE if line > 0 else line + PREAMBLE
    return -1


def add_jobs(data):
    """Add the steps from line to line that were seen in copies."""
    for file in data.measured_files():
        if copy := COPY.fullmatch(file):
            steps = {(line_in_script(a), line_in_script(b)) for a, b in data.arcs(file)}
            [script] = WORKFLOW.rglob(copy[1])
            data.add_arcs({str(script): steps - {(-1, -1)}})


if __name__ == "__main__":
    measured = Coverage()
    measured.load()
    add_jobs(measured.get_data())
