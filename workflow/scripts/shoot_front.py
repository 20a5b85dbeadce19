"""An exact travelling front by shooting and by its profile equation; James (2021), section 6."""

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.fronts_compared import compare_front
from job import job


def shoot_front(scene: dict, scene_id: str, dataset: str) -> None:
    """Solve the front of one scene by both methods and compare all that approximates it.

    Parameters
    ----------
    scene : dict
        The scene, as under ``scenes.front`` of the configuration.
    scene_id : str
        Its name.
    dataset : str
        The netCDF file to write.
    """
    front = compare_front(scene, scene_id)
    write_dataset(front, dataset, scene_id=scene_id, config=scene)


if __name__ == "__main__":
    with job(snakemake):
        shoot_front(snakemake.params.scene, snakemake.wildcards.scene, snakemake.output.dataset)
