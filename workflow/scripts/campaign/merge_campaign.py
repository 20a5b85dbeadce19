"""Put the chunks of a campaign together in one file with its axes as dimensions.

Not by hand: the workflow knows which chunks cover the grid.
"""

from pathlib import Path

from granular_fronts.campaign.definition import check_campaign
from granular_fronts.campaign.merging import merge_chunks
from granular_fronts.output.datasets import write_dataset
from step import run_step


def merge_campaign(chunks: list[Path], campaign: dict, name: str, dataset: Path) -> None:
    """Merge solved chunks and write the grid.

    Parameters
    ----------
    chunks : list of Path
        Files of the chunks.
    campaign : dict
        The campaign, as its file holds it.
    name : str
        Its name.
    dataset : Path
        The netCDF file to write.
    """
    merged = merge_chunks(check_campaign(campaign, name), chunks)
    write_dataset(merged, dataset, scene_id=name, config=campaign)


if __name__ == "__main__":
    run_step(merge_campaign, globals()["snakemake"])
