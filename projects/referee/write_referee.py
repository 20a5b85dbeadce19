"""Problems for discrete-element codes: input for LAMMPS, words, and accurate answers."""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.referee.answers import solve, states_of, table_of
from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.problems import in_words, load_problems
from step import run_step


def write_referee(settings: dict, table: Path) -> None:
    """Write for each problem NAME.lmp, NAME.txt, NAME.nc and NAME.csv, and a table of all.

    Parameters
    ----------
    settings : dict
        The section ``referee`` of config/referee.yaml.
    table : Path
        The table; all other files go into the same folder.
    """
    answers = {}
    table.parent.mkdir(parents=True, exist_ok=True)
    for problem in load_problems(settings).values():
        name = problem.name
        answers[name] = solve(problem)
        place = table.parent / name
        write_dataset(
            answers[name], place.with_suffix(".nc"), scene_id=name, config=problem.plain()
        )
        deck = write_deck(name, problem.title, problem.scene, problem.interval)
        write_text(place.with_suffix(".lmp"), deck)
        write_text(place.with_suffix(".txt"), in_words(problem))
        write_text(place.with_suffix(".csv"), states_of(answers[name]))
    write_text(table, table_of(answers))


def write_text(path: Path, text: str) -> None:
    """Write a file that appears when it is complete."""
    with complete_file(path) as unfinished:
        unfinished.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    run_step(write_referee, globals()["snakemake"])
