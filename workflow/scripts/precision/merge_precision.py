"""Join what was measured on all families of problems into one dataset."""

import json
from pathlib import Path

import pandas as pd
import xarray as xr
from measure_precision import to_dataset

from granular_fronts.output.datasets import read_dataset, write_dataset
from step import run_step

INDEX = ["problem", "method", "tolerance"]


def merge_precision(datasets: list[Path], dataset: Path) -> None:
    """Put the families side by side.

    Parameters
    ----------
    datasets : list of Path
        Written by measure_precision and measure_log_burgers.
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
    facts = pd.concat([_facts_of(family) for family in families])
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
    if family.attrs["scene"] == "precision_log_burgers":
        return _points_of_log_burgers(family)
    points = family.drop_vars(_facts_of(family).columns).to_dataframe().reset_index()
    return points.dropna(subset="disturbed")


def _points_of_log_burgers(family: xr.Dataset) -> pd.DataFrame:
    """The same of the grids of the logarithmic Burgers equation, from the start of section 4.3.

    Its schemes have an error per step or a longest step for a tolerance, and take it in turns
    without measuring the share of a processor.
    """
    runs = family.to_dataframe().reset_index()
    runs = runs[runs["start"] == "kinks"]
    return pd.DataFrame(
        {
            "problem": "log_burgers_" + runs["scene"],
            "method": runs["scheme"],
            "tolerance": runs["setting"],
            "error": runs[["error", "reference_error"]].max(axis=1),
            "below_reference": (runs["error"] < runs["reference_error"]).astype(float),
            "rescaled_force_error_sup": runs[["error", "reference_error"]].max(axis=1),
            "grid": runs["grid"].astype(float),
            "seconds": runs["seconds"],
            "disturbed": 0.0,
            "right_hand_sides": runs["right_hand_sides"].astype(float),
            "steps": runs["steps"].astype(float),
            "message": "",
        }
    )


def _facts_of(family: xr.Dataset) -> pd.DataFrame:
    """What is known of each problem: our method, and the error of the reference."""
    if family.attrs["scene"] == "precision_log_burgers":
        runs = family.to_dataframe()
        own_errors = (
            runs[runs["start"] == "kinks"].groupby("scene", sort=False)["reference_error"].max()
        )
        facts = own_errors.to_frame().assign(own_method="finite_volumes")
        return facts.rename(lambda scene: f"log_burgers_{scene}").rename_axis("problem")
    return family[["own_method", "reference_error"]].to_dataframe()


if __name__ == "__main__":
    run_step(merge_precision, globals().get("snakemake"))
