"""Where damping is weak, for several laws of damping; James (2021), section 3.1.

python workflow/scripts/evaluate_damping_regimes.py \
    --regimes config/default.yaml:laws.damping_regimes --dataset regimes.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.damping_regimes import evaluate_regimes
from step import run_step


def evaluate_damping_regimes(regimes: dict, dataset: Path) -> None:
    """Tabulate γ and the restitution against the reference velocity.

    Parameters
    ----------
    regimes : dict
        Exponents and velocities as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(evaluate_regimes(**regimes), dataset, scene_id="damping_regimes", config=regimes)


if __name__ == "__main__":
    run_step(evaluate_damping_regimes, globals().get("snakemake"))
