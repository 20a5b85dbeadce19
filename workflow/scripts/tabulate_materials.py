"""Glass, steel and cork: damping by two rules, and their fronts; James (2021), remark 6."""

from typing import Any

import pandas as pd
import xarray as xr

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from job import job


def tabulate_materials(dataset: str, csv: str, markdown: str) -> None:
    """Write a row for each material and front.

    Parameters
    ----------
    dataset : str
        Damping of the materials.
    csv, markdown : str
        Tables to write: full precision, and rounded for people.
    """
    data = read_dataset(dataset, "materials")
    rows = [
        _make_row(data.sel(material=material), kind, dimension, value)
        for material in data["material"].values
        for kind, dimension in (("piston", "piston_velocity"), ("force", "force"))
        for value in data[dimension].values
    ]
    table = pd.DataFrame(rows)
    write_table(table, round_floats(table, 4), csv, markdown)


RESTS_ON = {
    "piston": "gamma, v_0",
    "force": "gamma, v_0, R; mass and elastic constants from handbooks",
}
"""Sources of the damping of a front; the paper prints only the mass of cork."""


def _make_row(one: xr.Dataset, kind: str, dimension: str, value: float) -> dict[str, Any]:
    """Return one row of the table, as a dict."""
    front = one.sel({dimension: value})
    gamma = float(front[f"gamma_front_{kind}"])
    unit = "m/s behind the front" if kind == "piston" else "N of pressure"
    return {
        "material": str(one["material"].values),
        "gamma_printed": float(one["gamma_printed"]),
        "restitution_linear_rule": float(one["restitution"]),
        "gamma_exact": float(one["gamma"]),
        "restitution_of_printed_gamma": float(one["restitution_exact"]),
        "front": f"{value:g} {unit}",
        "gamma_of_front": gamma,
        "mu": float(front[f"mu_front_{kind}"]),
        "regime": "underdamped" if gamma < float(one["critical_gamma"]) else "overdamped",
        "rests_on": RESTS_ON[kind],
        "numerical error": float(one[f"gamma_front_{kind}"].attrs["error_estimate"]),
    }


if __name__ == "__main__":
    with job(snakemake):
        tabulate_materials(snakemake.input.dataset, snakemake.output.csv, snakemake.output.markdown)
