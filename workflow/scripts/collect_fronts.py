"""Exact fronts over exponents and dampings as curves, with tails and multipliers, for the explorer.

About half a minute: python workflow/scripts/collect_fronts.py
    --plane config/default.yaml:explorer --dataset collection.nc
"""

from pathlib import Path

import numpy as np

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.front_collection import collect_fronts as solve_collection
from step import run_step


def collect_fronts(plane: dict, dataset: Path) -> None:
    """Solve the fronts and write their curves.

    Parameters
    ----------
    plane : dict
        As under ``explorer`` of the configuration.
    dataset : Path
        The netCDF file to write, on (alpha, gamma) and along each curve.
    """
    fronts = solve_collection(plane["alpha"], np.geomspace(**plane["gamma"]))
    write_dataset(fronts, dataset, scene_id="collection", config=plane)


if __name__ == "__main__":
    run_step(collect_fronts, globals().get("snakemake"))
