"""Compare a ring of beads with its amplitude equations; James (2021), section 4.3."""

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.ring_against_equations import compare_with_chain
from job import job


def compare_periodic_chain(scene: dict, scene_id: str, dataset: str) -> None:
    """Solve one scene as a chain and by its equations, and write all of it.

    Parameters
    ----------
    scene : dict
        The scene, as under ``scenes.periodic`` of the configuration.
    scene_id : str
        Its name.
    dataset : str
        The netCDF file to write.
    """
    solved = compare_with_chain(scene, scene_id)
    write_dataset(solved, dataset, scene_id=scene_id, config=scene)


if __name__ == "__main__":
    with job(snakemake):
        compare_periodic_chain(
            snakemake.params.scene, snakemake.wildcards.scene, snakemake.output.dataset
        )
