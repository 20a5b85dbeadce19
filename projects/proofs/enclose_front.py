"""Evaluate the enclosure of a front that is proved, from its certificate."""

from granular_fronts.output.datasets import write_dataset
from granular_fronts.proofs.enclosure import enclosure_dataset
from job import job


def enclose_front(certificate: str, front: dict, dataset: str) -> None:
    """Evaluate an enclosure.

    Parameters
    ----------
    certificate : str
        File of the certificate.
    front : dict
        Parameters of the front, which the data name.
    dataset : str
        The netCDF file to write.
    """
    write_dataset(enclosure_dataset(certificate), dataset, scene_id="shown_front", config=front)


if __name__ == "__main__":
    with job(snakemake):
        enclose_front(
            snakemake.params.certificate, snakemake.params.front, snakemake.output.dataset
        )
