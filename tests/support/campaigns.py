"""Small campaigns, and what their tests share."""

import json
from pathlib import Path

import numpy as np
import pytest

from granular_fronts.campaign import chunks, definition, merging
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import write_dataset

ROOT = Path(__file__).parents[2]
CHAINS = {
    "kind": "chain",
    "axes": {"delta": [0.1, 1.0], "gamma": [0.1, 0.3, 0.8]},
    "fixed": {"alpha": 1.5, "beads": 30},
    "tolerance": 1.0e-7,
}


def campaign(given=CHAINS, **changes):
    return definition.check_campaign({**given, **changes}, "mine")


def refusal(given=CHAINS, **changes):
    with pytest.raises(InputError) as caught:
        campaign(given, **changes)
    assert str(caught.value).startswith("Campaign mine: ")
    return str(caught.value)


def all_chunks(asked, chunk_points):
    return list(chunks.cut(asked, np.ones(asked.shape, dtype=bool), chunk_points))


def solved_points(asked):
    """What a campaign of a single chunk solves."""
    [chunk] = all_chunks(asked, asked.size)
    return KINDS[chunk.kind].solve_chunk(chunk.points(), chunk.settings)


def solve(chunk, folder):
    """Solve a chunk as the workflow does."""
    solved = KINDS[chunk.kind].solve_chunk(chunk.points(), chunk.settings)
    chunks.write_request(chunk, folder)
    file = folder / f"{chunk.name}.nc"
    data = merging.chunk_dataset(chunk, solved, 1.0)
    write_dataset(data, file, scene_id=chunk.name, config=json.loads(chunk.as_json()))
    return file


def pretend_solved(asked, folder, chunk_points):
    """Write the request of every chunk and put an empty file in the place of its data."""
    for chunk in chunks.chunks_of(asked, folder, chunk_points).values():
        chunks.write_request(chunk, folder)
        (folder / f"{chunk.name}.nc").touch()
