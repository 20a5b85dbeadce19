"""Compare stated errors of random problems with true ones, by independent programs."""

from importlib import import_module

import numpy as np
import pandas as pd

from granular_fronts.output.datasets import write_dataset
from job import job

UNITS_OF_ROUNDING = 4


def ratio(stated: float, true: float, largest: float) -> float:
    """Return true over stated error, if above four units in the last place of the largest."""
    if stated == np.inf:
        return 0.0  # Nothing is claimed.
    beyond = true - UNITS_OF_ROUNDING * float(np.spacing(largest))
    if beyond <= 0.0:
        return 0.0
    return beyond / stated if stated > 0.0 else np.inf


def measure_honest_errors(kind: str, problems: dict[str, int], dataset: str) -> None:
    """Solve random problems of one kind, and write every number's stated and true error.

    Numbers whose error is more than twice the stated one, and refusals, are printed.

    Parameters
    ----------
    kind : str
        chains, fronts or rings.
    problems : dict
        Which random problems, `seed`, and how many, `count`.
    dataset : str
        The netCDF file to write, on (number).
    """
    found = []
    for name, stated, true, largest in import_module(f"true_{kind}").cases(**problems):
        times = ratio(stated, true, largest)
        if not times <= 2.0:
            print(f"{name}: stated {stated:.2e}, true {true:.2e}, ratio {times:.3g}")
        if not np.isnan(largest):
            found.append((name.split()[0], stated, true, times))
    columns = ("variable", "stated_error", "true_error", "ratio")
    numbers = pd.DataFrame(found, columns=columns).rename_axis("number")
    measured = numbers.to_xarray().set_coords("variable")
    write_dataset(measured, dataset, scene_id=f"honest_{kind}", config=problems)


if __name__ == "__main__":
    with job(snakemake):
        measure_honest_errors(
            snakemake.wildcards.kind, snakemake.params.problems, snakemake.output.dataset
        )
