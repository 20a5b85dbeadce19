"""Test the finished files of a results folder."""

from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
import yaml

from granular_fronts.output.files import complete_file
from step import run_step

TESTS = Path(__file__).parents[3] / "tests" / "artefacts"

# What the tests of the project itself are given takes a second to import.
WITHOUT_THE_OTHERS = [
    f"--confcutdir={TESTS}",
    "--override-ini=pythonpath=src workflow/lib workflow/scripts/report tests/support",
]


def check_results(results: Path, configuration: dict, verdict: Path) -> None:
    """Run the tests of finished files and write down that they passed.

    Parameters
    ----------
    results : Path
        The folder that holds data, figures and tables.
    configuration : dict
        The merged configuration that was computed.
    verdict : Path
        Text file that says how many tests passed; not written when one fails.

    Raises
    ------
    ValueError
        When a test fails, or there is no such folder.
    """
    if not results.is_dir():
        raise ValueError(f"There is no folder {results}: name one that holds results.")
    outcome = Outcome()
    with TemporaryDirectory() as folder:
        asked = Path(folder, "configuration.yaml")
        asked.write_text(yaml.safe_dump(configuration), encoding="utf-8")
        options = [f"--results={results}", f"--configuration={asked}", "-q"]
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
    run_step(check_results, globals()["snakemake"])
