"""How fronts change with velocity, pressure and exponent; James (2021), sections 1 and 3.3.

python workflow/scripts/follow_trends.py \
    --scene config/default.yaml:exact_fronts.trends --dataset trends.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.front_trends import follow_trends as follow
from step import run_step


def follow_trends(scene: dict, dataset: Path) -> None:
    """Follow families of fronts.

    Parameters
    ----------
    scene : dict
        Exponents, velocities and compressions as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(follow(**scene), dataset, scene_id="trends", config=scene)


if __name__ == "__main__":
    run_step(follow_trends, globals().get("snakemake"))
