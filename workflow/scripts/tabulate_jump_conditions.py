"""Speed, velocity jump and power of fronts by theory and as measured; James (2021), section 2."""

from collections.abc import Mapping
from typing import Any

import pandas as pd
import xarray as xr

from granular_fronts.output.datasets import configuration_of, read_dataset
from granular_fronts.output.tables import write_table
from job import job

MEASURED = {
    "speed": ["exact", "travelling", "driven"],
    "velocity_jump": ["driven"],
    "power": ["exact", "driven"],
}


def tabulate_jump_conditions(dataset: str, csv: str, markdown: str) -> None:
    """Write a row for each lattice.

    Parameters
    ----------
    dataset : str
        The study of jump conditions.
    csv, markdown : str
        Tables to write: all numbers in full precision, and distances from theory for people.
    """
    data = read_dataset(dataset, "jump_conditions")
    cases = configuration_of(data)["cases"]
    names = [str(name) for name in data["law"].values]
    described = [describe(name, cases[name]) for name in names]
    full = [row | _all_numbers(data.sel(law=row["law"])) for row in described]
    brief = [row | distances(data.sel(law=row["law"])) for row in described]
    write_table(pd.DataFrame(full), pd.DataFrame(brief), csv, markdown)


def describe(name: str, case: Mapping[str, Any]) -> dict[str, str]:
    """Return the cells that name the lattice."""
    return {
        "law": name,
        "elastic": _describe_potential(case["elastic"]),
        "dissipation": _describe_potential(case["dissipation"]),
        "states": " to ".join(f"{state:g}" for state in case["states"]),
    }


def _describe_potential(description: Mapping[str, Any]) -> str:
    """Return a potential in a few words."""
    parameters = [f"{name} {value:.3g}" for name, value in description.items() if name != "kind"]
    return " ".join([description["kind"], *parameters])


def _all_numbers(one: xr.Dataset) -> dict[str, float]:
    """Return every value and error of one lattice, by column."""
    row: dict[str, float] = {"direction": int(one["direction"])}
    for quantity, ways in MEASURED.items():
        for way in ["expected", *ways]:
            name = f"{quantity}_{way}"
            row |= {name: float(one[name]), f"{name}_error": float(one[f"{name}_error"])}
    return row


def distances(one: xr.Dataset) -> dict[str, str]:
    """Return what theory says, and how far the measurements are from it and may be."""
    row = {"direction": f"{int(one['direction']):+d}"}
    for quantity, ways in MEASURED.items():
        expected = float(one[f"{quantity}_expected"])
        row[quantity.replace("_", " ")] = f"{expected:.6g}"
        for way in ways:
            name = f"{quantity}_{way}"
            distance, error = float(one[name]) - expected, float(one[f"{name}_error"])
            row[f"{way} {quantity.replace('_', ' ')}"] = f"{distance:+.0e} (± {error:.0e})"
    return row


if __name__ == "__main__":
    with job(snakemake):
        tabulate_jump_conditions(
            snakemake.input.dataset, snakemake.output.csv, snakemake.output.markdown
        )
