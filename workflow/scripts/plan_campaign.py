"""Plan a campaign: measure what a point costs, and write requests for the chunks that are missing.

python workflow/scripts/plan_campaign.py --name mine --chunk_seconds 20
    --campaign '{kind: heteroclinic, axes: {mu: [0.3, 1, 3]}}' --plan mine/plan.json
"""

from pathlib import Path

from granular_fronts.campaign import planning
from granular_fronts.campaign.definition import check_campaign
from granular_fronts.campaign.plan import write_plan
from step import run_step


def plan_campaign(campaign: dict, name: str, chunk_seconds: float, plan: Path) -> None:
    """Write the plan of a campaign, and beside it the requests of its missing chunks.

    Parameters
    ----------
    campaign : dict
        The campaign, as its file holds it.
    name : str
        Its name.
    chunk_seconds : float
        Processor time that a new chunk should take, in seconds above 0.
    plan : Path
        The JSON file to write, in the campaign's folder of chunks.
    """
    asked = check_campaign(campaign, name)
    write_plan(planning.plan_campaign(asked, plan.parent, chunk_seconds), plan)


if __name__ == "__main__":
    run_step(plan_campaign, globals().get("snakemake"))
