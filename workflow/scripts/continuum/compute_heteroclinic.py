"""Heteroclinic orbits of the logarithmic KdV–Burgers equation, James (2021), equation (56)."""

from pathlib import Path

from granular_fronts.continuum.log_kdv_burgers.survey import survey_heteroclinic
from granular_fronts.output.datasets import write_dataset
from step import run_step


def compute_heteroclinic(scene: dict, scene_id: str, dataset: Path) -> None:
    """Compute the fronts of one scene and write their data.

    Parameters
    ----------
    scene : dict
        The scene, as under ``scenes.heteroclinic`` of the configuration.
    scene_id : str
        Its name.
    dataset : Path
        The netCDF file to write.
    """
    survey = survey_heteroclinic(scene, scene_id)
    write_dataset(survey, dataset, scene_id=scene_id, config=scene)


if __name__ == "__main__":
    run_step(compute_heteroclinic, globals()["snakemake"])
