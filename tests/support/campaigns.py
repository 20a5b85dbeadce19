"""Small campaigns of every kind, and what their tests share."""

import json
from pathlib import Path

import numpy as np

from granular_fronts.campaign import chunks, definition, merging
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.output.datasets import write_dataset

ROOT = Path(__file__).parents[2]
CHAINS = {
    "kind": "chain",
    "axes": {"delta": [0.1, 1.0], "gamma": [0.1, 0.3, 0.8]},
    "fixed": {"alpha": 1.5, "beads": 30},
    "tolerance": 1.0e-7,
}
FRONTS = {"kind": "front", "axes": {"alpha": [1.3, 1.5], "gamma": [0.1, 0.2, 0.6]}}
TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
CHAINS_OF_A_LAW = {
    "kind": "chain",
    "law": TODA,
    "axes": {"law.elastic.rate": [0.5, 1.0], "delta": [0.1, 0.5]},
    "fixed": {"beads": 30},
    "tolerance": 1e-8,
    "record": {"scalars": ["front_speed", "overshoot", "first_gap_time", "largest_overshoot"]},
}
FRONTS_OF_A_LAW = {
    "kind": "front",
    "law": TODA,
    "axes": {"law.elastic.rate": [0.5, 1.0], "damping": [0.5, 1.0]},
    "fixed": {"behind": -2.0},
    "record": {"profile": {"start": -2, "stop": 2, "count": 5}},
}
PULSE = {"half_length": 8.1, "half_width": 2, "base": 0.2}
RINGS = {
    "kind": "ring",
    "start": {"profile": "pulse"},
    "axes": {"alpha": [1.1, 1.2], "slow_time": [0.2, 0.5]},
    "fixed": {"damping": 0.5, **PULSE},
    "tolerance": 1.0e-6,
}
SCENE = {
    "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0},
    "beads": {"count": 20, "mass": {"cell": [1, 1]}},
    "boundary": {"kind": "pressure", "left": 0, "right": 0},
    "start": {"kind": "striker", "beads": 1, "velocity": 1},
    "end_time": 30,
    "tolerance": {"relative": 1.0e-8, "absolute": 1.0e-10},
    "record": {
        "snapshots": [],
        "sensors": {"far": {"contacts": [5, 15], "start": 0, "stop": 30, "step": 0.1}},
    },
}
RATIOS = {"kind": "motion", "scene": SCENE, "axes": {"beads.mass.cell.2": [0.3, 1.0]}}


def campaign(given=CHAINS, **changes):
    """A campaign with other keys; an ellipsis takes one away."""
    changed = {key: value for key, value in {**given, **changes}.items() if value is not ...}
    return definition.check_campaign(changed, "mine")


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


def merged(asked, folder, chunk_points):
    """The grid of a campaign, solved in chunks."""
    files = [solve(chunk, folder) for chunk in all_chunks(asked, chunk_points)]
    return merging.merge_chunks(asked, files)


def pretend_solved(asked, folder, chunk_points):
    """Write the request of every chunk and put an empty file in the place of its data."""
    for chunk in chunks.chunks_of(asked, folder, chunk_points).values():
        chunks.write_request(chunk, folder)
        (folder / f"{chunk.name}.nc").touch()
