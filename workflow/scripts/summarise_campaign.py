"""List the points of a campaign, and sum up failures and why, ranges, work, means over seeds."""

from collections.abc import Iterator

import numpy as np
import pandas as pd
import xarray as xr

from granular_fronts.campaign.averages import mean_over
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import complete_file
from job import job

FORMATS = {"smallest": ".8g", "median": ".8g", "largest": ".8g", "error estimate": ".1e"}


def summarise_campaign(dataset: str, points: str, csv: str, markdown: str) -> None:
    """Write the points, the table of scalars, and with it the counts as a page.

    Parameters
    ----------
    dataset : str
        A merged campaign.
    points : str
        The file to write with a row for each point.
    csv, markdown : str
        Files of the summary to write.
    """
    merged = read_dataset(dataset)
    with complete_file(points) as unfinished:
        _list_points(merged).to_csv(unfinished)
    scalars = _describe_scalars(merged)
    with complete_file(csv) as unfinished:
        scalars.to_csv(unfinished, index=False)
    with complete_file(markdown) as unfinished:
        shown = scalars.copy()
        for column, style in FORMATS.items():
            shown[column] = [format(value, style) for value in shown[column]]
        parts = [
            _describe_work(merged),
            _count_points(merged).to_markdown(index=False),
            shown.to_markdown(index=False, disable_numparse=True),
            *_average_seeds(merged),
        ]
        unfinished.write_text("\n\n".join(parts) + "\n", encoding="utf-8")


def _list_points(merged: xr.Dataset) -> pd.DataFrame:
    """Return axes, scalars and status of each point, and in words why it failed."""
    axes = merged["status"].dims
    scalars = [name for name, variable in merged.data_vars.items() if variable.dims == axes]
    rows = merged[scalars].to_dataframe(dim_order=axes)
    return rows.assign(reason=merged["reason_text"].values[rows["reason"]])


def _describe_work(merged: xr.Dataset) -> str:
    """Return one sentence on points, failures and the processor time they took."""
    attributes = merged.attrs
    rate = float(f"{1.0 / attributes['seconds_per_point']:.2g}")
    return (
        f"Campaign {attributes['scene']}: {attributes['points']:,} points, "
        f"{attributes['failed_points']:,} failed, {attributes['chunks']:,} chunks, "
        f"{attributes['seconds']:,.1f} s of processor time, "
        f"{rate:,g} points per second and core."
    )


def _count_points(merged: xr.Dataset) -> pd.DataFrame:
    """Return how many points are solved or failed, and the reasons, most frequent first."""
    numbers, counts = np.unique(merged["reason"].values, return_counts=True)
    texts = merged["reason_text"].values
    rows = sorted(zip(numbers, counts, strict=True), key=lambda row: (row[0] > 0, -row[1]))
    outcomes = [(str(texts[number]) if number else "solved", int(count)) for number, count in rows]
    return pd.DataFrame(outcomes, columns=["outcome", "points"])


def _describe_scalars(merged: xr.Dataset) -> pd.DataFrame:
    """Return the range of every recorded scalar over the points that have one."""
    rows = []
    for name, variable in merged.data_vars.items():
        if variable.dims == merged["status"].dims and "error_estimate" in variable.attrs:
            finite = variable.values[np.isfinite(variable.values)]
            spread = np.quantile(finite, [0.0, 0.5, 1.0]) if finite.size else [np.nan] * 3
            rows.append((name, finite.size, *spread, variable.attrs["error_estimate"]))
    return pd.DataFrame(rows, columns=["variable", "points", *FORMATS])


def _average_seeds(merged: xr.Dataset) -> Iterator[str]:
    """Tables of means over random draws and their errors, for an axis that is a seed."""
    for axis in merged["status"].dims:
        if str(axis).endswith("seed"):
            means = mean_over(merged, str(axis))
            rows = means.to_dataframe() if means.dims else means.to_pandas().to_frame().T
            yield f"Means over {axis}, with their errors:"
            yield rows.reset_index().to_markdown(index=False, floatfmt=".6g")


if __name__ == "__main__":
    with job(snakemake):
        summarise_campaign(
            snakemake.input.dataset,
            snakemake.output.points,
            snakemake.output.csv,
            snakemake.output.markdown,
        )
