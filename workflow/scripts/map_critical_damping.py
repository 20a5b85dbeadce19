"""Critical damping in its several meanings, and the overshoot over the plane of (alpha, gamma).

Under a minute: python workflow/scripts/map_critical_damping.py
    --plane config/default.yaml:exact_fronts.critical_damping --dataset critical_damping.nc
"""

from pathlib import Path

import numpy as np

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies import damping_map
from step import run_step


def map_critical_damping(plane: dict, dataset: Path) -> None:
    """Compute curves and overshoots and write them.

    Parameters
    ----------
    plane : dict
        As under ``exact_fronts.critical_damping`` of the configuration.
    dataset : Path
        The netCDF file to write, on (alpha, gamma).
    """
    computed = damping_map.map_critical_damping(
        np.linspace(**plane["alpha"]), np.geomspace(**plane["gamma"]), plane["overshoot_cut"]
    )
    write_dataset(computed, dataset, scene_id="critical_damping", config=plane)


if __name__ == "__main__":
    run_step(map_critical_damping, globals().get("snakemake"))
