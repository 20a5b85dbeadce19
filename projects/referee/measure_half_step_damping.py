"""What the step of discrete-element codes does to a front, read as damping."""

from granular_fronts.output.datasets import write_dataset
from half_step_study import compare_half_steps
from job import job


def measure_half_step_damping(settings: dict, dataset: str) -> None:
    """Compare the scheme with accurate chains, and write what is found.

    Parameters
    ----------
    settings : dict
        As in config.yaml.
    dataset : str
        The netCDF file to write.
    """
    found = compare_half_steps(**settings)
    write_dataset(found, dataset, scene_id="half_step_damping", config=settings)


if __name__ == "__main__":
    with job(snakemake):
        measure_half_step_damping(snakemake.params.settings, snakemake.output.dataset)
