"""Prove single fronts: a certificate of each, checked from its file, and what is proved."""

import time
from pathlib import Path
from typing import Any

from granular_fronts.output.datasets import write_dataset
from granular_fronts.proofs.certificate import prove_front
from granular_fronts.proofs.records import records_dataset
from job import job


def prove_fronts(fronts: dict, folder: str, dataset: str) -> None:
    """Prove fronts one after another.

    Parameters
    ----------
    fronts : dict
        As under ``fronts`` of config.yaml.
    folder : str
        Receives the certificates.
    dataset : str
        The netCDF file to write.

    Raises
    ------
    ValueError
        If one is not proved.
    """
    Path(folder).mkdir(parents=True, exist_ok=True)
    rows = [_prove(name, case, Path(folder, f"{name}.npz")) for name, case in fronts.items()]
    write_dataset(records_dataset(rows), dataset, scene_id="fronts", config=fronts)


def _prove(name: str, case: dict[str, Any], path: Path) -> dict[str, Any]:
    """Return what is proved of one front."""
    start = time.process_time()
    found = prove_front(path=path, **case)
    if not found["proved"]:
        raise ValueError(
            f"Front {name} is not proved, {found['reason']}: give it more cells or a smaller drift."
        )
    seconds = time.process_time() - start
    law = {"beta": case.get("beta", case["alpha"])}
    return found | law | {"name": name, "path": path, "seconds": seconds}


if __name__ == "__main__":
    with job(snakemake):
        prove_fronts(snakemake.params.fronts, snakemake.params.folder, snakemake.output.dataset)
