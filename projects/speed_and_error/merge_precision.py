"""Join what was measured on all families of problems into one dataset."""

import json
from pathlib import Path

import xarray as xr
from step import run_step

from granular_fronts.output.datasets import configuration_of, read_dataset, write_dataset


def merge_precision(datasets: list[Path], dataset: Path) -> None:
    """Put the families side by side.

    Parameters
    ----------
    datasets : list of Path
        Written by measure_precision.
    dataset : Path
        The netCDF file to write, on (problem, solver, step_tolerance); NaN where nothing ran.
    """
    families = [read_dataset(path) for path in datasets]
    merged = xr.concat(families, "problem", data_vars="all", join="outer", combine_attrs="override")
    problems = merged.indexes["problem"]
    if problems.has_duplicates:
        raise ValueError(
            f"Problem {problems[problems.duplicated()][0]} is in two families: give it another "
            "name in one of them."
        )
    # In the order of the families, which the join has sorted.
    methods = dict.fromkeys(method for family in families for method in family["solver"].values)
    merged = merged.sel({"solver": list(methods)})
    merged["message"] = merged["message"].fillna("").astype(object)
    absent: dict[str, str] = {}
    for family in families:
        absent |= json.loads(family.attrs["absent"])
    merged.attrs = {
        "absent": json.dumps(absent),
        "load_before": max(family.attrs["load_before"] for family in families),
        "machine": families[0].attrs["machine"],
        "solver": families[0].attrs["solver"],
    }
    config = {family.attrs["scene"]: configuration_of(family) for family in families}
    write_dataset(merged, dataset, scene_id="speed_error", config=config)


if __name__ == "__main__":
    run_step(merge_precision, globals()["snakemake"])
