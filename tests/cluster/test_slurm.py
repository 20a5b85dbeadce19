"""A campaign on a real cluster of one node: a job is killed, the next call ends the campaign.

Needs root, Debian's packages slurm-wlm and munge, and `profiles/slurm/environment.txt`.
"""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
import yaml

from granular_fronts.output.datasets import read_dataset
from projects import copy_project

CLUSTER = Path(__file__).with_name("one_node.sh")
CAMPAIGN = {
    "kind": "chain",
    "axes": {"delta": [0.1, 0.2, 0.4], "gamma": {"linspace": [0.1, 1.0, 300]}},
    "fixed": {"alpha": 1.5, "beads": 420},
    "tolerance": 1.0e-8,
    "chunk_points": 300,
}
NEEDED = {
    "Debian's package slurm-wlm": shutil.which("slurmctld") and shutil.which("slurmd"),
    "Debian's package munge": shutil.which("munged"),
    "root's rights": os.geteuid() == 0,
    "profiles/slurm/environment.txt": importlib.util.find_spec("snakemake_executor_plugin_slurm"),
    "a machine that is no cluster": not Path("/etc/slurm/slurm.conf").exists(),
}
MISSING = [name for name, found in NEEDED.items() if not found]
pytestmark = [
    # It needs root and a cluster of its own.
    pytest.mark.nightly,
    pytest.mark.skipif(bool(MISSING), reason=f"The cluster test needs {', '.join(MISSING)}."),
]


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cluster")
    subprocess.run([CLUSTER, "start", folder], check=True)
    yield folder
    subprocess.run([CLUSTER, "stop", folder], check=True)


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    copy = copy_project(tmp_path_factory.mktemp("project"))
    (copy / "config/campaigns/mine.yaml").write_text(yaml.safe_dump(CAMPAIGN, sort_keys=False))
    return copy


def command_of(*arguments):
    profile = ["--workflow-profile", "profiles/slurm"]
    named = ["--config", "campaign=mine"]
    return [sys.executable, "-m", "snakemake", *profile, *arguments, "campaign", *named]


def running_jobs():
    """Numbers of the running jobs of chunks, by SLURM's own account."""
    listed = subprocess.run(
        ["squeue", "--noheader", "--states=RUNNING", "--format=%i %k"],
        capture_output=True,
        text=True,
        check=True,
    )
    return re.findall(r"^(\d+) .*solve_chunk", listed.stdout, re.MULTILINE)


def test_killed_job_is_solved_by_the_next_call(cluster, project):
    log = cluster / "first.log"
    with log.open("w") as output:
        process = subprocess.Popen(
            command_of("--retries", "0"), cwd=project, stdout=output, stderr=subprocess.STDOUT
        )
    deadline = time.monotonic() + 240.0
    while not (jobs := running_jobs()):
        assert time.monotonic() < deadline, log.read_text()
        assert process.poll() is None, log.read_text()
        time.sleep(0.2)
    subprocess.run(["scancel", jobs[0]], check=True)
    assert process.wait(timeout=240) != 0, log.read_text()
    folder = project / "results/data/campaigns/mine"
    assert len(list(folder.glob("*.nc"))) == 2, log.read_text()

    run = subprocess.run(command_of(), cwd=project, capture_output=True, text=True, timeout=240)
    assert run.returncode == 0, run.stderr
    assert re.search(r"^solve_chunk +1$", run.stdout + run.stderr, re.MULTILINE)
    merged = read_dataset(project / "results/data/campaigns/mine.nc")
    assert merged.attrs["points"] == 900
    assert merged.attrs["failed_points"] == 0
