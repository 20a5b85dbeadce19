"""Fronts of lattices with any potentials against the jump conditions; James (2021), section 2.

python workflow/scripts/check_jump_conditions.py \
    --scene config/default.yaml:laws.jump_conditions --dataset jump_conditions.nc
"""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.jump_conditions_measured import measure_jumps
from step import run_step


def check_jump_conditions(scene: dict, dataset: Path) -> None:
    """Measure speed, velocity jump and power of solved and of driven fronts.

    Parameters
    ----------
    scene : dict
        Lattices, states and accuracy as the configuration holds them.
    dataset : Path
        The netCDF file to write.
    """
    write_dataset(measure_jumps(**scene), dataset, scene_id="jump_conditions", config=scene)


if __name__ == "__main__":
    run_step(check_jump_conditions, globals().get("snakemake"))
