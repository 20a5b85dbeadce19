"""Heteroclinic orbits of the logarithmic KdV–Burgers equation, James (2021), equation (56)."""

from granular_fronts.continuum.log_kdv_burgers.survey import survey_heteroclinic
from granular_fronts.output.datasets import write_dataset
from job import job


def compute_heteroclinic(scene: dict, scene_id: str, dataset: str) -> None:
    """Compute the fronts of one scene and write their data.

    Parameters
    ----------
    scene : dict
        The scene, as under ``scenes.heteroclinic`` of the configuration.
    scene_id : str
        Its name.
    dataset : str
        The netCDF file to write.
    """
    survey = survey_heteroclinic(scene, scene_id)
    write_dataset(survey, dataset, scene_id=scene_id, config=scene)


if __name__ == "__main__":
    with job(snakemake):
        compute_heteroclinic(
            snakemake.params.scene, snakemake.wildcards.scene, snakemake.output.dataset
        )
