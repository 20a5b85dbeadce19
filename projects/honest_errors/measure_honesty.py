"""Compare stated errors of random problems with true ones, by independent programs."""

from importlib import import_module
from pathlib import Path

import numpy as np
import pandas as pd

from granular_fronts.output.datasets import write_dataset
from step import run_step
from truth import ratio


def measure_honesty(kind: str, problems: dict[str, int], dataset: Path) -> None:
    """Solve random problems of one kind, and write every number's stated and true error.

    Numbers whose error is more than twice the stated one, and refusals, are printed.

    Parameters
    ----------
    kind : str
        chains, fronts or rings.
    problems : dict
        Which random problems, `seed`, and how many, `count`.
    dataset : Path
        The netCDF file to write, on (number).
    """
    found = []
    cases = import_module(f"truth.{kind}").cases
    for name, stated, true, largest, size in cases(**problems):
        times = ratio(stated, true, largest)
        if not times <= 2.0:
            print(f"{name}: stated {stated:.2e}, true {true:.2e}, ratio {times:.3g}")
        if not np.isnan(largest):
            found.append((name.split()[0], stated, true, times, size))
    columns = ("variable", "stated_error", "true_error", "ratio", "values")
    numbers = pd.DataFrame(found, columns=columns).rename_axis("number")
    for single, rows in numbers.groupby(numbers["values"] == 1):
        silent = np.isinf(rows["stated_error"]).mean()
        above = ", ".join(
            f"{np.mean(rows['ratio'] > limit):.2%} above {limit}" for limit in (2, 10)
        )
        print(
            f"{len(rows)} {'single numbers' if single else 'arrays'}: {above}, largest "
            f"{rows['ratio'].max():.3g}, {silent:.2%} without a claim"
        )
    measured = numbers.drop(columns="values").to_xarray().set_coords("variable")
    write_dataset(measured, dataset, scene_id=f"honesty_{kind}", config=problems)


if __name__ == "__main__":
    run_step(measure_honesty, globals()["snakemake"])
