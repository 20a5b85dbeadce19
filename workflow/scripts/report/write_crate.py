"""Write the record of a finished run: a Workflow Run RO-Crate, one archive that others can rerun.

It holds the project's code, the configuration, the environment, all results with sizes and digests,
and what is known of each job: script, inputs, outputs, times, log and run time.  The jobs are those
that Snakemake's own records name, so this step runs where the workflow ran.
"""

from pathlib import Path

import yaml

from crate.jobs import jobs_behind
from crate.run import Run, describe_run
from granular_fronts.output.files import complete_file
from step import run_step

PROJECT = Path(__file__).parents[3]


def write_crate(
    files: list[Path],
    sources: list[Path],
    results: Path,
    configuration: dict,
    scripts: dict,
    archive: Path,
) -> None:
    """Collect and describe a run.

    Parameters
    ----------
    files : list of Path
        Results of the run.
    sources : list of Path
        Files of the project that belong to the record.
    results : Path
        The folder that holds all results.
    configuration : dict
        The merged configuration that was computed.
    scripts : dict
        Script of each rule, by its path in the project.
    archive : Path
        The ZIP file to write.

    Raises
    ------
    ValueError
        If Snakemake has no record of a result.
    """
    run = Run(
        project=PROJECT,
        sources=sources,
        results=results,
        configuration=yaml.safe_dump(configuration, sort_keys=False, allow_unicode=True),
        scripts=scripts,
        jobs=jobs_behind(map(str, files), results),
    )
    with complete_file(archive) as unfinished:
        describe_run(run).write_zip(unfinished)


if __name__ == "__main__":
    run_step(write_crate, globals().get("snakemake"))
