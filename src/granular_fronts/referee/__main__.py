"""Judge results of a discrete-element code: python -m granular_fronts.referee FILE ....

Each file is called PROBLEM_STEP.dump (LAMMPS) or PROBLEM_STEP.csv (columns t, bead, x, v). The
problems and their answers are made by snakemake -c2 referee.
"""

import argparse
import os
import sys
from pathlib import Path

from granular_fronts.arguments import scalar
from granular_fronts.errors import InputError, end_with_reader, exit_on_error
from granular_fronts.output.datasets import DatasetError, configuration_of, read_dataset
from granular_fronts.referee.answers import problems_of
from granular_fronts.referee.assessment import find, report
from granular_fronts.referee.files import make_folder
from granular_fronts.referee.problems import Problem
from granular_fronts.referee.results_files import read_results
from granular_fronts.scenes.sentences import read_part


def main(arguments):
    """Print what each problem's results show, and draw them."""
    parser = argparse.ArgumentParser(
        prog="python -m granular_fronts.referee",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE")
    parser.add_argument("--answers", type=Path, default=Path("results", "referee"))
    parser.add_argument("--error", type=float, default=1.0e-3, help="error that would do")
    parser.add_argument("--figures", type=Path, help="folder for a figure of each problem")
    options = parser.parse_args(arguments)
    with exit_on_error("The results cannot be judged."):
        scalar("--error", options.error, above=0.0, advice="give an error that would do")
        if options.figures:
            make_folder("--figures", options.figures)
        known = _known_problems(options.answers)
        for name, results in read_results(options.files, known).items():
            judge(known[name], results, options)


def _known_problems(folder):
    """Return the files of the answers that the table names, by problem."""
    table = folder / "answers.csv"
    if not table.is_file():
        raise InputError(
            f"{folder} holds no answers: make them by snakemake -c2 referee, or name their folder "
            "by --answers."
        )
    return {
        name: folder / name / "answer.nc" for name in problems_of(table.read_text(encoding="utf-8"))
    }


def _read_answer(path):
    try:
        return read_dataset(path, scene_id=path.parent.name)
    except DatasetError as error:
        raise InputError(str(error)) from None


def judge(path, results, options):
    """One problem."""
    answer = _read_answer(path)
    problem = read_part(Problem, configuration_of(answer))
    findings = [find(problem, answer, result) for result in results]
    print("\n".join(report(problem, findings, options.error)))
    if options.figures:
        # Who asks for no figure does not wait for Matplotlib, and nobody needs a window.
        os.environ["MPLBACKEND"] = "agg"
        from granular_fronts.referee.drawing import draw

        figure = draw(problem, answer, results, findings)
        figure.savefig(options.figures / f"{problem.name}.png")


if __name__ == "__main__":
    end_with_reader()
    main(sys.argv[1:])
