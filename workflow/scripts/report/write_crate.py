"""Write the crate of a finished run: a Workflow Run RO-Crate, one archive that others can rerun.

It holds the code, the configuration, the environment, and all results with sizes and digests.  Each
job is described by its script, inputs, outputs, times, log and run time.  Snakemake notes the jobs
in the folder ``.snakemake``, so this step runs where the workflow ran.

The crate follows the profile https://w3id.org/ro/wfrun/provenance/0.5.  Each rule is a step of the
workflow, and its script is the tool of that step.  One action describes the whole run, and one more
each job.  A job of an earlier call keeps the times of that call.  Nothing says who started the run.
"""

import hashlib
import io
import os
import platform
import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import distributions, version
from mimetypes import MimeTypes
from pathlib import Path
from typing import Any

import yaml
from rocrate.model.entity import Entity
from rocrate.rocrate import ROCrate
from snakemake.io import IOFile
from snakemake.persistence import MetadataRecord
from snakemake.persistence.file import FilePersistence

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import complete_file
from step import run_step

PROJECT = Path(__file__).parents[3]

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
"""Terms of the profiles that RO-Crate 1.1 lacks, written out so that nobody must fetch them."""

MEDIA_TYPES = {".md": "text/markdown", ".npz": "application/zip", ".rst": "text/x-rst"}
MEDIA_TYPES |= dict.fromkeys([".cff", ".yaml", ".yml"], "application/yaml")
MEDIA_TYPES |= {".nc": "application/netcdf", ".toml": "application/toml"}
"""Types that Python does not know; a file of any other unknown type is plain text."""

DESCRIPTION = (
    "The workflow, its configuration and environment, every job that ran, all results, and the "
    "manual, which begins in docs/index.md. To run it again, unpack it and call: make "
    ".venv/installed; .venv/bin/snakemake -c2 --configfile configuration.yaml --config "
    "results=again"
)


def write_crate(
    files: list[Path],
    sources: list[Path],
    results: Path,
    configuration: dict,
    scripts: dict,
    archive: Path,
) -> None:
    """Collect and describe a run in a ZIP file.

    `files` are results of the run in the folder `results`; `sources` are files of the project.
    `configuration` is the merged one, and `scripts` names the script of each rule.  A ValueError
    says that Snakemake does not know how a result was made.
    """
    jobs = jobs_behind(map(str, files), results)
    text = yaml.safe_dump(configuration, sort_keys=False, allow_unicode=True)
    with complete_file(archive) as unfinished:
        describe_run(PROJECT, sources, results, text, scripts, jobs).write_zip(unfinished)


@dataclass(frozen=True)
class Job:
    """One finished job; its log and its benchmark have the same name."""

    name: str
    rule: str
    inputs: list[str]
    outputs: list[str]
    log: str
    benchmark: str
    start: datetime
    end: datetime


def jobs_behind(files: Iterable[str], results: Path) -> list[Job]:
    """Find the jobs that made some files, and the jobs that made their inputs."""
    persistence = FilePersistence(nolock=True)
    outputs_by_log: dict[str, dict[str, MetadataRecord]] = defaultdict(dict)
    waiting, seen = set(files), set()
    while waiting:
        seen.add(file := waiting.pop())
        if noted := persistence.metadata(IOFile(file)):
            outputs_by_log[noted.log[0]][file] = noted
            waiting |= set(noted.input) - seen
        # Snakemake notes nothing on benchmarks.
        elif results in Path(file).parents and results / "benchmarks" not in Path(file).parents:
            raise ValueError(
                f"Snakemake does not know how {file} was made: remove {results} and run the "
                "workflow again."
            )
    jobs = (_make_job(log, outputs, results) for log, outputs in outputs_by_log.items())
    return sorted(jobs, key=lambda job: (job.start, job.log))


def _make_job(log: str, outputs: dict[str, MetadataRecord], results: Path) -> Job:
    """Make one job from the notes of Snakemake on its outputs."""
    name = Path(log).relative_to(results / "logs").with_suffix("").as_posix()
    noted = list(outputs.values())
    start, end = min(each.starttime for each in noted), max(each.endtime for each in noted)
    return Job(
        name=name,
        rule=noted[0].rule,
        inputs=sorted({file for each in noted for file in each.input}),
        outputs=sorted(outputs),
        log=log,
        benchmark=str(results / "benchmarks" / f"{name}.tsv"),
        start=datetime.fromtimestamp(round(start), tz=UTC),
        end=datetime.fromtimestamp(round(end), tz=UTC),
    )


def describe_run(
    project: Path,
    sources: list[Path],
    results: Path,
    configuration: str,
    scripts: dict[str, str],
    jobs: list[Job],
) -> ROCrate:
    """Describe the jobs and all files of a run; the configuration is YAML text."""
    crate = ROCrate(version="1.1")
    crate.metadata.extra_terms.update(TERMS)
    made = [file for job in jobs for file in (*job.outputs, job.log, job.benchmark)]
    places = {_absolute(file): "results" / Path(file).relative_to(results) for file in made}
    places |= {_absolute(file): _absolute(file).relative_to(project) for file in sources}
    del places[project / "Snakefile"]
    files = {
        file: crate.add_file(file, place, properties=_about(file.read_bytes(), str(place)))
        for file, place in places.items()
    }
    cited = _add_citation(crate, project)
    tools = {job.rule: files[project / scripts[job.rule]] for job in jobs}
    for tool in tools.values():
        tool.properties()["@type"] = ["File", "SoftwareSourceCode"]
        tool["version"] = cited["version"]
    versions = {one.metadata["Name"]: one.version for one in distributions()}
    installed = [f"{name}=={versions[name]}\n" for name in sorted(versions, key=str.lower)]
    _add_text(crate, "".join(installed), "installed.txt", "What was installed.")
    environment = files[project / "environment.txt"]
    environment["description"] = "Every package with its version and digest, as pip installs it."
    address = "https://pip.pypa.io/en/stable/reference/requirements-file-format/"
    environment["conformsTo"] = _add(
        crate, address, "WebPage", name="Requirements file format of pip"
    )
    steps = [
        _add(crate, f"#step-{rule}", "HowToStep", name=rule, position=str(k), workExample=tool)
        for k, (rule, tool) in enumerate(tools.items(), start=1)
    ]
    main = project / "Snakefile"
    about = _about(main.read_bytes(), "Snakefile") | cited
    about |= {"@type": ["File", "SoftwareSourceCode", "ComputationalWorkflow", "HowTo"]}
    about |= {"step": steps, "hasPart": [*dict.fromkeys(tools.values())]}
    software = _add_software(crate)
    about |= {"buildInstructions": environment, "softwareRequirements": software}
    language = {"lang": "snakemake", "lang_version": version("snakemake")}
    workflow = crate.add_workflow(main, "Snakefile", properties=about, main=True, **language)
    actions = _add_jobs(crate, jobs, files, tools)
    chosen = _add_text(crate, configuration, "configuration.yaml", "What was computed.")
    about = {"name": "The whole run", "description": "snakemake --configfile configuration.yaml"}
    outputs = [file for action in actions for file in action["result"]]
    run = crate.add_action(workflow, "#run", [chosen], outputs, about | _times(jobs))
    about = {"@type": "OrganizeAction", "name": "Snakemake runs the workflow", **_times(jobs)}
    controls = crate.get_by_type("ControlAction")
    crate.add_action(software[0], "#snakemake", controls, run, about)

    root = crate.root_dataset
    files[project / "README.md"]["about"] = root
    root["name"], root["description"] = f"A run of {cited['name']}", DESCRIPTION
    root["datePublished"] = max(job.end for job in jobs).date().isoformat()
    root["mentions"] = [run, *actions]
    root["conformsTo"] = [
        _add(crate, address, "CreativeWork", name=name, version=address.rpartition("/")[2])
        for address, name in PROFILES.items()
    ]
    for key in ("author", "license", "citation"):
        root[key] = cited[key]
    for entity in crate.get_entities():
        for key, value in entity.properties().items():
            # RO-Crate recommends to take a single value out of its list.
            if isinstance(value, list) and len(value) == 1:
                entity.properties()[key] = value[0]
    return crate


def _absolute(file: Path | str) -> Path:
    return Path(os.path.abspath(file))


def _add(crate: ROCrate, identifier: str, kind: str, **properties: Any) -> Entity:
    """Add an entity that is no file; its identifier is an address or begins with ``#``."""
    return crate.add_jsonld({"@id": identifier, "@type": kind, **properties})


def _about(content: bytes, name: str) -> dict[str, Any]:
    """Return name, media type, size and digest of a file."""
    known = MEDIA_TYPES.get(Path(name).suffix) or MimeTypes().guess_type(name)[0]
    return {
        "name": name,
        "encodingFormat": known or "text/plain",
        "contentSize": str(len(content)),
        "sha256": hashlib.sha256(content).hexdigest(),
    }


def _add_text(crate: ROCrate, text: str, name: str, description: str) -> Entity:
    """Add a file that exists only in the crate."""
    properties = _about(text.encode(), name) | {"description": description}
    return crate.add_file(io.StringIO(text), name, properties=properties)


def _add_citation(crate: ROCrate, project: Path) -> dict[str, Any]:
    """Add authors, licence and paper from CITATION.cff."""
    cited = yaml.safe_load((project / "CITATION.cff").read_text(encoding="utf-8"))
    licence, [paper] = cited["license"], cited["references"]
    about = {"name": paper["title"], "datePublished": str(paper["year"])}
    about["author"] = _add_authors(crate, paper["authors"])
    return {
        "name": cited["title"],
        "version": cited["version"],
        "author": _add_authors(crate, cited["authors"]),
        "license": _add(
            crate, f"https://spdx.org/licenses/{licence}", "CreativeWork", name=licence
        ),
        "citation": _add(crate, f"https://doi.org/{paper['doi']}", "ScholarlyArticle", **about),
    }


def _add_authors(crate: ROCrate, authors: list[dict[str, str]]) -> list[Entity]:
    """Add the authors of a work: a person has a family name, a group does not."""
    added = []
    for author in authors:
        kind = "Person" if "family-names" in author else "Organization"
        name = author.get("name") or f"{author['given-names']} {author['family-names']}"
        added.append(_add(crate, f"#{re.sub('[^a-z]+', '-', name.lower())}", kind, name=name))
    return added


def _add_software(crate: ROCrate) -> list[Entity]:
    """Add Snakemake and Python; `installed.txt` lists all packages."""
    address, kind, number = "https://www.python.org", "SoftwareApplication", version("snakemake")
    about = {"name": "Python", "url": address, "softwareVersion": platform.python_version()}
    about["operatingSystem"] = f"{platform.system()} {platform.machine()}"
    package = f"pkg:pypi/snakemake@{number}"
    return [
        _add(crate, package, kind, name="snakemake", softwareVersion=number),
        _add(crate, address, kind, **about),
    ]


def _add_jobs(
    crate: ROCrate, jobs: list[Job], files: dict[Path, Entity], tools: dict[str, Entity]
) -> list[Entity]:
    """Add each job with its files, and its call by Snakemake."""
    actions = []
    for job in jobs:
        read, written, notes = (
            [files[_absolute(file)] for file in names]
            for names in (job.inputs, job.outputs, (job.log, job.benchmark))
        )
        about = {"name": job.name, "description": _describe_call(job), **_times([job])}
        action = crate.add_action(tools[job.rule], f"#job-{job.name}", read, written, about)
        for file in notes:
            file["about"] = action
        call = {"name": f"Snakemake calls {job.name}", "instrument": {"@id": f"#step-{job.rule}"}}
        _add(crate, f"#control-{job.name}", "ControlAction", object=action, **call)
        actions.append(action)
    return actions


def _times(jobs: list[Job]) -> dict[str, str]:
    """Return the start of the first of some jobs and the end of the last."""
    start, end = min(job.start for job in jobs), max(job.end for job in jobs)
    return {"startTime": start.isoformat(), "endTime": end.isoformat()}


def _describe_call(job: Job) -> str:
    """Return the first line of a job's log, and the software that made its datasets."""
    lines = [Path(job.log).read_text(encoding="utf-8").partition("\n")[0].strip()]
    for file in map(Path, job.outputs):
        if file.suffix == ".nc":
            attributes = read_dataset(file).attrs
            lines.append(f"{file.name}: {attributes['code_version']}, {attributes['software']}")
    return "\n".join(lines)


if __name__ == "__main__":
    run_step(write_crate, globals().get("snakemake"))
