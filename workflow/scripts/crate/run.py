"""A run as a Provenance Run Crate: https://w3id.org/ro/wfrun/provenance/0.5.

The workflow has a step for each rule, and a step a tool, the rule's script.  What ran is described
by actions: one for the whole run, and one for each job with its inputs, outputs, log and run time.
Only what is known is said: who started the run is not, and a job that an earlier call has run
stands there with the times of that call.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from rocrate.model.entity import Entity
from rocrate.rocrate import ROCrate

from crate.entities import (
    add_citation,
    add_file,
    add_software,
    add_thing,
    describe_file,
    installed_packages,
    package_identifier,
)
from crate.jobs import Job
from granular_fronts.output.datasets import read_dataset

PROFILES = {
    "https://w3id.org/ro/wfrun/process/0.5": "Process Run Crate",
    "https://w3id.org/ro/wfrun/workflow/0.5": "Workflow Run Crate",
    "https://w3id.org/ro/wfrun/provenance/0.5": "Provenance Run Crate",
    "https://w3id.org/workflowhub/workflow-ro-crate/1.0": "Workflow RO-Crate",
}

TERMS = {
    "buildInstructions": "https://codemeta.github.io/terms/buildInstructions",
    "sha256": "https://w3id.org/ro/terms/workflow-run#sha256",
}
"""Terms of the profiles that RO-Crate 1.1 has not, written out so that nobody must fetch them."""

REQUIREMENTS_FORMAT = "https://pip.pypa.io/en/stable/reference/requirements-file-format/"


@dataclass(frozen=True)
class Run:
    """A finished run of the workflow, and where it lies."""

    project: Path
    """The project's folder."""
    sources: list[Path]
    """Files of the project that belong to the record."""
    results: Path
    """The folder of all results."""
    configuration: str
    """The merged configuration as YAML."""
    scripts: Mapping[str, str]
    """Script of each rule, by its path in the project."""
    jobs: list[Job]
    """All jobs, in the order in which they started."""

    def script_of(self, rule: str) -> Path:
        """The script of a rule, which is the tool behind its step."""
        return self.project / self.scripts[rule]


def describe_run(run: Run) -> ROCrate:
    """Describe a run with all its files.

    Parameters
    ----------
    run : Run

    Returns
    -------
    ROCrate
        To be written as a folder or an archive.
    """
    crate = ROCrate(version="1.1")
    crate.metadata.extra_terms.update(TERMS)
    files = add_files(crate, run)
    cited = add_citation(crate, run.project)
    workflow = add_workflow(crate, run, files, cited)
    actions = add_jobs(crate, run, files)
    add_calls(crate, run, workflow, actions)
    root = crate.root_dataset
    files[run.project / "README.md"]["about"] = root
    root["name"] = f"A run of {cited['name']}"
    root["description"] = (
        "The workflow, its configuration and environment, every job that ran, all results, and the "
        "manual, which begins in docs/index.md. "
        "To run it again, unpack it and call: make .venv/installed; "
        ".venv/bin/snakemake -c2 --configfile configuration.yaml --config results=again"
    )
    root["datePublished"] = max(job.end for job in run.jobs).date().isoformat()
    root["conformsTo"] = [
        add_thing(crate, address, "CreativeWork", name=name, version=address.rpartition("/")[2])
        for address, name in PROFILES.items()
    ]
    for key in ("author", "license", "citation"):
        root[key] = cited[key]
    for entity in crate.get_entities():
        state_singly(entity.properties())
    return crate


def state_singly(properties: dict[str, Any]) -> None:
    """Take single values out of their lists, as RO-Crate recommends."""
    for key, value in properties.items():
        if isinstance(value, list) and len(value) == 1:
            properties[key] = value[0]


def add_files(crate: ROCrate, run: Run) -> dict[Path, Entity]:
    """Add every file of the project and of the results, but not the main workflow.

    Parameters
    ----------
    crate : ROCrate
    run : Run

    Returns
    -------
    dict of Path to Entity
        By absolute path.
    """
    made = [file for job in run.jobs for file in (*job.outputs, job.log, run_time_of(job, run))]
    places = {whole(file): Path("results", Path(file).relative_to(run.results)) for file in made}
    places |= {file: file.relative_to(run.project) for file in map(whole, run.sources)}
    del places[run.project / "Snakefile"]
    return {file: add_file(crate, file, place.as_posix()) for file, place in places.items()}


def whole(file: Path | str) -> Path:
    """The absolute path of a file."""
    return Path(os.path.abspath(file))


def run_time_of(job: Job, run: Run) -> str:
    """The file with the run time of a job."""
    return str(run.results / "benchmarks" / f"{name_of(job, run)}.tsv")


def name_of(job: Job, run: Run) -> str:
    """The name of a job, which is that of its log."""
    return Path(job.log).relative_to(run.results / "logs").with_suffix("").as_posix()


def add_workflow(
    crate: ROCrate, run: Run, files: Mapping[Path, Entity], cited: Mapping[str, Any]
) -> Entity:
    """Add the workflow with its steps and their tools, which are scripts.

    Parameters
    ----------
    crate : ROCrate
    run : Run
    files : mapping of str to Entity
        As `add_files` gives.
    cited : mapping
        As `entities.add_citation` gives.

    Returns
    -------
    Entity
    """
    rules = dict.fromkeys(job.rule for job in run.jobs)
    tools = {rule: files[run.script_of(rule)] for rule in rules}
    for tool in tools.values():
        tool.properties()["@type"] = ["File", "SoftwareSourceCode"]
        tool["version"] = cited["version"]
    steps = [
        add_thing(
            crate,
            f"#step-{rule}",
            "HowToStep",
            name=rule,
            position=str(position),
            workExample=tool,
        )
        for position, (rule, tool) in enumerate(tools.items(), start=1)
    ]
    environment = files[run.project / "environment.txt"]
    environment["description"] = "Every package with its version and digest, as pip installs it."
    environment["conformsTo"] = add_thing(
        crate, REQUIREMENTS_FORMAT, "WebPage", name="Requirements file format of pip"
    )
    add_file(crate, installed_packages(), "installed.txt", description="What was installed.")
    main = run.project / "Snakefile"
    return crate.add_workflow(
        main,
        "Snakefile",
        main=True,
        lang="snakemake",
        lang_version=metadata.version("snakemake"),
        properties={
            **describe_file(main),
            **cited,
            "@type": ["File", "SoftwareSourceCode", "ComputationalWorkflow", "HowTo"],
            "hasPart": [files[file] for file in sorted({run.script_of(rule) for rule in rules})],
            "step": steps,
            "buildInstructions": environment,
            "softwareRequirements": add_software(crate, run.project),
        },
    )


def add_jobs(crate: ROCrate, run: Run, files: Mapping[Path, Entity]) -> dict[str, Entity]:
    """Add the jobs with what they read and wrote; log and run time are about them.

    Parameters
    ----------
    crate : ROCrate
    run : Run
    files : mapping of Path to Entity
        As `add_files` gives.

    Returns
    -------
    dict of str to Entity
        The action of each job by the job's name.
    """
    actions = {}
    for job in run.jobs:
        name = name_of(job, run)
        actions[name] = crate.add_action(
            files[run.script_of(job.rule)],
            f"#job-{name}",
            object=[files[whole(file)] for file in job.inputs],
            result=[files[whole(file)] for file in job.outputs],
            properties={"name": name, "description": describe_call(job), **times([job])},
        )
        for file in (job.log, run_time_of(job, run)):
            files[whole(file)]["about"] = actions[name]
    return actions


def add_calls(crate: ROCrate, run: Run, workflow: Entity, actions: Mapping[str, Entity]) -> None:
    """Add the run of the workflow, and of Snakemake that called the jobs.

    Parameters
    ----------
    crate : ROCrate
    run : Run
    workflow : Entity
        As `add_workflow` gives.
    actions : mapping of str to Entity
        As `add_jobs` gives.
    """
    configuration = add_file(
        crate, run.configuration, "configuration.yaml", description="What was computed."
    )
    whole_run = crate.add_action(
        workflow,
        "#run",
        object=[configuration],
        result=[made for action in actions.values() for made in action["result"]],
        properties={
            "name": "The whole run",
            "description": "snakemake --configfile configuration.yaml",
            **times(run.jobs),
        },
    )
    engine = crate.get(package_identifier("snakemake"))
    controls = [
        add_thing(
            crate,
            f"#control-{name_of(job, run)}",
            "ControlAction",
            name=f"Snakemake calls {name_of(job, run)}",
            instrument={"@id": f"#step-{job.rule}"},
            object=actions[name_of(job, run)],
        )
        for job in run.jobs
    ]
    crate.add_action(
        engine,
        "#snakemake",
        object=controls,
        result=whole_run,
        properties={
            "@type": "OrganizeAction",
            "name": "Snakemake runs the workflow",
            **times(run.jobs),
        },
    )
    crate.root_dataset["mentions"] = [whole_run, *actions.values()]


def times(jobs: list[Job]) -> dict[str, str]:
    """When the first of some jobs started and the last ended."""
    return {
        "startTime": min(job.start for job in jobs).isoformat(),
        "endTime": max(job.end for job in jobs).isoformat(),
    }


def describe_call(job: Job) -> str:
    """When which step was called with which arguments, and the software it used, as far as noted.

    The first line of a log says the former (`step.describe_call`), a dataset the latter.
    """
    with open(job.log, encoding="utf-8") as log:
        said = [log.readline().strip()]
    for file in job.outputs:
        if file.endswith(".nc"):
            attributes = read_dataset(file).attrs
            versions = f"{attributes['code_version']}, {attributes['software']}"
            said.append(f"{Path(file).name}: {versions}")
    return "\n".join(said)
