"""Damping of real beads and of the fronts they carry; James (2021), remark 6.

python workflow/scripts/evaluate_materials.py \
    --materials config/default.yaml:laws.materials --dataset materials.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.materials import evaluate_materials as evaluate
from step import run_step


def evaluate_materials(materials: dict, dataset: Path) -> None:
    """Invert the restitution of each material and scale its damping to fronts.

    Parameters
    ----------
    materials : dict
        The materials as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(evaluate(**materials), dataset, scene_id="materials", config=materials)


if __name__ == "__main__":
    run_step(evaluate_materials, globals().get("snakemake"))
