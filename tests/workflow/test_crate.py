"""The crate of a run: its jobs, its files, and what it takes to repeat the run."""

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

# Those of the validator and its libraries.
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")

RULE = """
rule {name}:
    input: {inputs}
    output: "results/{name}.txt"
    log: "results/logs/{name}.log"
    benchmark: "results/benchmarks/{name}.tsv"
    shell: "sleep 1; echo {name} | tee {{log}} > {{output}}"
"""
NEEDED = ["CITATION.cff", "README.md", "Snakefile", "environment.txt", "given.txt"]


def test_jobs_are_found_from_the_last_result_and_described(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in NEEDED[:-1]:
        shutil.copy(ROOT / name, tmp_path)
    Path("given.txt").touch()
    late = RULE.format(name="late", inputs='"results/early.txt", "given.txt"')
    Path("Snakefile").write_text(late + RULE.format(name="early", inputs=""))
    run = snakemake("results/late.txt", folder=tmp_path)
    assert run.returncode == 0, run.stderr
    results, wanted = Path("results"), ["results/late.txt", "results/benchmarks/late.tsv"]
    early, late = jobs = jobs_behind(wanted, results)
    assert (early.rule, early.inputs, early.outputs) == ("early", [], ["results/early.txt"])
    assert (late.inputs, late.log) == (["given.txt", "results/early.txt"], "results/logs/late.log")
    assert early.start < early.end <= late.start < late.end
    sources, scripts = map(Path, NEEDED), dict.fromkeys(["early", "late"], "given.txt")
    crate = describe_run(tmp_path, [*sources], results, "results: results\n", scripts, jobs)
    job, whole, root = crate.get("#job-late"), crate.get("#run"), crate.root_dataset
    assert [file.id for file in job["object"]] == ["given.txt", "results/early.txt"]
    assert (job["result"].id, job["description"]) == ("results/late.txt", "late")
    assert crate.get("results/benchmarks/late.tsv")["about"] == job
    assert crate.get("#control-late")["instrument"].id == "#step-late"
    assert crate.get("#step-late")["workExample"] == job["instrument"] == crate.get("given.txt")
    assert whole["startTime"] == early.start.isoformat()
    assert whole["endTime"] == job["endTime"] == late.end.isoformat()
    assert [file.id for file in whole["result"]] == ["results/early.txt", "results/late.txt"]
    assert root["license"].id == "https://spdx.org/licenses/BSD-3-Clause"
    assert root["author"]["name"] in (ROOT / "CITATION.cff").read_text("utf-8")
    Path("results/strange.txt").touch()
    with pytest.raises(ValueError, match=r"results/strange\.txt"):
        jobs_behind(["results/strange.txt"], results)


def test_every_link_of_a_page_leads_to_a_file_of_the_crate():
    names = {"Path": Path, "PROJECT": ROOT, "project": lambda file: file.relative_to(ROOT)}
    exec((ROOT / "workflow/rules/project_files.smk").read_text("utf-8"), names)
    files = set(names["project_files"](None))
    assert not any({"_build", "__pycache__", "generated"} & {*file.parts} for file in files)
    for page in (ROOT / file for file in files if file.suffix == ".md"):
        for link in re.findall(r"\]\((?!https?:|#)([^)#\s]+)", page.read_text("utf-8")):
            # The build of the manual writes pages in the folder `generated`.
            found = (page.parent / link).resolve().relative_to(ROOT)
            assert found in files or "generated" in link, (page, link)


@pytest.mark.slow
def test_crate_of_a_run_is_valid_whole_and_enough_to_repeat_it(finished, tmp_path):
    """Code and configuration of the crate give its data, bit by bit."""
    smoke = ["--configfile", "config/smoke.yaml", "--", "crate"]
    run = snakemake(*smoke, folder=finished)
    assert run.returncode == 0, run.stderr
    unpacked, results = tmp_path / "copy", finished / "results/smoke"
    with zipfile.ZipFile(results / "crate.zip") as archive:
        archive.extractall(unpacked)
        held = {*archive.namelist()} - {"ro-crate-metadata.json"}
    assert violations(unpacked) == set()
    graph = json.loads((unpacked / "ro-crate-metadata.json").read_text("utf-8"))["@graph"]
    entities = {entity["@id"]: entity for entity in graph}
    assert held == {name for name, entity in entities.items() if "File" in entity["@type"]}
    for name in held:
        content = (unpacked / name).read_bytes()
        assert entities[name]["contentSize"] == str(len(content))
        assert entities[name]["sha256"] == hashlib.sha256(content).hexdigest()
    folder = results / "benchmarks"
    jobs = {f"#job-{file.relative_to(folder).with_suffix('')}" for file in folder.rglob("*.tsv")}
    assert jobs - {name for name in entities if name.startswith("#job-")} == {"#job-write_crate"}
    lend_kernels(unpacked)
    again = ["--configfile", "configuration.yaml", "--config", "results=again", "--", "fig03"]
    run = snakemake(*again, folder=unpacked)
    assert run.returncode == 0, run.stderr
    scene = ["chain/initiation_overdamped"]
    kept, made = (read_sources(unpacked / place / "data", scene) for place in ("results", "again"))
    assert kept == made != {}
