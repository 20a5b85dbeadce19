"""A run as a Provenance Run Crate: https://w3id.org/ro/wfrun/provenance/0.5.

The workflow has a step for each rule, and a step a tool, the rule's script.  What ran is described
by actions: one for the whole run, and one for each job with its inputs, outputs, log and run time.
Only what is known is said: who started the run is not, and a job that an earlier call has run
stands there with the times of that call.  The names of types and properties are those of schema.org
and of RO-Crate 1.1.
"""

import hashlib
import io
import os
import platform
import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

import yaml
from rocrate.model.entity import Entity
from rocrate.rocrate import ROCrate

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

FORMATS = {
    ".cff": "application/yaml",
    ".csv": "text/csv",
    ".gif": "image/gif",
    ".html": "text/html",
    ".js": "text/javascript",
    ".json": "application/json",
    ".md": "text/markdown",
    ".nc": "application/netcdf",
    ".npz": "application/zip",
    ".pdf": "application/pdf",
    ".png": "image/png",
    ".py": "text/x-python",
    ".rst": "text/x-rst",
    ".svg": "image/svg+xml",
    ".toml": "application/toml",
    ".tsv": "text/tab-separated-values",
    ".yaml": "application/yaml",
    ".yml": "application/yaml",
}
"""Media types by the ending of a name, on every machine alike; all other files are plain text."""

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

    def name_of(self, job: Job) -> str:
        """The name of a job, which is that of its log."""
        return Path(job.log).relative_to(self.results / "logs").with_suffix("").as_posix()

    def run_time_of(self, job: Job) -> str:
        """The file with the run time of a job."""
        return str(self.results / "benchmarks" / f"{self.name_of(job)}.tsv")


def describe_run(run: Run) -> ROCrate:
    """Describe a run with all its files, to be written as a folder or an archive."""
    crate = ROCrate(version="1.1")
    crate.metadata.extra_terms.update(TERMS)
    files = _add_files(crate, run)
    cited = _add_citation(crate, run.project)
    workflow = _add_workflow(crate, run, files, cited)
    actions = _add_jobs(crate, run, files)
    _add_calls(crate, run, workflow, actions)
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
        _add(crate, address, "CreativeWork", name=name, version=address.rpartition("/")[2])
        for address, name in PROFILES.items()
    ]
    for key in ("author", "license", "citation"):
        root[key] = cited[key]
    for entity in crate.get_entities():
        _state_singly(entity.properties())
    return crate


def _state_singly(properties: dict[str, Any]) -> None:
    """Take single values out of their lists, as RO-Crate recommends."""
    for key, value in properties.items():
        if isinstance(value, list) and len(value) == 1:
            properties[key] = value[0]


def _add(crate: ROCrate, identifier: str, kind: str, **properties: Any) -> Entity:
    """Add what is no file, under an address or a name that begins with ``#``."""
    return crate.add_jsonld({"@id": identifier, "@type": kind, **properties})


def _described(content: bytes, name: str) -> dict[str, str]:
    """Name, media type and digest of a file."""
    return {
        "name": name,
        "encodingFormat": FORMATS.get(Path(name).suffix, "text/plain"),
        "sha256": hashlib.sha256(content).hexdigest(),
    }


def _add_text(crate: ROCrate, text: str, name: str, description: str) -> Entity:
    """Add a file that is written into the crate alone."""
    properties = {**_described(text.encode(), name), "description": description}
    return crate.add_file(io.StringIO(text), name, properties=properties, record_size=True)


def _add_files(crate: ROCrate, run: Run) -> dict[Path, Entity]:
    """Add every file of the project and of the results, but not the main workflow."""
    made = [file for job in run.jobs for file in (*job.outputs, job.log, run.run_time_of(job))]
    places = {_whole(file): Path("results", Path(file).relative_to(run.results)) for file in made}
    places |= {file: file.relative_to(run.project) for file in map(_whole, run.sources)}
    del places[run.project / "Snakefile"]
    return {
        file: crate.add_file(
            file,
            place.as_posix(),
            properties=_described(file.read_bytes(), place.as_posix()),
            record_size=True,
        )
        for file, place in places.items()
    }


def _whole(file: Path | str) -> Path:
    """The absolute path of a file."""
    return Path(os.path.abspath(file))


def _add_citation(crate: ROCrate, project: Path) -> dict[str, Any]:
    """Add authors, licence and the paper, as CITATION.cff names them."""
    cited = yaml.safe_load((project / "CITATION.cff").read_text(encoding="utf-8"))
    licence, address = cited["license"], f"https://spdx.org/licenses/{cited['license']}"
    papers = [
        _add(
            crate,
            f"https://doi.org/{paper['doi']}",
            "ScholarlyArticle",
            name=paper["title"],
            author=_add_authors(crate, paper["authors"]),
            datePublished=str(paper["year"]),
        )
        for paper in cited["references"]
    ]
    return {
        "name": cited["title"],
        "version": cited["version"],
        "author": _add_authors(crate, cited["authors"]),
        "license": _add(crate, address, "CreativeWork", name=licence),
        "citation": papers,
    }


def _add_authors(crate: ROCrate, authors: Iterable[dict[str, str]]) -> list[Entity]:
    """Add the authors of a work: a person has a family name, a group has one name."""
    return [
        _add(
            crate,
            f"#{re.sub(r'[^a-z]+', '-', name.lower())}",
            "Person" if "family-names" in author else "Organization",
            name=name,
        )
        for author in authors
        for name in [author.get("name") or f"{author['given-names']} {author['family-names']}"]
    ]


def _add_software(crate: ROCrate, project: Path) -> list[Entity]:
    """Add Python and the packages that a run depends on, with the versions installed here."""
    python = _add(
        crate,
        "https://www.python.org",
        "SoftwareApplication",
        name="Python",
        url="https://www.python.org",
        softwareVersion=platform.python_version(),
        operatingSystem=f"{platform.system()} {platform.machine()}",
    )
    described = tomllib.loads((project / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needed = [*described["dependencies"], *described["optional-dependencies"]["workflow"]]
    names = sorted(re.split(r"[^\w.-]", line)[0] for line in needed)
    packages = (
        _add(
            crate,
            _package_url(name),
            "SoftwareApplication",
            name=name,
            softwareVersion=metadata.version(name),
        )
        for name in names
    )
    return [python, *packages]


def _package_url(name: str) -> str:
    """What names an installed Python package and its version."""
    return f"pkg:pypi/{name}@{metadata.version(name)}"


def _installed_packages() -> str:
    """Every installed Python package with its version, as lines that pip can read."""
    found = {one.metadata["Name"]: one.version for one in metadata.distributions()}
    return "".join(f"{name}=={found[name]}\n" for name in sorted(found, key=str.lower))


def _add_workflow(
    crate: ROCrate, run: Run, files: Mapping[Path, Entity], cited: Mapping[str, Any]
) -> Entity:
    """Add the workflow with its steps and their tools, which are scripts."""
    tools = {job.rule: files[run.script_of(job.rule)] for job in run.jobs}
    for tool in tools.values():
        tool.properties()["@type"] = ["File", "SoftwareSourceCode"]
        tool["version"] = cited["version"]
    steps = [
        _add(
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
    environment["conformsTo"] = _add(
        crate, REQUIREMENTS_FORMAT, "WebPage", name="Requirements file format of pip"
    )
    _add_text(crate, _installed_packages(), "installed.txt", "What was installed.")
    main = run.project / "Snakefile"
    return crate.add_workflow(
        main,
        "Snakefile",
        main=True,
        lang="snakemake",
        lang_version=metadata.version("snakemake"),
        properties={
            **_described(main.read_bytes(), "Snakefile"),
            "contentSize": str(main.stat().st_size),
            **cited,
            "@type": ["File", "SoftwareSourceCode", "ComputationalWorkflow", "HowTo"],
            "hasPart": [files[file] for file in sorted({run.script_of(rule) for rule in tools})],
            "step": steps,
            "buildInstructions": environment,
            "softwareRequirements": _add_software(crate, run.project),
        },
    )


def _add_jobs(crate: ROCrate, run: Run, files: Mapping[Path, Entity]) -> dict[str, Entity]:
    """Add the jobs with what they read and wrote; log and run time are about them."""
    actions = {}
    for job in run.jobs:
        name = run.name_of(job)
        actions[name] = crate.add_action(
            files[run.script_of(job.rule)],
            f"#job-{name}",
            object=[files[_whole(file)] for file in job.inputs],
            result=[files[_whole(file)] for file in job.outputs],
            properties={"name": name, "description": _describe_call(job), **times([job])},
        )
        for file in (job.log, run.run_time_of(job)):
            files[_whole(file)]["about"] = actions[name]
    return actions


def _add_calls(crate: ROCrate, run: Run, workflow: Entity, actions: Mapping[str, Entity]) -> None:
    """Add the run of the workflow, and of Snakemake that called the jobs."""
    whole_run = crate.add_action(
        workflow,
        "#run",
        object=[_add_text(crate, run.configuration, "configuration.yaml", "What was computed.")],
        result=[made for action in actions.values() for made in action["result"]],
        properties={
            "name": "The whole run",
            "description": "snakemake --configfile configuration.yaml",
            **times(run.jobs),
        },
    )
    controls = [
        _add(
            crate,
            f"#control-{run.name_of(job)}",
            "ControlAction",
            name=f"Snakemake calls {run.name_of(job)}",
            instrument={"@id": f"#step-{job.rule}"},
            object=actions[run.name_of(job)],
        )
        for job in run.jobs
    ]
    named = {"@type": "OrganizeAction", "name": "Snakemake runs the workflow"}
    crate.add_action(
        crate.get(_package_url("snakemake")),
        "#snakemake",
        object=controls,
        result=whole_run,
        properties=named | times(run.jobs),
    )
    crate.root_dataset["mentions"] = [whole_run, *actions.values()]


def times(jobs: list[Job]) -> dict[str, str]:
    """When the first of some jobs started and the last ended."""
    return {
        "startTime": min(job.start for job in jobs).isoformat(),
        "endTime": max(job.end for job in jobs).isoformat(),
    }


def _describe_call(job: Job) -> str:
    """When which step was called with which arguments, and the software it used, as far as noted.

    The first line of a log says the former (`step.run_step`), a dataset the latter.
    """
    with open(job.log, encoding="utf-8") as log:
        said = [log.readline().strip()]
    for file in job.outputs:
        if file.endswith(".nc"):
            attributes = read_dataset(file).attrs
            versions = f"{attributes['code_version']}, {attributes['software']}"
            said.append(f"{Path(file).name}: {versions}")
    return "\n".join(said)
