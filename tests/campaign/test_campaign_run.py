"""Campaigns through the workflow: refused, run, interrupted in every way, grown."""

import contextlib
import csv
import functools
import os
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pandas as pd
import psutil
import pytest
import yaml

from granular_fronts.output.datasets import read_dataset
from projects import copy_project, lend_kernels

CAMPAIGN = {
    "kind": "chain",
    "axes": {"delta": [0.1, 0.2, 0.4, 0.8], "gamma": {"linspace": [0.1, 1.0, 100]}},
    "fixed": {"alpha": 1.5, "beads": 420},
    "tolerance": 1.0e-6,
    "chunk_points": 100,
}
SHORT = {
    "kind": "front",
    "axes": {"gamma": {"linspace": [0.5, 2.0, 6]}},
    "fixed": {"alpha": 1.5},
    "chunk_points": 2,
}


def command_of(*arguments):
    return [sys.executable, "-m", "snakemake", "--cores", "1", "campaign", *map(str, arguments)]


def run_campaign(folder, *arguments, name="mine"):
    command = command_of(*arguments, "--config", f"campaign={name}")
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def write_campaign(folder, given=CAMPAIGN, name="mine", **changes):
    file = folder / f"config/campaigns/{name}.yaml"
    file.write_text(yaml.safe_dump({**given, **changes}, sort_keys=False))


def jobs_of(run):
    """Number of jobs of each rule that a run has done, or would do."""
    assert run.returncode == 0, run.stderr
    if "--dry-run" in run.args:
        found = re.findall(r"^(\w+) +(\d+)$", run.stdout + run.stderr, re.MULTILINE)
        return {name: int(count) for name, count in found}
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
    write_campaign(bare, axes={"gamma": [0.3, 0.2]}, fixed={**CAMPAIGN["fixed"], "delta": 1.0})
    for arguments, words in (
        (["--config", "campaign=mine"], "Campaign mine: gamma has 0.2 after 0.3"),
        (["--config", "campaign=nosuch"], "There is no campaign nosuch"),
        ([], "Name the campaign, for example: snakemake -c2 campaign --config campaign=smoke"),
    ):
        run = subprocess.run(
            command_of(*arguments), cwd=bare, capture_output=True, text=True, check=False
        )
        assert run.returncode == 1
        assert words in run.stderr
        assert "Traceback" not in run.stderr
    assert jobs_of(run_campaign(bare, "--dry-run", name="smoke"))["solve_chunk"] == 1
    assert not (bare / "results").exists()
    assert not (bare / ".numba_cache").exists()


def wait_for(condition, seconds):
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if found := condition():
            return found
        time.sleep(0.02)
    raise AssertionError(f"Nothing happened within {seconds} s.")


def worker_of(process, words):
    """The process of a running job, whose command line holds some words."""
    with contextlib.suppress(psutil.NoSuchProcess):
        for child in psutil.Process(process.pid).children(recursive=True):
            with contextlib.suppress(psutil.NoSuchProcess):
                if any(words in word for word in child.cmdline()):
                    return child
    return None


def start_campaign(project, name):
    """A running campaign of which one chunk is solved and another has begun."""
    shown = project / f"{name}.txt"
    with shown.open("w") as opened:
        process = subprocess.Popen(
            command_of("--config", f"campaign={name}"),
            cwd=project,
            stdout=opened,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            # Where the tests run in the background, interrupts are ignored, by their children too.
            preexec_fn=functools.partial(signal.signal, signal.SIGINT, signal.default_int_handler),
        )
    wait_for(lambda: "(Rule: solve_chunk)" in shown.read_text(), 240)
    return process, wait_for(lambda: worker_of(process, "solve_chunk.py"), 60)


INTERRUPTS = {
    "kill_worker": lambda process, worker: worker.kill(),
    # As when the machine stops.
    "kill_all": lambda process, worker: (os.killpg(process.pid, signal.SIGKILL), worker.kill()),
    "press_ctrl_c": lambda process, worker: os.killpg(process.pid, signal.SIGINT),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", INTERRUPTS)
def test_interrupted_campaign_goes_on(project, name):
    write_campaign(project, name=name)
    folder = project / f"results/data/campaigns/{name}"
    process, worker = start_campaign(project, name)
    INTERRUPTS[name](process, worker)
    assert process.wait(timeout=60) != 0
    finished = chunk_dates(folder)
    assert 1 <= len(finished) <= 3, "the campaign ended before it could be interrupted"

    if name == "kill_all":
        run_campaign(project, "--unlock", name=name)
    run = run_campaign(project, name=name)
    jobs = jobs_of(run)
    assert jobs["solve_chunk"] == 4 - len(finished)
    assert f"Campaign {name}: 400 points, 0 failed" in summary_of(project, name)
    assert finished.items() <= chunk_dates(folder).items()
    wait_for(lambda: not worker.is_running() or worker.status() == psutil.STATUS_ZOMBIE, 60)
    assert not list(folder.glob("unfinished*"))
    assert np.isfinite(read_merged(project, name)["front_speed"]).all()
    assert not jobs_of(run_campaign(project, "--dry-run", name=name))


def largest_memory(benchmarks):
    """Peak memory of any chunk in MiB, as Snakemake measured it."""
    return max(
        float(row["max_rss"])
        for file in benchmarks.glob("*.tsv")
        for row in csv.DictReader(file.read_text().splitlines(), delimiter="\t")
    )


@pytest.mark.slow
def test_grown_campaign_solves_only_what_is_new(project):
    write_campaign(project)
    folder = project / "results/data/campaigns/mine"
    assert jobs_of(run_campaign(project))["solve_chunk"] == 4
    merged, solved = read_merged(project, "mine"), chunk_dates(folder)
    assert merged.sizes["delta"] == 4
    assert merged.sizes["gamma"] == 100
    assert "overshoot" in summary_of(project, "mine")
    file = project / "results/tables/campaign_mine.csv"
    points = pd.read_csv(file, index_col=["delta", "gamma"])
    assert points["reason"].isna().all()
    np.testing.assert_array_equal(points["overshoot"], merged["overshoot"].values.ravel())
    assert largest_memory(project / "results/benchmarks/solve_chunk/mine") < 1024

    gammas = {"linspace": [0.1, 1.0, 199]}
    write_campaign(project, axes={"delta": [0.1, 0.2, 0.3, 0.4, 0.8], "gamma": gammas})
    run = run_campaign(project)
    # Each of five lines is cut in two; the four old ones miss every second point.
    assert jobs_of(run)["solve_chunk"] == 10
    assert "Campaign mine: 995 points, 0 failed" in summary_of(project, "mine")
    assert solved.items() <= chunk_dates(folder).items()
    grown = read_dataset(project / "results/data/campaigns/mine.nc")
    old = grown.sel(delta=merged["delta"], gamma=merged["gamma"])
    np.testing.assert_array_equal(old["overshoot"], merged["overshoot"])

    write_campaign(project)
    assert "solve_chunk" not in jobs_of(run_campaign(project))
    assert read_merged(project, "mine").equals(merged)
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--dry-run"]
    run = subprocess.run(command, cwd=project, capture_output=True, text=True, check=True)
    assert "campaign" not in run.stdout, "an ordinary run knows nothing of it"


@pytest.mark.slow
def test_lost_chunk_is_solved_again_beside_an_older_merged_file(project):
    """Snakemake removes what a job that fails would write, not what was made of it before."""
    name = "short"
    write_campaign(project, SHORT, name)
    folder = project / "results/data/campaigns" / name
    assert jobs_of(run_campaign(project, name=name))["solve_chunk"] == 3
    first, second, _ = chunk_dates(folder)
    first.unlink()
    second.with_suffix(".json").unlink()
    jobs = jobs_of(run_campaign(project, name=name))
    assert jobs["solve_chunk"] == jobs["merge_campaign"] == 1


ON_A_SMALL_DISK = """
set -e
folder=results/data/campaigns/$1
logs=results/logs/solve_chunk/$1
mkdir -p "$folder"
mount -t tmpfs -o size=100k none "$folder"
shift
if "$@" > first.txt 2>&1; then exit 9; fi
ls "$folder" > between.txt
tail -qn 1 "$logs"/*.log > sentences.txt
mount -o remount,size=100m "$folder"
"$@" > second.txt 2>&1
"""


def can_mount():
    command = ["unshare", "--user", "--map-root-user", "--mount", "mount", "-t", "tmpfs", "none"]
    with contextlib.suppress(FileNotFoundError):
        return subprocess.run([*command, "/mnt"], capture_output=True, check=False).returncode == 0
    return False


@pytest.mark.slow
@pytest.mark.skipif(not can_mount(), reason="no small disk can be mounted here")
def test_full_disk_is_named_and_the_campaign_goes_on_when_there_is_space(project):
    name = "disk"
    write_campaign(project, SHORT, name, record={"profile": {"start": -9, "stop": 9, "count": 999}})
    unshare = ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", ON_A_SMALL_DISK]
    command = command_of("--config", f"campaign={name}")
    run = subprocess.run(
        [*unshare, "sh", name, *command], cwd=project, capture_output=True, text=True, check=False
    )
    first, second = ((project / f"{word}.txt").read_text() for word in ("first", "second"))
    assert run.returncode == 0, run.stderr + first + second
    sentence = (
        f"There is no space left in results/data/campaigns/{name}: "
        "free some and run the same command again."
    )
    assert sentence in first
    assert "Traceback" not in first
    assert sentence in (project / "sentences.txt").read_text().splitlines()
    between = (project / "between.txt").read_text().split()
    kept = [file for file in between if file.endswith(".nc")]
    assert len(kept) < 3
    assert not [file for file in between if file.startswith("unfinished")]
    assert second.count("(Rule: solve_chunk)") == 3 - len(kept)
    assert f"Campaign {name}: 6 points, 0 failed" in summary_of(project, name)
