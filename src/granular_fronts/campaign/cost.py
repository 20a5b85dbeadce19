"""What a point costs, measured before a campaign is cut: a chunk must be worth its start-up.

A job starts Python and loads compiled code, one to two seconds.  Short pieces of lines are solved
twice, and timed in processor time the second time.  They lie in the middle of equal shares of the
lines and of the fast axis, so that their mean estimates that of the grid.  The answer is kept
beside the chunks, and the same campaign is measured once.
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
from granular_fronts.files import complete_file

PIECES, PIECE = 3, 3
"""Pieces along each of the two directions, across lines and along them, and their length."""


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
        known = json.loads(file.read_text(encoding="utf-8"))
        if known["campaign"] == digest:
            return known["seconds_per_point"]
    print(f"Campaign {campaign.name}: measuring what a point costs.", file=sys.stderr)
    seconds = measure(campaign)
    with complete_file(file) as unfinished:
        known = {"campaign": digest, "seconds_per_point": seconds}
        unfinished.write_text(json.dumps(known) + "\n", encoding="utf-8")
    return seconds


def measure(campaign: Campaign) -> float:
    """Solve a sample of a campaign twice; return the processor time of a point the second time."""
    sample = sample_of(campaign)
    for _ in ("compiling and filling caches, which a chunk does once", "measuring"):
        start = time.process_time()
        for chunk in sample:
            campaign.kind.solve_chunk(chunk.points(), chunk.settings)
        seconds = time.process_time() - start
    return seconds / sum(chunk.size for chunk in sample)


def sample_of(campaign: Campaign) -> list[Chunk]:
    """Pieces of lines in the middle of equal shares of the grid."""
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
        start = max(0, min(round(along * len(values) - PIECE / 2), len(values) - PIECE))
        piece = {fast: list(values[start : start + PIECE])}
        sample.append(Chunk(campaign.kind_name, campaign.settings, columns, piece))
    return sample


def points_per_chunk(campaign: Campaign, cost: float, chunk_seconds: float) -> int:
    """Most points of a chunk: those of the campaign file, or those that fill the wanted time."""
    return campaign.chunk_points or max(1, round(chunk_seconds / cost))
