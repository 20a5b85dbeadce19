"""Test the finished files of a results folder."""

import json
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from granular_fronts.output.files import complete_file
from job import job

TESTS = Path(__file__).parents[2] / "tests" / "artefacts"

# What the tests of the project itself are given takes a second to import.
WITHOUT_THE_OTHERS = [
    f"--confcutdir={TESTS}",
    "--override-ini=pythonpath=src",
]


def check_results(results: str, datasets: dict, figures: list[str], verdict: str) -> None:
    """Run the tests of finished files and write down that they passed.

    Parameters
    ----------
    results : str
        The folder that holds data, figures and tables.
    datasets : dict
        For each dataset that should be there its parameters and the paper's.
    figures : list of str
        Names of the figures that should be there.
    verdict : str
        Text file that says how many tests passed; not written when one fails.

    Raises
    ------
    ValueError
        When a test fails, or there is no such folder.
    """
    if not Path(results).is_dir():
        raise ValueError(f"There is no folder {results}: name one that holds results.")
    outcome = Outcome()
    with TemporaryDirectory() as folder:
        listed = Path(folder, "made.json")
        listed.write_text(json.dumps({"datasets": datasets, "figures": figures}), encoding="utf-8")
        options = [f"--results={results}", f"--made={listed}", "-q"]
        command = [str(TESTS), *WITHOUT_THE_OTHERS, *options]
        exit_code = pytest.main(command, plugins=[outcome])
    if exit_code != pytest.ExitCode.OK:
        raise ValueError(
            f"The files in {results} do not pass their tests, named above: "
            "what they show is wrong or unfinished, so do not use it. The verdicts belong to the "
            "paper's parameters, which config/default.yaml holds. Where it was changed, put other "
            "ones into a file laid over it."
        )
    skipped = f", {outcome.skipped} that expect the paper's parameters or more tables were skipped"
    with complete_file(verdict) as unfinished:
        unfinished.write_text(
            f"All {outcome.passed} tests of the files in {results} passed"
            f"{skipped if outcome.skipped else ''}.\n"
        )


class Outcome:
    """Count the tests that passed and that were skipped; pytest calls it for each."""

    def __init__(self) -> None:
        self.passed = self.skipped = 0

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Count a test whose body passed, or that did not apply."""
        self.passed += report.when == "call" and report.passed
        self.skipped += report.skipped


if __name__ == "__main__":
    with job(snakemake):
        check_results(
            snakemake.params.results,
            snakemake.params.datasets,
            snakemake.params.figures,
            snakemake.output.verdict,
        )
