"""What is proved as tables: fronts and families of fronts, and the margin of each inequality."""

import math
from collections.abc import Iterator
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.tables import round_floats, write_table
from job import job


def tabulate_proofs(
    fronts: str,
    intervals: str,
    csv: str,
    markdown: str,
    margins_csv: str,
    margins_markdown: str,
) -> None:
    """Write a row for each front and each family, and one for each of their inequalities.

    Parameters
    ----------
    fronts, intervals : str
        Written by prove_fronts and join_intervals.
    csv, markdown : str
        Table of statements to write.
    margins_csv, margins_markdown : str
        Table of margins to write.
    """
    single, joined = read_dataset(fronts, "fronts"), read_dataset(intervals, "intervals")
    groups = {str(name): single.sel(certificate=[name]) for name in single["certificate"].values}
    groups |= dict(families(joined))
    table = pd.DataFrame([describe(name, group) for name, group in groups.items()])
    write_table(table, round_floats(table, 6), csv, markdown)
    rows = [row for name, group in groups.items() for row in margins(name, group)]
    table = pd.DataFrame(rows)
    write_table(table, round_floats(table, 3), margins_csv, margins_markdown)


def families(joined: xr.Dataset) -> Iterator[tuple[str, xr.Dataset]]:
    """Continuous families: runs of certificates of which each continues the one before."""
    starts = np.flatnonzero(joined["joined"].values == 0)
    for start, stop in zip(starts, [*starts[1:], joined.sizes["certificate"]], strict=True):
        rows = joined.isel(certificate=slice(start, stop))
        yield f"family, alpha = {stretches(rows, 'alpha')}", rows


def describe(name: str, group: xr.Dataset) -> dict[str, Any]:
    """Return what is proved of a front or of a family, with the worst of its bounds."""
    return {
        "front": name,
        "alpha": stretches(group, "alpha"),
        "beta": float(group["beta"][0]),
        "gamma": stretches(group),
        "shape": "; ".join(_shapes(group)) or "existence and tails",
        "error of ū below": f"{_rounded(float(group['error_bound'].max()), 3, ROUND_CEILING):.2e}",
        "certificates": group.sizes["certificate"],
        "kB": round(float(group["bytes"].sum()) / 1000, 1),
        "processor seconds": round(float(group["processor_seconds"].sum()), 1),
    }


def _shapes(group: xr.Dataset) -> Iterator[str]:
    """Which of the fronts are monotone, and which overshoot by how much."""
    several = group.sizes["certificate"] > 1
    for where, words in (
        (group["monotone"] == 1.0, "monotone"),
        (group["overshoot_bound"].notnull(), _overshoot(group)),
        (group["oscillates"] == 1.0, "tail oscillates, max u > 1"),
        (group["critical"] == 1.0, "one turns into the other"),
    ):
        if where.any():
            rows = group.isel(certificate=where.values)
            yield words + (f" for gamma {stretches(rows)}" if several else "")
    if not several and np.isfinite(group["rate_low"]).all():
        amplitude = "B" if float(group["oscillates"][0]) == 1.0 else "A"
        low, high = float(group["amplitude_low"][0]), float(group["amplitude_high"][0])
        middle = round((low + high) / 2, 3)
        radius = math.ceil(1000 * max(high - middle, middle - low)) / 1000
        yield f"{amplitude} = {middle:.3f} ± {radius:.3f}"


def _overshoot(group: xr.Dataset) -> str:
    """Return what max u exceeds, of all fronts that are proved to overshoot."""
    return f"max u − 1 > {_rounded(float(group['overshoot_bound'].min()), 4, ROUND_FLOOR):.4g}"


def _rounded(bound: float, digits: int, rounding: str) -> float:
    """Return a bound in few digits that is still one."""
    return float(Context(digits, rounding).create_decimal_from_float(bound))


def stretches(rows: xr.Dataset, parameter: str = "gamma") -> str:
    """Return the intervals that certificates cover, exactly; those that touch each other as one."""
    found: list[list[str]] = []
    for low, high in rows["ends"].sel(parameter=parameter).values:
        if found and Fraction(low) <= Fraction(found[-1][1]):
            found[-1][1] = high
        else:
            found.append([low, high])
    return " and ".join(low if low == high else f"{low} to {high}" for low, high in found)


def margins(name: str, group: xr.Dataset) -> Iterator[dict[str, Any]]:
    """Each inequality left < right, where its margin is smallest."""
    for inequality in group["inequality"].values:
        sides = group[["left", "right"]].sel(inequality=inequality).dropna("certificate")
        if sides.sizes["certificate"]:
            place = int((sides["right"] - sides["left"]).argmin("certificate"))
            worst = sides.isel(certificate=place)
            left, right = float(worst["left"]), float(worst["right"])
            yield {
                "front": name,
                "inequality": str(inequality),
                "left": left,
                "right": right,
                "margin": right - left,
                "certificate": str(worst["certificate"].values),
            }


if __name__ == "__main__":
    with job(snakemake):
        tabulate_proofs(
            snakemake.input.fronts,
            snakemake.input.intervals,
            snakemake.output.csv,
            snakemake.output.markdown,
            snakemake.output.margins_csv,
            snakemake.output.margins_markdown,
        )
