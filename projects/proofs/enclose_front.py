"""Evaluate the enclosure of a front that is proved, from its certificate."""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.proofs.enclosure import enclosure_dataset
from step import run_step


def enclose_front(front: dict, folder: Path, enclosure: Path) -> None:
    """Evaluate an enclosure.

    Parameters
    ----------
    front : dict
        `name` of the front among those that are proved, and its parameters.
    folder : Path
        Where its certificate lies.
    enclosure : Path
        The netCDF file to write.
    """
    data = enclosure_dataset(folder / f"{front['name']}.npz")
    write_dataset(data, enclosure, scene_id="shown_front", config=front)


if __name__ == "__main__":
    run_step(enclose_front, globals()["snakemake"])
