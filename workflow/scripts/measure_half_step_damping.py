"""Excess damping that the step of discrete-element codes brings into a front.

python workflow/scripts/measure_half_step_damping.py \
    --scene config/default.yaml:laws.half_step_damping --dataset half_step_damping.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.half_step_damping import measure_half_step_damping as measure
from step import run_step


def measure_half_step_damping(scene: dict, dataset: Path) -> None:
    """Compare the half-step scheme with accurate chains, over law, damping and step.

    Parameters
    ----------
    scene : dict
        Chain, laws and steps as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(measure(scene), dataset, scene_id="half_step_damping", config=scene)


if __name__ == "__main__":
    run_step(measure_half_step_damping, globals().get("snakemake"))
