"""A smoke run makes everything, and nothing of it is ever older than its parameters and its code.

One run serves all tests of this file, in their order: those that make jobs due without running
them come first.
"""

import contextlib
import json
import os
import signal
import subprocess
import sys
import time

import netCDF4
import pytest
import yaml
from PIL import Image

from captions import read_texts
from granular_fronts.output.datasets import read_dataset
from projects import (
    ROOT,
    copy_project,
    jobs_due,
    lend_kernels,
    rules_due,
    snakemake,
    wait_for_job,
)

pytestmark = pytest.mark.slow

SMOKE = ["--configfile", "config/smoke.yaml"]
SCENE = "initiation_underdamped"
DATA = f"results/smoke/data/chain/{SCENE}.nc"
FIGURE = f"results/smoke/figures/fig01_{SCENE}.png"
CAPTIONS = sorted((ROOT / "workflow/captions").glob("[!t]*.rst"))


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """A copy of the project in which the smoke run is done."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    run = snakemake(*SMOKE, folder=copy)
    assert run.returncode == 0, run.stderr
    return copy


def due_of_all(project):
    """The jobs that a plain call would run."""
    return jobs_due(*SMOKE, "--", "all", folder=project)["all"]


def test_everything_is_made_and_nothing_is_due(finished):
    page = (finished / "results/smoke/report.html").read_text(encoding="utf-8")
    assert page.count("data:image/png;base64,") == len(CAPTIONS)
    plan = snakemake("--dry-run", *SMOKE, folder=finished)
    assert plan.returncode == 0, plan.stderr
    assert not rules_due(plan)


def test_own_report_of_snakemake_shows_every_figure_with_its_caption(finished, tmp_path):
    page = tmp_path / "report.html"
    run = snakemake("--report", page, *SMOKE, folder=finished)
    assert run.returncode == 0, run.stderr
    shown = page.read_text(encoding="utf-8")
    for texts in CAPTIONS:
        assert f"{texts.stem}.png" in shown
        assert json.dumps(read_texts(texts).title) in shown


def test_removed_data_are_made_again_and_what_was_drawn_from_them(finished):
    data, away = finished / DATA, finished / "away.nc"
    data.rename(away)
    due = due_of_all(finished)
    away.rename(data)
    assert {f"initiate_front scene: {SCENE}", "fig01", "fig02", "report"} <= due


def test_results_without_their_history_are_refused(finished):
    """Snakemake's own record is lost, as when results are copied."""
    history = finished / ".snakemake/metadata"
    history.rename(finished / ".snakemake/lost")
    run = snakemake("--dry-run", *SMOKE, folder=finished)
    (finished / ".snakemake/lost").rename(history)
    assert run.returncode == 1
    assert "remove this folder, or name another (--config results=...)" in run.stderr


@contextlib.contextmanager
def changed_code(project, *appended):
    """Append to files of the project while the block runs."""
    texts = {project / name: (project / name).read_text(encoding="utf-8") for name, _ in appended}
    for name, statement in appended:
        (project / name).write_text(texts[project / name] + statement, encoding="utf-8")
    try:
        yield
    finally:
        for file, text in texts.items():
            file.write_text(text, encoding="utf-8")


CODE = "src/granular_fronts"
EFFECTS = {
    (
        (f"{CODE}/output/datasets.py", '"""Words."""\n# A comment.\n'),
        (f"{CODE}/output/long_names.yaml", "new_variable: words\n"),
        ("workflow/lib/job.py", "pass\n"),
    ): ([], [""]),
    (
        (f"{CODE}/chain/strain.py", "pass\n"),
        (f"{CODE}/studies/damping_regimes.py", "pass\n"),
    ): (
        ["initiate_front", "fig01", "study dataset: laws/damping_regimes"],
        ["compute_heteroclinic", "fig08", "study dataset: laws/materials"],
    ),
    (
        (f"{CODE}/output/style.py", "pass\n"),
        (f"{CODE}/continuum/log_kdv_burgers/taylor.py", "pass\n"),
    ): (["fig01", "fig08", "compute_heteroclinic"], ["initiate_front", "study dataset: laws/dam"]),
}
"""What is appended to files, the beginnings of jobs that are due then, and of some that are not."""


@pytest.mark.parametrize("appended", EFFECTS)
def test_a_change_of_code_repeats_what_stands_on_it_and_nothing_else(finished, appended):
    with changed_code(finished, *appended):
        found = due_of_all(finished)
    due, not_due = EFFECTS[appended]
    assert [job for job in due if not any(one.startswith(job) for one in found)] == []
    assert [job for job in found if job.startswith(tuple(not_due))] == []


def test_altered_number_is_refused_and_a_failed_job_shows_its_sentence(finished):
    """Snakemake sees nothing; who reads the file does."""
    data = finished / "results/smoke/data/fronts/survey.nc"
    whole, times = data.read_bytes(), data.stat()
    with netCDF4.Dataset(data, "a") as dataset:
        dataset["overshoot"][0, 0] *= 1.01
    os.utime(data, ns=(times.st_atime_ns, times.st_mtime_ns))
    run = snakemake(
        *SMOKE, "--forcerun", "continuum_errors", "--", "continuum_errors", folder=finished
    )
    data.write_bytes(whole)
    os.utime(data, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert run.returncode != 0
    assert "survey.nc was altered" in run.stderr


def interrupt(project, options):
    """Press Ctrl-C while the script of the job runs."""
    process = subprocess.Popen(
        [sys.executable, "-m", "snakemake", "--cores", "2", *map(str, options), "--", "fig01"],
        cwd=project,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        # Where the tests run in the background, interrupts are ignored, by their children too.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    wait_for_job(process, "initiate_front.py")
    time.sleep(2.0)
    os.killpg(process.pid, signal.SIGINT)
    process.communicate(timeout=60.0)
    assert process.returncode != 0


def fail_in_script(project, options):
    """Let the script of the job raise; then put it back as if it had never changed."""
    script = project / "workflow/scripts/initiate_front.py"
    text, times = script.read_bytes(), script.stat()
    script.write_bytes(
        text.replace(b"    write_dataset(", b"    raise RuntimeError\n    write_dataset(")
    )
    run = snakemake(*options, "--", "fig01", folder=project)
    script.write_bytes(text)
    os.utime(script, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert run.returncode != 0
    assert "RuntimeError" in run.stdout + run.stderr


def test_the_same_command_again_makes_what_is_asked(finished):
    """After a change of a scene whose job is broken twice, in different ways."""
    overlay = finished / "overlay.yaml"
    change = {"law": {"gamma": 0.25}, "end_time": 1000000}
    overlay.write_text(yaml.safe_dump({"scenes": {"chain": {SCENE: change}}}))
    options = [*SMOKE, overlay]
    figure = finished / FIGURE
    before = Image.open(figure).text["Keywords"]
    for break_run in (interrupt, fail_in_script):
        break_run(finished, options)
        assert not (finished / DATA).exists(), "the job was not broken"
        assert Image.open(figure).text["Keywords"] == before, "the figure was drawn again"
    targets = ("fig01", "figures", "tables", "report", "all", FIGURE)
    due = jobs_due(*options, "--", *targets, folder=finished)
    assert "fig01" in due["fig01"] & due["figures"]
    assert "tabulate_paper_numbers" in due["tables"]
    assert "report" in due["report"] & due["all"]
    solved = {job for job in due["all"] if job.startswith(("initiate", "compare", "compute"))}
    assert solved == {f"initiate_front scene: {SCENE}"}
    run = snakemake(*options, "--", "fig01", folder=finished)
    assert run.returncode == 0, run.stderr
    digest = read_dataset(finished / DATA).attrs["data_digest"]
    assert Image.open(figure).text["Keywords"] == f"{SCENE}:{digest}" != before
    assert not list((finished / DATA).parent.glob("unfinished-*"))
