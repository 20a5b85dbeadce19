"""Problems for discrete-element codes: decks, words, accurate answers, and tolerances."""

from granular_fronts.referee.files import write_problems
from granular_fronts.referee.problems import load_problems
from job import job


def write_referee(table: str) -> None:
    """Write all problems with their answers.

    Parameters
    ----------
    table : str
        Table of all answers; the folders of the problems lie beside it.
    """
    write_problems(load_problems(), table)


if __name__ == "__main__":
    with job(snakemake):
        write_referee(snakemake.output.table)
