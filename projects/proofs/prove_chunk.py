"""Prove fronts for all γ of one chunk of an interval, certificate after certificate.

Certificates that the folder holds already are proved again from their files and kept.
"""

import sys
import time
from fractions import Fraction
from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.proofs.balls import NotProvedError
from granular_fronts.proofs.intervals import prove_interval
from granular_fronts.proofs.records import records_dataset
from job import job

SECONDS_BETWEEN_LINES = 20.0  # in the log


def prove_chunk(chunk: dict, folder: str, dataset: str) -> None:
    """Prove a chunk.

    Parameters
    ----------
    chunk : dict
        `alpha`, `low` and `high`, and further arguments of `prove_interval`.
    folder : str
        Receives the certificates, and may hold certificates of a run that was stopped.
    dataset : str
        The netCDF file to write.

    Raises
    ------
    ValueError
        Where even narrow intervals of γ are not proved.
    """
    rows, shown = [], time.monotonic()
    try:
        for row in prove_interval(folder=folder, **chunk):
            name = f"{chunk['alpha']:g}/{Path(row['path']).stem}"
            rows.append(row | {"name": name})
            if time.monotonic() - shown > SECONDS_BETWEEN_LINES:
                shown = time.monotonic()
                _show_progress(rows, chunk)
    except NotProvedError as failure:
        reached = rows[-1]["gamma"][1] if rows else chunk["low"]
        raise ValueError(
            f"From γ = {float(Fraction(reached)):g} on nothing is proved, {failure}: give this part"
            " of the interval more cells, a finer inverse behind or a smaller drift."
        ) from failure
    _show_progress(rows, chunk)
    write_dataset(records_dataset(rows), dataset, scene_id=Path(dataset).stem, config=chunk)


def _show_progress(rows: list[dict], chunk: dict) -> None:
    """Say how far a chunk has come, at which rate, and what it will still take."""
    low, high = (float(Fraction(chunk[end])) for end in ("low", "high"))
    reached, seconds = float(rows[-1]["gamma"][1]), sum(row["seconds"] for row in rows)
    left = seconds * (high - reached) / (reached - low)
    print(
        f"alpha = {chunk['alpha']:g}: gamma up to {reached:.6f} of {low:.6f} to {high:.6f},"
        f" {len(rows)} certificates, {seconds / len(rows):.2f} s each, {seconds:.0f} s of processor"
        f" time, about {left:.0f} s left",
        file=sys.stderr,
    )


if __name__ == "__main__":
    with job(snakemake):
        prove_chunk(snakemake.params.chunk, snakemake.params.folder, snakemake.output.dataset)
