"""Test the finished files of a results folder.

python workflow/scripts/check_results.py --results results --verdict checks.txt
"""

from pathlib import Path

import pytest

from step import run_step

TESTS = Path(__file__).parents[2] / "tests" / "artefacts"


def check_results(results: Path, verdict: Path) -> None:
    """Run the tests of finished files and write down that they passed.

    Parameters
    ----------
    results : Path
        The folder that holds data, figures and tables.
    verdict : Path
        Text file that says how many tests passed; not written when one fails.

    Raises
    ------
    ValueError
        When a test fails.
    """
    outcome = Outcome()
    exit_code = pytest.main([str(TESTS), f"--results={results}", "-q"], plugins=[outcome])
    if exit_code != pytest.ExitCode.OK:
        raise ValueError(
            f"The files in {results} do not pass their tests, named above: "
            "what they show is wrong or unfinished, so do not use it."
        )
    verdict.write_text(f"All {outcome.passed} tests of the files in {results} passed.\n")


class Outcome:
    """Count the tests that passed; pytest calls it for each."""

    def __init__(self) -> None:
        self.passed = 0

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Count a test whose body passed."""
        self.passed += report.when == "call" and report.passed


if __name__ == "__main__":
    run_step(check_results, globals().get("snakemake"))
