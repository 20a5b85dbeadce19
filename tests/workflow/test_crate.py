"""The record of a run: what the jobs were, what it holds, and that it is what it claims to be."""

import hashlib
import json
import re
import shutil
import zipfile
from pathlib import Path

import pytest
from crates import violations
from projects import ROOT, lend_kernels, snakemake

from crate.jobs import jobs_behind
from crate.run import Run, describe_run
from granular_fronts.output.datasets import read_sources

# The validator's own, and those of the libraries that it stands on.
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")

UNKNOWN = {
    # Who started the run.
    "The Action SHOULD have an agent that is a Person or Organization",
    # The authors are a group without a page, and so is the publisher.
    "The organization SHOULD have a URL.",
    "The author SHOULD have an organizational affiliation.",
    "The author SHOULD have a Contextual Entity which specifies the organizational `affiliation`.",
    "The `publisher` property of a `Root Data Entity` SHOULD be an `Organization`",
    # A script has a path in the crate, and a package a package URL, which is no web address.
    "The Application SHOULD have a url",
    "The SoftwareApplication id SHOULD be an absolute URI",
    # That profile asks for an address of the workflow.
    "The Main Workflow SHOULD comply with Bioschemas ComputationalWorkflow profile version 1.0 "
    "or later",
}
"""Recommendations that cannot be followed, since what they ask for is not known."""

SNAKEFILE = """
rule late:
    input: "results/early.txt", "given.txt"
    output: "results/late.txt"
    log: "results/logs/late.log"
    benchmark: "results/benchmarks/late.tsv"
    shell: "cat {input} > {output}; echo late > {log}"
rule early:
    output: "results/early.txt"
    log: "results/logs/early.log"
    benchmark: "results/benchmarks/early.tsv"
    shell: "echo early | tee {log} > {output}"
"""

NEEDED = ["CITATION.cff", "README.md", "Snakefile", "environment.txt", "pyproject.toml"]


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    """A folder in which a workflow of two jobs has run."""
    folder = tmp_path_factory.mktemp("small")
    (folder / "Snakefile").write_text(SNAKEFILE)
    (folder / "given.txt").write_text("given\n")
    run = snakemake("results/late.txt", folder=folder)
    assert run.returncode == 0, run.stderr
    return folder


@pytest.fixture
def in_small(small, tmp_path, monkeypatch):
    """A copy of it, as the working directory."""
    copy = shutil.copytree(small, tmp_path / "small")
    monkeypatch.chdir(copy)
    return copy


def test_jobs_are_found_from_the_last_result(in_small):
    early, late = jobs_behind(["results/late.txt"], Path("results"))
    assert (early.rule, early.inputs, early.outputs) == ("early", (), ("results/early.txt",))
    assert late.inputs == ("given.txt", "results/early.txt")
    assert late.log == "results/logs/late.log"
    assert early.start <= early.end <= late.end


def test_result_without_a_record_is_refused(in_small):
    (in_small / "results/strange.txt").write_text("From elsewhere.")
    with pytest.raises(ValueError, match=r"no record of how results/strange\.txt was made"):
        jobs_behind(["results/strange.txt"], Path("results"))


@pytest.fixture
def described(in_small):
    """The run described as one of this project, both of whose rules ran the same script."""
    for name in NEEDED:
        shutil.copy(ROOT / name, in_small)
    (in_small / "tool.py").write_text("print()\n")
    return describe_run(
        Run(
            project=in_small,
            sources=[Path(name) for name in (*NEEDED, "tool.py", "given.txt")],
            results=Path("results"),
            configuration="results: results\n",
            scripts={"early": "tool.py", "late": "tool.py"},
            jobs=jobs_behind(["results/late.txt"], Path("results")),
        )
    )


@pytest.mark.slow
def test_crate_is_valid_and_follows_what_can_be_followed(described, tmp_path):
    described.write(tmp_path / "crate")
    required, recommended = violations(tmp_path / "crate", tmp_path)
    assert required == set()
    assert recommended <= UNKNOWN


def test_jobs_are_told_with_what_they_read_and_wrote(described):
    late = described.get("#job-late")
    assert [file.id for file in late["object"]] == ["given.txt", "results/early.txt"]
    assert late["result"].id == "results/late.txt"
    assert late["description"] == "late"
    assert described.get("results/benchmarks/late.tsv")["about"] == late
    assert described.get("#control-late")["instrument"].id == "#step-late"


def project_files(project=ROOT):
    """Files of a project in its records, by the rules of the workflow."""
    rules = (ROOT / "workflow/rules/project_files.smk").read_text(encoding="utf-8")
    names = {"Path": Path, "PROJECT": project, "project": lambda file: file.relative_to(project)}
    exec(rules, names)
    return set(names["project_files"](None))


def dead_links(files):
    """Links of pages, and addresses of pictures, that lead to none of the same files."""
    kept = {ROOT / file for file in files}
    return {
        (file.as_posix(), link)
        for file in files
        if file.suffix == ".md"
        for link in re.findall(r"\]\((?!https?:|#)([^)#\s]+)", (ROOT / file).read_text("utf-8"))
        # The build of the manual writes these.
        if "generated" not in link and (ROOT / file.parent / link).resolve() not in kept
    }


def test_every_link_of_a_page_leads_to_a_file_of_the_record():
    files = project_files()
    assert dead_links(files) == set()
    without_manual = dead_links({file for file in files if "docs" not in file.parts})
    assert {("README.md", "docs/front.gif"), ("README.md", "docs/start.md")} <= without_manual


def test_record_leaves_out_what_is_built(tmp_path):
    built = ["docs/_build/index.html", "docs/generated/page.md", "src/__pycache__/module.pyc"]
    for name in ["docs/index.md", *built, "results/report.html", ".venv/installed"]:
        file = tmp_path / "generated" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    assert project_files(tmp_path / "generated") == {Path("docs/index.md")}


@pytest.fixture(scope="module")
def unpacked(finished, tmp_path_factory):
    """The record of the smoke run, unpacked."""
    run = snakemake("--configfile", "config/smoke.yaml", "--", "crate", folder=finished)
    assert run.returncode == 0, run.stderr
    folder = tmp_path_factory.mktemp("crate") / "copy"
    with zipfile.ZipFile(finished / "results/smoke/crate.zip") as archive:
        archive.extractall(folder)
    return folder


@pytest.fixture(scope="module")
def entities(unpacked):
    """What the record says, by identifier."""
    text = (unpacked / "ro-crate-metadata.json").read_text(encoding="utf-8")
    return {entity["@id"]: entity for entity in json.loads(text)["@graph"]}


@pytest.mark.slow
def test_record_of_a_run_is_valid(unpacked, tmp_path):
    required, recommended = violations(unpacked, tmp_path)
    assert required == set()
    assert recommended <= UNKNOWN


@pytest.mark.slow
def test_record_names_every_file_with_its_size_and_digest(unpacked, entities):
    files = {
        path.relative_to(unpacked).as_posix() for path in unpacked.rglob("*") if path.is_file()
    }
    assert files - {"ro-crate-metadata.json"} == {
        name for name, entity in entities.items() if "File" in entity["@type"]
    }
    for name in files - {"ro-crate-metadata.json"}:
        content = (unpacked / name).read_bytes()
        assert entities[name]["contentSize"] == str(len(content))
        assert entities[name]["sha256"] == hashlib.sha256(content).hexdigest()


@pytest.mark.slow
def test_record_names_every_job_of_the_run(finished, entities):
    run_times = finished / "results/smoke/benchmarks"
    ran = {
        path.relative_to(run_times).with_suffix("").as_posix() for path in run_times.rglob("*.tsv")
    }
    jobs = {name for name in entities if name.startswith("#job-")}
    assert jobs == {f"#job-{name}" for name in ran - {"write_crate"}}


@pytest.mark.slow
def test_record_is_made_again_when_a_result_is(finished):
    (finished / "results/smoke/tables/findings.md").unlink()
    run = snakemake(
        "--dry-run", "--configfile", "config/smoke.yaml", "--", "crate", folder=finished
    )
    due = set(re.findall(r"^(\w+) +\d+$", run.stdout, re.MULTILINE))
    assert due >= {"tabulate_findings", "write_crate"}


@pytest.mark.slow
def test_run_is_repeated_from_its_record_alone(unpacked):
    """Code and configuration of the record give the data of the record, bit by bit."""
    lend_kernels(unpacked)
    asked = ["--configfile", "configuration.yaml", "--config", "results=again", "--", "fig03"]
    run = snakemake(*asked, folder=unpacked)
    assert run.returncode == 0, run.stderr
    kept, made = (
        read_sources(unpacked / results / "data", ["chain/initiation_overdamped"])
        for results in ("results", "again")
    )
    assert kept == made != []
