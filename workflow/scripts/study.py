"""Make the dataset of a study, one of those that workflow/studies.yaml lists.

python workflow/scripts/study.py --study materials
    --section config/default.yaml:laws.materials --dataset materials.nc
"""

from importlib import import_module
from pathlib import Path

from granular_fronts.arguments import choice
from granular_fronts.output.datasets import write_dataset
from granular_fronts.scenes.study import studies
from step import run_step


def study(study: str, section: dict, dataset: Path, function: str | None = None) -> None:
    """Compute a study and write its data.

    Parameters
    ----------
    study : str
        Its name in workflow/studies.yaml.
    section : dict
        Its part of the configuration, the arguments of its function.
    dataset : Path
        The netCDF file to write.
    function : str, optional
        Place of what computes it, as that list names it by default; other lists may give another.
    """
    if function is None:
        function = studies()[choice("a study", study, list(studies()))]["function"]
    module, _, name = function.rpartition(".")
    computed = getattr(import_module(module), name)(**section)
    write_dataset(computed, dataset, scene_id=study, config=section)


if __name__ == "__main__":
    run_step(study, globals().get("snakemake"))
