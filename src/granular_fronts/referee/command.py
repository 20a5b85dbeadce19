"""Test a discrete-element code by problems with known answers.

Results are called CASE_STEP.dump (LAMMPS, LIGGGHTS) or CASE_STEP.csv (columns t, bead, x, v).  The
exit status is 0 if all are within the tolerance of their step, 1 if one is not, and 2 if something
cannot be read.
"""

import argparse
import json
import math
import sys
from pathlib import Path

from granular_fronts.errors import InputError, end_with_reader
from granular_fronts.referee.answers import solve
from granular_fronts.referee.assessment import (
    Order,
    damping_without_step,
    find,
    measured,
    observed_order,
)
from granular_fronts.referee.files import make_folder, write_case
from granular_fronts.referee.measurements import NAMES
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.results_files import read_results
from granular_fronts.referee.tolerances import deviation, measure_tolerance, move, with_states_of
from granular_fronts.reference_methods.half_step import SCHEMES


def main(arguments=None):
    """Carry out a command, and end with its exit status."""
    end_with_reader()
    options = _parser().parse_args(arguments)
    try:
        sys.exit(options.carry_out(load_problems(), options))
    except InputError as error:
        print(error, file=sys.stderr)
        sys.exit(2)


def _parser():
    parser = argparse.ArgumentParser(
        prog="granular-fronts-referee",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    cases = commands.add_parser("cases", help="list the cases")
    cases.set_defaults(carry_out=_list)
    write = commands.add_parser("write", help="write a case, its decks, answer and tolerances")
    write.add_argument("case", metavar="CASE")
    write.add_argument("folder", type=Path, metavar="FOLDER")
    write.set_defaults(carry_out=_write)
    judge = commands.add_parser("judge", help="test results by the tolerances of their steps")
    judge.add_argument("files", nargs="+", type=Path, metavar="FILE")
    judge.add_argument("--scheme", choices=SCHEMES, default="lagged_verlet", help="of the code")
    judge.set_defaults(carry_out=_judge)
    for command in (cases, judge):
        command.add_argument("--json", action="store_true", help="print JSON for a program")
    return parser


def _list(problems, options):
    if options.json:
        print(json.dumps([problem.plain() for problem in problems.values()]))
    else:
        for problem in problems.values():
            print(f"{problem.title}; beads: {problem.scene.beads.count}; {problem.moved}")
    return 0


def _write(problems, options):
    if options.case not in problems:
        raise InputError(f"There is no case {options.case}: choose from {', '.join(problems)}.")
    make_folder("FOLDER", options.folder)
    write_case(problems[options.case], options.folder)
    return 0


def _judge(problems, options):
    """Print what was measured, and return 1 if a result misses its tolerance."""
    cases = []
    for name, results in read_results(options.files, problems).items():
        problem, answer = problems[name], solve(problems[name])
        findings = [find(problem, answer, result) for result in results]
        limits = [measure_tolerance(problem, answer, options.scheme, one.step) for one in findings]
        rows = [_row(name, *pair) for pair in zip(findings, limits, strict=True)]
        schemes = _beside_schemes(problem, answer, results)
        excess = dict(
            zip(("excess_damping", "change"), damping_without_step(findings), strict=True)
        )
        summary = _order(findings) | excess | {"schemes": schemes}
        cases.append({"case": name, "results": rows} | summary)
        if not options.json:
            print("\n".join(measured(problem, findings)))
            number = NAMES[problem.motion]
            print("\n".join(_verdict_in_words(row, number, options.scheme) for row in rows))
            print("\n".join(_schemes_in_words(schemes, results[-1].step)))
    if options.json:
        print(json.dumps(_without_nan(cases)))
    return 0 if all(row["passes"] for case in cases for row in case["results"]) else 1


def _without_nan(found):
    """Replace NaN, which JSON has not, by null."""
    if isinstance(found, dict):
        return {name: _without_nan(value) for name, value in found.items()}
    if isinstance(found, list):
        return [_without_nan(value) for value in found]
    return None if isinstance(found, float) and math.isnan(found) else found


def _order(findings):
    order = observed_order(findings) if len(findings) > 1 else Order(math.nan, math.nan)
    return {"order": order.value, "scatter": order.scatter}


def _beside_schemes(problem, answer, results):
    """Return orders of the schemes at the same steps, and how far the result of the last is off."""
    found = {}
    for name in SCHEMES:
        motions = [move(problem, result.step, name) for result in results]
        findings = [find(problem, answer, motion) for motion in motions]
        there = with_states_of(problem, motions[-1], answer)
        found[name] = _order(findings) | {"distance": find(problem, there, results[-1]).error}
    return found


def _schemes_in_words(schemes, step):
    yield "  Three schemes, measured alike; a code may have the order of one for another reason:"
    for name, one in schemes.items():
        order = Order(one["order"], one["scatter"])
        order = "" if math.isnan(order.value) else f"order {order}, "
        yield f"    {name}: {order}{one['distance']:.1e} from the result at step {step:g}."


def _row(name, finding, limit):
    """Compare errors with their tolerances; an InputError says that digits leave it open."""
    reading = deviation(finding)
    reading_open = finding.measurement_open / abs(finding.exact)
    error_is_open = abs(finding.error - limit.motion) < finding.error_open
    if error_is_open or abs(reading - limit.reading) < reading_open:
        raise InputError(
            f"{name} with step {finding.step:g} has {finding.digits} digits, too few to tell "
            "whether it is within its tolerance: write all, in LAMMPS by dump_modify … format "
            "float %.17g."
        )
    read_within = math.isnan(limit.reading) or reading <= limit.reading
    return {
        "step": finding.step,
        "error": finding.error,
        "tolerance": limit.motion,
        "reading": reading,
        "reading_tolerance": limit.reading,
        "passes": finding.error <= limit.motion and read_within,
    }


def _verdict_in_words(row, number, scheme):
    verdict = "is within" if row["passes"] else "MISSES"
    read = f"; {number} off by {row['reading']:.1e} (tolerance {row['reading_tolerance']:.1e})"
    reading = "" if math.isnan(row["reading"]) else read
    return (
        f"  Step {row['step']:g} {verdict} the tolerance of {scheme}: error {row['error']:.1e} "
        f"(tolerance {row['tolerance']:.1e}){reading}."
    )


if __name__ == "__main__":
    main()
