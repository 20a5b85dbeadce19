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
from write_crate import describe_run, jobs_behind

from granular_fronts.output.datasets import read_sources

# The validator's own, and those of the libraries that it stands on.
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")

SNAKEFILE = """
rule late:
    input: "results/early.txt", "given.txt"
    output: "results/late.txt"
    log: "results/logs/late.log"
    benchmark: "results/benchmarks/late.tsv"
    shell: "sleep 1; cat {input} > {output}; echo late > {log}"
rule early:
    output: "results/early.txt"
    log: "results/logs/early.log"
    benchmark: "results/benchmarks/early.tsv"
    shell: "sleep 1; echo early | tee {log} > {output}"
"""
NEEDED = ["CITATION.cff", "README.md", "Snakefile", "environment.txt", "pyproject.toml"]
RESULTS = Path("results")


@pytest.fixture
def small(tmp_path, monkeypatch):
    """A folder in which two jobs have run, as the working directory."""
    monkeypatch.chdir(tmp_path)
    for name in NEEDED:
        shutil.copy(ROOT / name, tmp_path)
    Path("Snakefile").write_text(SNAKEFILE)
    Path("given.txt").write_text("given\n")
    run = snakemake("results/late.txt", folder=tmp_path)
    assert run.returncode == 0, run.stderr
    return tmp_path


def test_jobs_are_found_from_the_last_result_and_told_with_what_they_read_and_wrote(small):
    early, late = jobs = jobs_behind(["results/late.txt", "results/benchmarks/late.tsv"], RESULTS)
    assert (early.rule, early.inputs, early.outputs) == ("early", [], ["results/early.txt"])
    assert (late.inputs, late.log) == (["given.txt", "results/early.txt"], "results/logs/late.log")
    assert early.start < early.end <= late.start < late.end
    # Both rules ran the same script.
    sources = [Path(name) for name in [*NEEDED, "given.txt"]]
    scripts = dict.fromkeys(["early", "late"], "given.txt")
    crate = describe_run(small, sources, RESULTS, "results: results\n", scripts, jobs)
    job = crate.get("#job-late")
    assert [file.id for file in job["object"]] == ["given.txt", "results/early.txt"]
    assert (job["result"].id, job["description"]) == ("results/late.txt", "late")
    assert crate.get("results/benchmarks/late.tsv")["about"] == job
    assert crate.get("#control-late")["instrument"].id == "#step-late"
    assert crate.get("#step-late")["workExample"] == job["instrument"] == crate.get("given.txt")
    whole, root = crate.get("#run"), crate.root_dataset
    assert whole["startTime"] == early.start.isoformat()
    assert whole["endTime"] == job["endTime"] == late.end.isoformat()
    assert [file.id for file in whole["result"]] == ["results/early.txt", "results/late.txt"]
    assert root["license"].id == "https://spdx.org/licenses/BSD-3-Clause"
    assert root["author"]["name"] in (ROOT / "CITATION.cff").read_text("utf-8")
    assert crate.get("CITATION.cff")["encodingFormat"] == "application/yaml"
    (small / "results/strange.txt").touch()
    with pytest.raises(ValueError, match=r"results/strange\.txt"):
        jobs_behind(["results/strange.txt"], RESULTS)


def project_files(project=ROOT):
    """Files of a project in its records, by the rules of the workflow."""
    rules = (ROOT / "workflow/rules/project_files.smk").read_text(encoding="utf-8")
    names = {"Path": Path, "PROJECT": project, "project": lambda file: file.relative_to(project)}
    exec(rules, names)
    return set(names["project_files"](None))


def test_every_link_of_a_page_leads_to_a_file_of_the_record_and_nothing_built_is_in_it(tmp_path):
    files = project_files()
    for page in (file for file in files if file.suffix == ".md"):
        for link in re.findall(r"\]\((?!https?:|#)([^)#\s]+)", (ROOT / page).read_text("utf-8")):
            # The build of the manual writes these.
            if "generated" not in link:
                assert (ROOT / page.parent / link).resolve().relative_to(ROOT) in files, (
                    page,
                    link,
                )
    built = ["docs/_build/index.html", "docs/generated/page.md", "src/__pycache__/module.pyc"]
    for name in ["docs/index.md", *built, "results/report.html", ".venv/installed"]:
        file = tmp_path / "generated" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    assert project_files(tmp_path / "generated") == {Path("docs/index.md")}


@pytest.mark.slow
def test_record_of_a_run_is_valid_whole_and_enough_to_repeat_it(finished, tmp_path):
    """Code and configuration of the record give the data of the record, bit by bit."""
    smoke = ["--configfile", "config/smoke.yaml", "--", "crate"]
    run = snakemake(*smoke, folder=finished)
    assert run.returncode == 0, run.stderr
    unpacked, results = tmp_path / "copy", finished / "results/smoke"
    with zipfile.ZipFile(results / "crate.zip") as archive:
        archive.extractall(unpacked)
    assert violations(unpacked, tmp_path) == set()
    graph = json.loads((unpacked / "ro-crate-metadata.json").read_text("utf-8"))["@graph"]
    entities = {entity["@id"]: entity for entity in graph}
    files = {path.relative_to(unpacked).as_posix(): path for path in unpacked.rglob("*")}
    files = {name: path.read_bytes() for name, path in files.items() if path.is_file()}
    del files["ro-crate-metadata.json"]
    assert files.keys() == {name for name, each in entities.items() if "File" in each["@type"]}
    for name, content in files.items():
        assert entities[name]["contentSize"] == str(len(content))
        assert entities[name]["sha256"] == hashlib.sha256(content).hexdigest()
    folder = results / "benchmarks"
    ran = {path.relative_to(folder).with_suffix("").as_posix() for path in folder.rglob("*.tsv")}
    described = {name.removeprefix("#job-") for name in entities if name.startswith("#job-")}
    assert described == ran - {"write_crate"}
    (results / "tables/findings.md").unlink()
    due = snakemake("--dry-run", *smoke, folder=finished).stdout
    assert re.search(r"^tabulate_findings +1$(.|\n)*^write_crate +1$", due, re.MULTILINE)
    lend_kernels(unpacked)
    again = ["--configfile", "configuration.yaml", "--config", "results=again", "--", "fig03"]
    run = snakemake(*again, folder=unpacked)
    assert run.returncode == 0, run.stderr
    scene = ["chain/initiation_overdamped"]
    kept, made = (read_sources(unpacked / place / "data", scene) for place in ("results", "again"))
    assert kept == made != {}
