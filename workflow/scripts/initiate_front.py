"""Move a chain as James (2021), equations (31) and (32), and keep what its scene records."""

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output.datasets import write_dataset
from job import job


def initiate_front(scene: dict, scene_id: str, dataset: str) -> None:
    """Solve one scene and write its data.

    Parameters
    ----------
    scene : dict
        The scene, as under ``scenes.chain`` of the configuration.
    scene_id : str
        Its name.
    dataset : str
        The netCDF file to write.
    """
    write_dataset(simulate_chain(scene, scene_id), dataset, scene_id=scene_id, config=scene)


if __name__ == "__main__":
    with job(snakemake):
        initiate_front(snakemake.params.scene, snakemake.wildcards.scene, snakemake.output.dataset)
