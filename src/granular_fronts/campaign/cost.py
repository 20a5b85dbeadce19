"""What a point costs, measured before a campaign is cut: a chunk must be worth its start-up.

A job starts Python and loads compiled code, one to two seconds.  Pieces of lines are solved and
timed in processor time: short ones first, then such that all take about `SAMPLE_SECONDS`, since a
solver that goes from point to point is faster on long pieces.  They lie in the middle of equal
shares of the lines and of the fast axis, so that their mean estimates that of the grid.  The answer
is kept beside the chunks, and the same campaign is measured once.
"""

import hashlib
import itertools
import json
import math
import sys
import time
from pathlib import Path

import numpy as np

from granular_fronts.campaign.chunks import Chunk
from granular_fronts.campaign.definition import Campaign
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.output.files import complete_file, read_json

PIECES, FIRST_LENGTH = 3, 3
"""Pieces along each of the two directions, across lines and along them, and their first length."""

SAMPLE_SECONDS = 2.0


def seconds_per_point(campaign: Campaign, folder: Path) -> float:
    """Processor time of one point, measured once for a campaign as it stands.

    Parameters
    ----------
    campaign : Campaign
    folder : Path
        Where the answer is kept, in ``cost.json``.

    Returns
    -------
    float
    """
    asked = json.dumps([campaign.kind_name, campaign.settings, campaign.grid], sort_keys=True)
    digest = hashlib.sha256(asked.encode()).hexdigest()[:16]
    file = folder / "cost.json"
    if file.exists():
        known = read_json(file)
        if known["campaign"] == digest:
            return known["seconds_per_point"]
    print(f"Campaign {campaign.name}: measuring what a point costs.", file=sys.stderr)
    seconds = measure(campaign)
    with complete_file(file) as unfinished:
        known = {"campaign": digest, "seconds_per_point": seconds}
        unfinished.write_text(json.dumps(known) + "\n", encoding="utf-8")
    return seconds


def measure(campaign: Campaign) -> float:
    """Solve a sample of a campaign and return the processor time of one of its points."""
    # The first time code is compiled and caches are filled, which a chunk does once.
    time_sample(sample_of(campaign, 1))
    seconds = time_sample(sample_of(campaign, FIRST_LENGTH))
    length = round(SAMPLE_SECONDS / (PIECES**2 * seconds))
    return time_sample(sample_of(campaign, length)) if length > FIRST_LENGTH else seconds


def time_sample(sample: list[Chunk]) -> float:
    """Solve pieces and return the processor time of a point."""
    start = time.process_time()
    for chunk in sample:
        KINDS[chunk.kind].solve_chunk(chunk.points(), chunk.settings, "measuring the cost")
    return (time.process_time() - start) / sum(chunk.size for chunk in sample)


def sample_of(campaign: Campaign, length: int) -> list[Chunk]:
    """Pieces of lines, of at most the given length, in the middle of equal shares of the grid."""
    *slow, fast = campaign.grid
    shape, values = campaign.shape, campaign.grid[fast]
    lines = math.prod(shape[:-1])
    shares = (np.arange(PIECES) + 0.5) / PIECES
    sample = []
    for across, along in itertools.product(shares, shares):
        line = np.unravel_index(int(across * lines), shape[:-1]) if slow else ()
        columns = {
            name: [campaign.grid[name][position]] for name, position in zip(slow, line, strict=True)
        }
        first = max(0, min(round(along * len(values) - length / 2), len(values) - length))
        piece = {fast: list(values[first : first + length])}
        sample.append(Chunk(campaign.kind_name, campaign.settings, columns, piece))
    return sample


def points_per_chunk(cost: float, chunk_seconds: float) -> int:
    """Most points of a chunk that take the wanted time at a cost of so many seconds each."""
    return max(1, round(chunk_seconds / cost))
