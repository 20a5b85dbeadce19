"""Solve the points of one chunk of a campaign, in one process, with the compiled kernels.

Not by hand: the workflow cuts the campaign into chunks.
"""

import json
import time
from pathlib import Path

from granular_fronts.campaign.chunks import Chunk, write_request
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.merging import chunk_dataset
from granular_fronts.output.datasets import write_dataset
from job import job


def solve_chunk(request: str, dataset: Path) -> None:
    """Solve a chunk and write its data; points that fail carry their reason in the file.

    Parameters
    ----------
    request : str
        Kind, settings and points as JSON.
    dataset : Path
        The netCDF file to write; the request is written into the same folder.
    """
    chunk = Chunk(**json.loads(request))
    activity = f"campaign {dataset.parent.name}, chunk {chunk.name}, solving"
    start = time.process_time()
    solved = KINDS[chunk.kind].solve_chunk(chunk.points(), chunk.settings, activity)
    result = chunk_dataset(chunk, solved, time.process_time() - start)
    write_request(chunk, dataset.parent)
    write_dataset(result, dataset, scene_id=chunk.name, config=chunk._asdict())


if __name__ == "__main__":
    with job(snakemake):
        solve_chunk(snakemake.params.request, Path(snakemake.output.dataset))
