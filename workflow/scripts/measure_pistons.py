"""Fronts driven by a piston, at once or by a ramp; James (2021), equations (22) and (23).

python workflow/scripts/measure_pistons.py \
    --piston config/default.yaml:laws.piston --dataset piston.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies import pistons as fronts
from step import run_step


def measure_pistons(piston: dict, dataset: Path) -> None:
    """Measure speed, compression and velocity of the fronts of each contact law.

    Parameters
    ----------
    piston : dict
        Piston, chain and laws as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(fronts.measure_pistons(**piston), dataset, scene_id="piston", config=piston)


if __name__ == "__main__":
    run_step(measure_pistons, globals().get("snakemake"))
