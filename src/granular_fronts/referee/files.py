"""Files of the problems: input for LAMMPS, words, accurate answers, and a table of all."""

from pathlib import Path

from granular_fronts.output.datasets import write_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.referee.answers import solve, states_of, table_of
from granular_fronts.referee.lammps_deck import write_deck
from granular_fronts.referee.problems import in_words


def write_problems(problems, table):
    """Solve problems by their names, and write for each NAME.lmp, .txt, .nc and .csv.

    They go into the folder of the table, which has all single numbers.
    """
    answers, folder = {}, Path(table).parent
    folder.mkdir(parents=True, exist_ok=True)
    for name, problem in problems.items():
        answer = answers[name] = solve(problem)
        write_dataset(answer, folder / f"{name}.nc", scene_id=name, config=problem.plain())
        deck = write_deck(name, problem.title, problem.scene, problem.interval)
        _write_text(folder / f"{name}.lmp", deck)
        _write_text(folder / f"{name}.txt", in_words(problem))
        _write_text(folder / f"{name}.csv", states_of(answer))
    _write_text(table, table_of(answers))


def _write_text(path, text):
    with complete_file(path) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
