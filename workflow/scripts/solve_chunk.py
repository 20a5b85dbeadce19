"""Solve the points of one chunk of a campaign, in one process, with the compiled kernels.

python workflow/scripts/solve_chunk.py
    --request results/data/campaigns/smoke/0123456789abcdef.json --dataset 0123456789abcdef.nc
"""

import json
import sys
import time
from contextlib import suppress
from pathlib import Path

from granular_fronts.campaign.chunks import read_request
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.merging import chunk_dataset
from granular_fronts.campaign.plan import describe_progress
from granular_fronts.output.datasets import write_dataset
from step import run_step


def solve_chunk(request: Path, dataset: Path) -> None:
    """Solve a chunk and write its data; points that fail carry their reason in the file.

    Parameters
    ----------
    request : Path
        Kind, settings and points, as written when the campaign is planned.
    dataset : Path
        The netCDF file to write.
    """
    chunk = read_request(request)
    activity = f"campaign {request.parent.name}, chunk {request.stem}, solving"
    start = time.process_time()
    solved = KINDS[chunk.kind].solve_chunk(chunk.points(), chunk.settings, activity)
    seconds = time.process_time() - start
    result = chunk_dataset(chunk, solved, seconds)
    write_dataset(result, dataset, scene_id=request.stem, config=json.loads(chunk.as_json()))
    show_progress(dataset.with_name("plan.json"), seconds / chunk.size)


def show_progress(plan: Path, seconds_per_point: float) -> None:
    """Print how far a campaign has come; whatever goes wrong here, the chunk is solved.

    Parameters
    ----------
    plan : Path
        The plan of the campaign; a chunk that is solved by itself has none.
    seconds_per_point : float
        Processor time of a point.
    """
    with suppress(Exception):
        print(describe_progress(plan, seconds_per_point), file=sys.stderr)


if __name__ == "__main__":
    run_step(solve_chunk, globals().get("snakemake"))
