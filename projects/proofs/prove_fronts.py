"""Prove single fronts: a certificate of each, checked from its file, and what is proved."""

import time
from pathlib import Path
from typing import Any

from granular_fronts.output.datasets import write_dataset
from granular_fronts.proofs.certificate import prove_front
from granular_fronts.proofs.records import records_dataset
from step import run_step


def prove_fronts(fronts: dict, folder: Path, dataset: Path) -> None:
    """Prove fronts one after another.

    Parameters
    ----------
    fronts : dict
        As under ``proofs.fronts`` of the configuration.
    folder : Path
        Receives the certificates.
    dataset : Path
        The netCDF file to write.

    Raises
    ------
    ValueError
        If one is not proved.
    """
    folder.mkdir(parents=True, exist_ok=True)
    rows = [_prove(name, case, folder / f"{name}.npz") for name, case in fronts.items()]
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
    run_step(prove_fronts, globals()["snakemake"])
