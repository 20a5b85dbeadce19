"""Put the chunks of a campaign together in one file with its axes as dimensions.

Not by hand: the workflow knows which chunks cover the grid.
"""

from pathlib import Path

from granular_fronts.campaign.definition import check_campaign
from granular_fronts.campaign.merging import merge_chunks
from granular_fronts.output.datasets import write_dataset
from job import job


def merge_campaign(chunks: list[str], campaign: dict, name: str, dataset: str) -> None:
    """Merge solved chunks and write the grid.

    Parameters
    ----------
    chunks : list of str
        Files of the chunks.
    campaign : dict
        The campaign, as its file holds it.
    name : str
        Its name.
    dataset : str
        The netCDF file to write.
    """
    merged = merge_chunks(check_campaign(campaign, name), [Path(chunk) for chunk in chunks])
    write_dataset(merged, dataset, scene_id=name, config=campaign)


if __name__ == "__main__":
    with job(snakemake):
        merge_campaign(
            snakemake.input.chunks,
            snakemake.params.campaign,
            snakemake.wildcards.campaign,
            snakemake.output.dataset,
        )
