"""Make the dataset of a study."""

from importlib import import_module
from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from step import run_step


def study(section: dict, dataset: Path, module: str, function: str) -> None:
    """Compute a study and write its data.

    Parameters
    ----------
    section : dict
        Its part of the configuration, the arguments of its function.
    dataset : Path
        The netCDF file to write, of the study's name.
    module, function : str
        What computes it, in the package.
    """
    computed = getattr(import_module(f"granular_fronts.{module}"), function)(**section)
    write_dataset(computed, dataset, scene_id=dataset.stem, config=section)


if __name__ == "__main__":
    run_step(study, globals()["snakemake"])
