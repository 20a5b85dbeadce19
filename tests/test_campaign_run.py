"""Campaigns through the workflow: refused, run, interrupted, grown."""

import csv
import os
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import yaml
from projects import ROOT, copy_project

from granular_fronts.datasets import read_dataset

CAMPAIGN = {
    "kind": "chain",
    "axes": {"delta": [0.1, 0.2, 0.4, 0.8], "gamma": {"linspace": [0.1, 1.0, 100]}},
    "fixed": {"alpha": 1.5, "beads": 420},
    "tolerance": 1.0e-6,
    "chunk_points": 100,
}


def command_of(*arguments):
    return [sys.executable, "-m", "snakemake", "--cores", "1", "campaign", *map(str, arguments)]


def run_campaign(folder, *arguments, name="mine"):
    command = command_of(*arguments, "--config", f"campaign={name}")
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def write_campaign(folder, **changes):
    file = folder / "config/campaigns/mine.yaml"
    file.write_text(yaml.safe_dump({**CAMPAIGN, **changes}, sort_keys=False))


def jobs_of(run):
    """Number of jobs of each rule, from what a run tells at its start."""
    assert run.returncode == 0, run.stderr
    found = re.findall(r"^(\w+) +(\d+)$", run.stdout + run.stderr, re.MULTILINE)
    return {name: int(count) for name, count in found}


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project, with nothing computed."""
    return copy_project(tmp_path_factory.mktemp("project"))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--config", "campaign=nosuch"], ["There is no campaign nosuch", "smoke"]),
        ([], ["Name the campaign", "--config campaign=smoke"]),
    ],
    ids=["unknown", "unnamed"],
)
def test_campaign_that_is_not_there_is_refused_in_a_sentence(arguments, words):
    command = command_of("--dry-run", *arguments)
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert run.returncode != 0
    for word in words:
        assert word in run.stderr
    assert "Traceback" not in run.stderr


def test_impossible_campaign_is_refused_before_any_job(project):
    write_campaign(project, axes={"gamma": [0.3, 0.2]}, fixed={**CAMPAIGN["fixed"], "delta": 1.0})
    run = run_campaign(project)
    assert run.returncode != 0
    assert "Campaign mine: axes.gamma has 0.2 after 0.3" in run.stderr
    assert "Traceback" not in run.stderr
    assert not (project / "results").exists()


def wait_for(condition, seconds):
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if condition():
            return
        time.sleep(0.05)
    raise AssertionError(f"Nothing happened within {seconds} s.")


def largest_memory(benchmarks):
    """Peak memory of any chunk in MiB, as Snakemake measured it."""
    return max(
        float(row["max_rss"])
        for file in benchmarks.glob("*.tsv")
        for row in csv.DictReader(file.read_text().splitlines(), delimiter="\t")
    )


@pytest.mark.slow
def test_interrupted_campaign_goes_on_and_a_grown_one_solves_only_what_is_new(project):
    write_campaign(project)
    folder = project / "results/data/campaigns/mine"
    process = subprocess.Popen(
        command_of("--config", "campaign=mine"),
        cwd=project,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    wait_for(lambda: list(folder.glob("[!u]*.nc")), 240)
    os.kill(process.pid, signal.SIGTERM)
    process.communicate(timeout=60)
    assert process.returncode != 0
    finished = {file: file.stat().st_mtime_ns for file in folder.glob("*.nc")}
    assert 1 <= len(finished) <= 3, "the campaign ended before it could be interrupted"
    assert not list(folder.glob("unfinished*"))

    run = run_campaign(project)
    assert jobs_of(run)["solve_chunk"] == 4 - len(finished)
    assert "400 of 400 points" in run.stderr
    assert "Campaign mine: 400 points, 0 failed" in run.stderr
    assert {file: file.stat().st_mtime_ns for file in finished} == finished
    merged = read_dataset(project / "results/data/campaigns/mine.nc", scene_id="mine")
    assert merged.sizes["delta"] == 4
    assert merged.sizes["gamma"] == 100
    assert np.isfinite(merged["front_speed"]).all()
    assert "overshoot" in (project / "results/tables/campaign_mine.md").read_text()
    assert largest_memory(project / "results/benchmarks/solve_chunk/mine") < 1024
    assert "solve_chunk" not in jobs_of(run_campaign(project, "--dry-run"))

    gammas = {"linspace": [0.1, 1.0, 199]}
    write_campaign(project, axes={"delta": [0.1, 0.2, 0.3, 0.4, 0.8], "gamma": gammas})
    run = run_campaign(project)
    # The new line has 199 points and the four old ones miss 99 each.
    assert jobs_of(run)["solve_chunk"] == 6
    assert "Campaign mine: 995 points, 0 failed" in run.stderr
    assert {file: file.stat().st_mtime_ns for file in finished} == finished
    grown = read_dataset(project / "results/data/campaigns/mine.nc")
    old = grown.sel(delta=merged["delta"], gamma=merged["gamma"])
    np.testing.assert_array_equal(old["overshoot"], merged["overshoot"])


@pytest.mark.slow
def test_results_of_another_campaign_are_refused(project):
    folder = project / "results/data/campaigns/smoke"
    folder.mkdir(parents=True)
    (folder / "campaign.json").write_text('{"campaign": "other", "kind": "heteroclinic"}')
    run = run_campaign(project, name="smoke")
    assert run.returncode != 0
    assert "holds the results of campaign other of kind heteroclinic" in run.stderr
    assert "Traceback" not in run.stderr
    shutil.rmtree(folder)


@pytest.mark.slow
def test_ordinary_run_knows_nothing_of_campaigns(project):
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--dry-run"]
    run = subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "campaign" not in run.stdout
