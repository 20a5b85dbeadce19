"""Make the dataset of a project by a function of its folder."""

import sys
from importlib import import_module
from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from job import job


def project_study(project: str, made_by: str, settings: dict, dataset: str) -> None:
    """Compute a dataset and write it.

    Parameters
    ----------
    project : str
        The project, whose folder has the module.
    made_by : str
        What computes it, `module.function`.
    settings : dict
        The arguments of the function.
    dataset : str
        The netCDF file to write, named after the dataset.
    """
    sys.path.append(f"projects/{project}")
    module, _, function = made_by.partition(".")
    computed = getattr(import_module(module), function)(**settings)
    write_dataset(computed, dataset, scene_id=Path(dataset).stem, config=settings)


if __name__ == "__main__":
    with job(snakemake):
        project_study(
            snakemake.wildcards.study.partition("/")[0],
            snakemake.params.made_by,
            snakemake.params.settings,
            snakemake.output.dataset,
        )
