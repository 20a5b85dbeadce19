"""Folders of cases, each with the problem, decks for codes, the answer, and tolerances by step."""

import csv
import io
from pathlib import Path

import yaml

from granular_fronts.errors import InputError
from granular_fronts.output.datasets import write_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.referee.answers import solve, states_of, table_of
from granular_fronts.referee.decks import RUN_BY, write_decks
from granular_fronts.referee.problems import described, in_words
from granular_fronts.referee.tolerances import measure_tolerance
from granular_fronts.reference_methods.half_step import SCHEMES

STEPS = 0.25, 0.1, 0.05, 0.025


def write_problems(problems, table):
    """Solve problems by their names, and write each into a folder of its name.

    The folders lie beside the table, which has all single numbers.
    """
    folder = Path(table).parent
    answers = {name: write_case(problem, folder / name) for name, problem in problems.items()}
    _write_text(table, table_of(answers))


def write_case(problem, folder):
    """Solve a problem, write all about it into a folder, and return the answer."""
    answer = solve(problem)
    write_dataset(answer, folder / "answer.nc", scene_id=problem.name, config=problem.plain())
    decks = write_decks(problem)
    for name, deck in decks.items():
        _write_text(folder / name, deck)
    _write_text(folder / "problem.txt", in_words(problem))
    case = described(problem) | {"decks": {name: RUN_BY[name] for name in decks}}
    _write_text(folder / "case.yaml", yaml.safe_dump(case, sort_keys=False))
    _write_text(folder / "states.csv", states_of(answer))
    _write_text(folder / "tolerances.csv", _tolerances(problem, answer))
    return answer


def make_folder(argument, folder):
    """Make a folder that an argument names, or raise an InputError."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(
            f"{argument} is {folder}, where no folder can be made ({error.strerror}): name another."
        ) from None


def _tolerances(problem, answer):
    """Return what each scheme may miss the answer by, as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    names = "steps_per_collision", "order", "order_scatter", "motion", "states", "reading"
    writer.writerow(["scheme", "step", *names])
    for scheme in SCHEMES:
        for step in STEPS:
            found = measure_tolerance(problem, answer, scheme, step)
            numbers = [problem.collision_time / step, *found.order, *found[2:]]
            writer.writerow([scheme, step, *(f"{number:.4g}" for number in numbers)])
    return text.getvalue()


def _write_text(path, text):
    with complete_file(path) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
