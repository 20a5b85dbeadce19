"""Join what was measured on all families of problems into one dataset."""

import json
from pathlib import Path

import pandas as pd
import xarray as xr
from measure_precision import to_dataset

from granular_fronts.output.datasets import read_dataset, write_dataset
from step import run_step

INDEX = ["problem", "method", "tolerance"]
FACTS = ["own_method", "reference_error", "time_limit"]


def merge_precision(datasets: list[Path], dataset: Path) -> None:
    """Put the families side by side.

    Parameters
    ----------
    datasets : list of Path
        Written by measure_precision.
    dataset : Path
        The netCDF file to write, on (problem, method, tolerance).
    """
    families = [read_dataset(path) for path in datasets]
    points = pd.concat([points_of(family) for family in families], ignore_index=True)
    twice = points[points.duplicated(INDEX)]
    if len(twice):
        raise ValueError(
            f"Problem {twice['problem'].iloc[0]} stands in two families: give it another name in "
            "one of them."
        )
    facts = pd.concat([family[FACTS].to_dataframe() for family in families])
    merged = to_dataset(points.to_dict("records"), facts.to_dict("index"))
    first = families[0].attrs
    absent: dict[str, str] = {}
    for family in families:
        absent |= json.loads(family.attrs.get("absent", "{}"))
    merged.attrs = {
        "absent": json.dumps(absent),
        "load_before": max(family.attrs["load_before"] for family in families),
        "machine": first["machine"],
        "solver": first["solver"],
    }
    config = {family.attrs["scene"]: json.loads(family.attrs["config"]) for family in families}
    write_dataset(merged, dataset, scene_id="speed_error", config=config)


def points_of(family: xr.Dataset) -> pd.DataFrame:
    """A row for each method and tolerance that ran."""
    points = family.drop_vars(FACTS).to_dataframe().reset_index()
    return points.dropna(subset="disturbed")


if __name__ == "__main__":
    run_step(merge_precision, globals().get("snakemake"))
