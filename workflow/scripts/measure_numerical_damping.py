"""Damping that the theta-method brings into a conservative chain; James (2021), section 1.

python workflow/scripts/measure_numerical_damping.py \
    --scene config/default.yaml:laws.numerical_damping --dataset numerical_damping.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.numerical_damping import Case, compare_profiles, measure_order
from step import run_step


def measure_numerical_damping(scene: dict, dataset: Path) -> None:
    """Compare the θ-method with chains of the damping it stands for.

    Parameters
    ----------
    scene : dict
        Chain, steps and values of θ as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    law = scene["alpha"], scene["displacement"]
    order, profile = scene["order"], scene["profile"]
    distances = measure_order(
        Case(*law, order["beads"], order["end_time"]), order["thetas"], order["steps"]
    )
    profiles = compare_profiles(
        Case(*law, profile["beads"], profile["end_time"]), profile["theta"], profile["step"]
    )
    measured = distances.merge(profiles)
    write_dataset(measured, dataset, scene_id="numerical_damping", config=scene)


if __name__ == "__main__":
    run_step(measure_numerical_damping, globals().get("snakemake"))
