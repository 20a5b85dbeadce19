"""Join the chunks of proved intervals: at each common end the fronts of both are one.

Not by hand: the workflow knows which chunks cover an interval.
"""

from itertools import pairwise
from pathlib import Path

import xarray as xr

from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.proofs.families import prove, record
from granular_fronts.proofs.records import records_dataset
from job import job


def join_intervals(chunks: list[str], intervals: dict, dataset: str) -> None:
    """Prove the junctions of neighbouring chunks from the files, and write all that is proved.

    Parameters
    ----------
    chunks : list of str
        Files of the chunks, in the order of γ for each family.
    intervals : dict
        As under ``intervals`` of config.yaml.
    dataset : str
        The netCDF file to write.

    Raises
    ------
    NotProvedError
        If the fronts on both sides of a common end are not proved to be one.
    """
    parts = [read_dataset(path) for path in chunks]
    for k, (before, after) in enumerate(pairwise(parts), start=1):
        if float(before["alpha"][-1]) == float(after["alpha"][0]):
            parts[k] = _joined(before, after)
    # An inequality that one of the parts never met is missing there.
    found = xr.concat(parts, "certificate", join="outer", combine_attrs="drop")
    write_dataset(found, dataset, scene_id="intervals", config=intervals)


def _joined(before: xr.Dataset, after: xr.Dataset) -> xr.Dataset:
    """Return a part whose first row says that its fronts continue the part before."""
    kept, rest = after.isel(certificate=0), after.isel(certificate=slice(1, None))
    last, path = (Path(str(file)) for file in (before["file"].values[-1], kept["file"].values))
    row = record(path, prove(path, prove(last))) | {
        "name": str(kept["certificate"].values),
        "seconds": float(kept["processor_seconds"]),
    }
    return xr.concat(
        [records_dataset([row]), rest], "certificate", join="outer", combine_attrs="drop"
    )


if __name__ == "__main__":
    with job(snakemake):
        join_intervals(snakemake.input.chunks, snakemake.params.intervals, snakemake.output.dataset)
