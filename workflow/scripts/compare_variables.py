"""Smoothness, order and conservation in (x, w) and in (x, velocity); James (2021), section 3.2.

python workflow/scripts/compare_variables.py \
    --scene config/default.yaml:laws.choice_of_variables --dataset variables.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.choice_of_variables import compare_variables as compare
from step import run_step


def compare_variables(scene: dict, dataset: Path) -> None:
    """Compare the two choices of variables.

    Parameters
    ----------
    scene : dict
        Exponents and damping as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(compare(**scene), dataset, scene_id="choice_of_variables", config=scene)


if __name__ == "__main__":
    run_step(compare_variables, globals().get("snakemake"))
