"""Limits of the theory of fronts and of its continuum limit; James (2021), sections 2 to 4.

python workflow/scripts/measure_limiting_cases.py \
    --scene config/default.yaml:laws.limiting_cases --dataset limits.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.limiting_cases import measure_limiting_cases as measure
from step import run_step


def measure_limiting_cases(scene: dict, dataset: Path) -> None:
    """Measure what happens at the limits of the theory of fronts.

    Parameters
    ----------
    scene : dict
        Chains, states and velocities as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(measure(scene), dataset, scene_id="limiting_cases", config=scene)


if __name__ == "__main__":
    run_step(measure_limiting_cases, globals().get("snakemake"))
