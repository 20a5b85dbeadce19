"""The list of a campaign's chunks, made before any job; and how far its jobs have come.

Planning writes small files only: the requests of the chunks that are missing, what a point costs,
and the plan itself, from which every job that ends can tell how much is left.
"""

import json
import os
import time
from collections.abc import Mapping
from pathlib import Path

from granular_fronts.campaign.chunks import claim_folder, cut, find_missing, write_request
from granular_fronts.campaign.cost import points_per_chunk, seconds_per_point
from granular_fronts.campaign.definition import MOST_POINTS, Campaign, check_points
from granular_fronts.files import complete_file

PLAN = "plan.json"


def plan_campaign(campaign: Campaign, folder: Path, chunk_seconds: float) -> list[str]:
    """Say which chunks a campaign consists of, and write the requests of those not yet solved.

    Parameters
    ----------
    campaign : Campaign
    folder : Path
        Its folder of chunks.
    chunk_seconds : float
        Processor time that a new chunk should take.

    Returns
    -------
    list of str
        Names of the chunks, solved ones first.

    Raises
    ------
    ConfigurationError
        If the folder holds another campaign, or the campaign is too large to be meant.
    """
    claim_folder(campaign, folder)
    if campaign.size > MOST_POINTS:
        check_points(campaign, seconds_per_point(campaign, folder))
    solved, missing = find_missing(campaign, folder)
    if not missing.any():
        return solved
    cost = seconds_per_point(campaign, folder)
    chunks = {}
    for chunk in cut(campaign, missing, points_per_chunk(campaign, cost, chunk_seconds)):
        write_request(chunk, folder)
        chunks[chunk.name] = chunk.size
    plan = {"chunks": chunks, "points": campaign.size, "missing": int(missing.sum())}
    with complete_file(folder / PLAN) as unfinished:
        unfinished.write_text(json.dumps(plan), encoding="utf-8")
    return [*solved, *chunks]


def tell_progress(folder: Path) -> str:
    """Points done, rate and time left of the campaign in a folder, as one line.

    Parameters
    ----------
    folder : Path
        Its folder of chunks, with the plan of the call that is running.

    Returns
    -------
    str
    """
    plan = json.loads((folder / PLAN).read_text(encoding="utf-8"))
    sizes: Mapping[str, int] = plan["chunks"]
    with os.scandir(folder) as entries:
        done = [sizes[name] for name in _chunk_names(entries) if name in sizes]
    seconds = max(time.time() - (folder / PLAN).stat().st_mtime, 1e-9)
    rate = sum(done) / seconds
    left = plan["missing"] - sum(done)
    known = plan["points"] - left
    return (
        f"Campaign {folder.name}: {known:,} of {plan['points']:,} points, {len(done):,} of "
        f"{len(sizes):,} chunks, {rate:,.0f} points/s, {_duration(left / rate)} left."
    )


def _chunk_names(entries):
    return [entry.name.removesuffix(".nc") for entry in entries if entry.name.endswith(".nc")]


def _duration(seconds):
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes:02d} min" if hours else f"{minutes} min {rest:02d} s"
