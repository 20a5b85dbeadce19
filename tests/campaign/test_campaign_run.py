"""Campaigns through the workflow: refused, run, interrupted, grown."""

import functools
import os
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pandas as pd
import pytest
import yaml

from granular_fronts.output.datasets import read_dataset
from projects import copy_project, lend_kernels, wait_for_job

CAMPAIGN = {
    "kind": "chain",
    "axes": {"delta": [0.1, 0.2, 0.4], "gamma": {"linspace": [0.1, 1.0, 10]}},
    "fixed": {"alpha": 1.5, "beads": 420},
    "tolerance": 1.0e-6,
    "chunk_points": 10,
}
SHORT = {
    "kind": "front",
    "axes": {"gamma": {"linspace": [0.5, 2.0, 6]}},
    "fixed": {"alpha": 1.5},
    "chunk_points": 2,
}


def command_of(*arguments):
    return [sys.executable, "-m", "snakemake", "--cores", "1", "campaign", *map(str, arguments)]


def run_campaign(folder, name, *arguments):
    """Run the campaign of a name, or no campaign at all; its output and its error output."""
    command = command_of(*arguments, *(["--config", f"campaign={name}"] if name else []))
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def write_campaign(folder, name, given=CAMPAIGN, **changes):
    file = folder / f"config/campaigns/{name}.yaml"
    file.write_text(yaml.safe_dump({**given, **changes}, sort_keys=False))


def jobs_of(run):
    """Number of jobs of each rule that a run has done."""
    assert run.returncode == 0, run.stderr
    done = re.findall(r"^Finished jobid: \d+ \(Rule: (\w+)\)$", run.stdout + run.stderr, re.M)
    return {name: done.count(name) for name in done}


def summary_of(folder, name):
    return (folder / f"results/tables/campaign_{name}_summary.md").read_text(encoding="utf-8")


def chunk_dates(folder):
    return {file: file.stat().st_mtime_ns for file in folder.glob("[!u]*.nc")}


def read_merged(project, name):
    return read_dataset(project / f"results/data/campaigns/{name}.nc", scene_id=name)


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project in which campaigns are run."""
    return lend_kernels(copy_project(tmp_path_factory.mktemp("project")))


@pytest.mark.slow
def test_what_cannot_be_computed_is_refused_before_any_job_and_a_dry_run_writes_nothing(tmp_path):
    bare = copy_project(tmp_path)
    write_campaign(bare, "mine", axes={"gamma": [0.3, 0.2]}, fixed={"alpha": 1.5, "beads": 420})
    for name, words in (
        ("mine", "Campaign mine: gamma has 0.2 after 0.3"),
        ("nosuch", "There is no campaign nosuch"),
        (None, "Name the campaign, for example: snakemake -c2 campaign --config campaign=smoke"),
    ):
        run = run_campaign(bare, name)
        assert run.returncode == 1
        assert words in run.stderr
        assert "Traceback" not in run.stderr
    assert "solve_chunk" in run_campaign(bare, "smoke", "--dry-run").stdout
    assert not (bare / "results").exists()


def start_campaign(project, name):
    """A running campaign of which one chunk is solved, and the process of the next one."""
    shown = project / f"{name}.txt"
    with shown.open("w") as output:
        process = subprocess.Popen(
            command_of("--config", f"campaign={name}"),
            cwd=project,
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            # Where the tests run in the background, interrupts are ignored, by their children too.
            preexec_fn=functools.partial(signal.signal, signal.SIGINT, signal.default_int_handler),
        )
    deadline = time.monotonic() + 240.0
    while "(Rule: solve_chunk)" not in shown.read_text():
        assert time.monotonic() < deadline
        time.sleep(0.05)
    return process, wait_for_job(process, "solve_chunk.py")


INTERRUPTS = {
    # As when the machine stops.
    "kill_all": lambda process, worker: (os.killpg(process.pid, signal.SIGKILL), worker.kill()),
    "press_ctrl_c": lambda process, worker: os.killpg(process.pid, signal.SIGINT),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", INTERRUPTS)
def test_interrupted_campaign_goes_on(project, name):
    write_campaign(project, name)
    folder = project / f"results/data/campaigns/{name}"
    process, worker = start_campaign(project, name)
    INTERRUPTS[name](process, worker)
    assert process.wait(timeout=60) != 0
    finished = chunk_dates(folder)
    assert 1 <= len(finished) <= 2, "the campaign ended before it could be interrupted"

    if name == "kill_all":
        run_campaign(project, name, "--unlock")
    assert jobs_of(run_campaign(project, name))["solve_chunk"] == 3 - len(finished)
    assert f"Campaign {name}: 30 points, 0 failed" in summary_of(project, name)
    assert finished.items() <= chunk_dates(folder).items()
    assert not list(folder.glob("unfinished*"))
    assert np.isfinite(read_merged(project, name)["front_speed"]).all()


@pytest.mark.slow
def test_grown_campaign_solves_only_what_is_new_and_what_is_lost(project):
    """Snakemake removes what a job that fails would write, not what was made of it before."""
    folder = project / "results/data/campaigns/short"
    few, more = ({"gamma": {"linspace": [0.5, 2.0, count]}} for count in (4, 7))
    write_campaign(project, "short", SHORT, axes=few)
    assert jobs_of(run_campaign(project, "short"))["solve_chunk"] == 2
    merged, solved = read_merged(project, "short"), chunk_dates(folder)
    table = pd.read_csv(project / "results/tables/campaign_short.csv", index_col="gamma")
    np.testing.assert_array_equal(table["overshoot"], merged["overshoot"])
    assert table["reason"].isna().all()

    write_campaign(project, "short", SHORT, axes=more)
    assert jobs_of(run_campaign(project, "short"))["solve_chunk"] > 0
    assert "Campaign short: 7 points, 0 failed" in summary_of(project, "short")
    assert solved.items() <= chunk_dates(folder).items()
    old = read_merged(project, "short").sel(gamma=merged["gamma"])
    np.testing.assert_array_equal(old["overshoot"], merged["overshoot"])

    write_campaign(project, "short", SHORT, axes=few)
    first, second = solved
    first.unlink()
    second.with_suffix(".json").unlink()
    assert jobs_of(run_campaign(project, "short"))["solve_chunk"] == 1
    assert read_merged(project, "short").equals(merged)
