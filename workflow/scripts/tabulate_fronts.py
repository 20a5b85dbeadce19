"""Tables of exact fronts: their properties, and the errors of continuum fronts."""

import numpy as np
import pandas as pd

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from job import job

PROPERTIES = (
    "overshoot",
    "width_10_90",
    "slope",
    "tail_rate",
    "tail_frequency",
    "dissipated_power",
    "exact_power",
    "speed_defect",
    "residual",
    "error",
    "converged",
)
CONTINUUM = {"logarithmic": "(45)", "unlimited": "(46)", "heteroclinic": "heteroclinic"}


def tabulate_fronts(
    survey: str,
    properties_csv: str,
    properties_markdown: str,
    errors_csv: str,
    errors_markdown: str,
) -> None:
    """Write both tables.

    Parameters
    ----------
    survey : str
        The survey of exact fronts.
    properties_csv, properties_markdown : str
        Overshoot, width, slope, decay, dissipated power of every front.
    errors_csv, errors_markdown : str
        Sup-norm error of u of every continuum front, and which is best.
    """
    fronts = read_dataset(survey)
    points = fronts.to_dataframe().reset_index()
    points["exact_power"] = (points["alpha"] - 1.0) / (2.0 * (points["alpha"] + 1.0))
    properties, errors = points[["alpha", "gamma", *PROPERTIES]], compare(points)
    for table, csv, markdown in (
        (properties, properties_csv, properties_markdown),
        (errors, errors_csv, errors_markdown),
    ):
        write_table(table, round_floats(table, 4), csv, markdown)


def compare(points: pd.DataFrame) -> pd.DataFrame:
    """Return the errors of the continuum fronts at every point, and the name of the best."""
    distances = points[[f"distance_{name}" for name in CONTINUUM]]
    errors = distances.set_axis(CONTINUUM.values(), axis=1)
    best = errors.columns.to_numpy()[np.argmin(errors.to_numpy(), axis=1)]
    return pd.concat([points[["alpha", "gamma"]], errors], axis=1).assign(best=best)


if __name__ == "__main__":
    with job(snakemake):
        tabulate_fronts(
            snakemake.input.survey,
            snakemake.output.properties_csv,
            snakemake.output.properties_markdown,
            snakemake.output.errors_csv,
            snakemake.output.errors_markdown,
        )
