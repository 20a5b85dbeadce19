"""The chunks of a campaign: those that are solved, and requests for the points that are missing.

Planning is a job.  It writes small files only: the requests of the chunks that are missing, and
what a point costs.  A request that is there keeps its date, so that no chunk is solved twice.
"""

from pathlib import Path

from granular_fronts.campaign.chunks import claim_folder, cut, find_missing, write_request
from granular_fronts.campaign.cost import points_per_chunk, seconds_per_point
from granular_fronts.campaign.definition import MOST_POINTS, Campaign, check_points
from granular_fronts.campaign.plan import Plan
from granular_fronts.output.files import remove_leftovers


def plan_campaign(campaign: Campaign, folder: Path, chunk_seconds: float) -> Plan:
    """Find the chunks a campaign consists of, and write the requests of those not yet solved.

    Parameters
    ----------
    campaign : Campaign
    folder : Path
        Its folder of chunks.
    chunk_seconds : float
        Processor time that a new chunk should take.

    Returns
    -------
    Plan

    Raises
    ------
    InputError
        If the folder holds another campaign, or the campaign is too large to be meant.
    """
    claim_folder(campaign, folder)
    remove_leftovers(folder)
    if campaign.size > MOST_POINTS:
        check_points(campaign, seconds_per_point(campaign, folder))
    solved, missing = find_missing(campaign, folder)
    if not missing.any():
        return Plan(campaign.size, solved, {})
    chunk_points = campaign.chunk_points or points_per_chunk(
        seconds_per_point(campaign, folder), chunk_seconds
    )
    sizes = {}
    for chunk in cut(campaign, missing, chunk_points):
        write_request(chunk, folder)
        sizes[chunk.name] = chunk.size
    return Plan(campaign.size, solved, sizes)
