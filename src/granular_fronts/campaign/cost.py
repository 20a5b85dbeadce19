"""What a point costs, measured before a campaign is cut: a chunk must be worth its start-up.

A job starts Python and loads compiled code, one to two seconds.  A few short pieces of lines,
spread over the grid, are solved and timed in processor time, after one piece that compiles.  The
answer is kept beside the chunks, so that the same campaign is measured once.
"""

import hashlib
import json
import math
import sys
import time
from pathlib import Path

import numpy as np

from granular_fronts.campaign.chunks import Chunk
from granular_fronts.campaign.definition import Campaign
from granular_fronts.files import complete_file

PIECES, PIECE = 4, 8
"""Number of pieces of lines that are timed, and their length."""


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
    """Solve a sample of a campaign and return the processor time of one of its points."""
    sample = sample_of(campaign)
    first = sample[0]
    campaign.kind.solve_chunk(first.points(), first.settings)
    start = time.process_time()
    for chunk in sample:
        campaign.kind.solve_chunk(chunk.points(), chunk.settings)
    return (time.process_time() - start) / sum(chunk.size for chunk in sample)


def sample_of(campaign: Campaign) -> list[Chunk]:
    """Pieces of lines spread over the grid, from its first corner to its last."""
    *slow, fast = campaign.grid
    shape, values = campaign.shape, campaign.grid[fast]
    lines = math.prod(shape[:-1])
    sample = []
    for share in np.linspace(0.0, 1.0, PIECES):
        line = np.unravel_index(round(share * (lines - 1)), shape[:-1])
        columns = {
            name: [campaign.grid[name][position]] for name, position in zip(slow, line, strict=True)
        }
        start = round(share * max(len(values) - PIECE, 0))
        piece = {fast: list(values[start : start + PIECE])}
        sample.append(Chunk(campaign.kind_name, campaign.settings, columns, piece))
    return sample


def points_per_chunk(campaign: Campaign, cost: float, chunk_seconds: float) -> int:
    """Most points of a chunk: those of the campaign file, or those that fill the wanted time."""
    return campaign.chunk_points or max(1, round(chunk_seconds / cost))
