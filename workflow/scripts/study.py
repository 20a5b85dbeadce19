"""Make the dataset of a study, one of those that workflow/studies.yaml or a paper lists."""

from importlib import import_module
from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from step import run_step


def study(study: str, section: dict, dataset: Path, function: str) -> None:
    """Compute a study and write its data.

    Parameters
    ----------
    study : str
        Its name in the list.
    section : dict
        Its part of the configuration, the arguments of its function.
    dataset : Path
        The netCDF file to write.
    function : str
        Place of what computes it.
    """
    module, _, name = function.rpartition(".")
    computed = getattr(import_module(module), name)(**section)
    write_dataset(computed, dataset, scene_id=study, config=section)


if __name__ == "__main__":
    run_step(study, globals()["snakemake"])
