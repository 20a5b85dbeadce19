"""Make the dataset of a study, one of those that stand above its rule."""

from importlib import import_module
from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from job import job


def study(module: str, function: str, section: dict, dataset: str) -> None:
    """Compute a study and write its data.

    Parameters
    ----------
    module, function : str
        What computes it, in granular_fronts.studies.
    section : dict
        Its part of the configuration, the arguments of the function.
    dataset : str
        The netCDF file to write, named after the study.
    """
    computed = getattr(import_module(f"granular_fronts.studies.{module}"), function)(**section)
    write_dataset(computed, dataset, scene_id=Path(dataset).stem, config=section)


if __name__ == "__main__":
    with job(snakemake):
        study(
            snakemake.params.module,
            snakemake.params.function,
            snakemake.params.section,
            snakemake.output.dataset,
        )
