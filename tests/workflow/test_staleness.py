"""A figure, a table or a report is never older than its parameters, whatever a run was broken by.

Each test changes a scene of the finished smoke run, breaks the job that would solve it, and
gives the same command again.
"""

import contextlib
import os
import signal
import subprocess
import sys
import time

import netCDF4
import pytest
import yaml
from PIL import Image

from granular_fronts.output.datasets import read_dataset
from projects import jobs_due, snakemake, wait_for_job

pytestmark = pytest.mark.slow

SMOKE = ["--configfile", "config/smoke.yaml"]
SCENE = "initiation_underdamped"
DATA = f"results/smoke/data/chain/{SCENE}.nc"
FIGURE = f"results/smoke/figures/fig01_{SCENE}.png"


def ask(project, name, change):
    """Lay a change of the scene over the smoke run; return the options and the scene asked for."""
    overlay = project / f"{name}.yaml"
    overlay.write_text(yaml.safe_dump({"scenes": {"chain": {SCENE: change}}}))
    return [*SMOKE, overlay]


def keywords(project):
    """What the figure says that it was drawn from."""
    return Image.open(project / FIGURE).text["Keywords"]


def keywords_of_data(project):
    """What a figure of the present data says."""
    digest = read_dataset(project / DATA).attrs["data_digest"]
    return f"{SCENE}:{digest}"


def interrupt(project, options):
    """Press Ctrl-C."""
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
    script.write_bytes(text.replace(b"write_dataset(sim", b"raise RuntimeError(sim"))
    run = snakemake(*options, "--", "fig01", folder=project)
    script.write_bytes(text)
    os.utime(script, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert run.returncode != 0


BREAKS = {
    fail_in_script: {"law": {"gamma": 0.21}},
    interrupt: {"law": {"gamma": 0.25}, "end_time": 1000000},
}


@pytest.mark.parametrize("break_run", BREAKS, ids=lambda break_run: break_run.__name__)
def test_the_same_command_again_makes_what_is_asked(finished, break_run):
    options = ask(finished, break_run.__name__, BREAKS[break_run])
    before = keywords(finished)
    break_run(finished, options)
    assert not (finished / DATA).exists(), "the job was not broken"
    assert keywords(finished) == before, "the figure was drawn again"
    targets = ("fig01", "figures", "tables", "report", "all", FIGURE)
    due = jobs_due(*options, "--", *targets, folder=finished)
    assert "fig01" in due["fig01"] & due["figures"]
    assert "tabulate_paper_numbers" in due["tables"]
    assert "report" in due["report"] & due["all"]
    solved = {job for job in due["all"] if job.startswith(("initiate", "compare", "compute"))}
    assert solved == {f"initiate_front scene: {SCENE}"}
    run = snakemake(*options, "--", "fig01", folder=finished)
    assert run.returncode == 0, run.stderr
    assert keywords(finished) == keywords_of_data(finished) != before
    assert not list((finished / DATA).parent.glob("unfinished-*"))


def test_removed_data_are_made_again_and_what_was_drawn_from_them(finished):
    assert snakemake(*SMOKE, "--", "fig01", folder=finished).returncode == 0
    (finished / DATA).unlink()
    due = jobs_due(*SMOKE, "--", "all", folder=finished)["all"]
    assert {f"initiate_front scene: {SCENE}", "fig01", "fig02", "report"} <= due
    changed = ask(finished, "after_removal", {"law": {"gamma": 0.26}})
    run = snakemake(*changed, "--", FIGURE, folder=finished)
    assert run.returncode == 0, run.stderr
    assert keywords(finished) == keywords_of_data(finished)


def test_results_without_their_history_are_refused(finished):
    """Snakemake's own record is lost, as when results are copied."""
    history = finished / ".snakemake/metadata"
    history.rename(finished / ".snakemake/lost")
    run = snakemake("--dry-run", *SMOKE, folder=finished)
    (finished / ".snakemake/lost").rename(history)
    assert run.returncode == 1
    assert "remove this folder, or name another (--config results=...)" in run.stderr


@contextlib.contextmanager
def changed_code(project, name, appended):
    """Append to a file of the project while the block runs."""
    file = project / name
    text = file.read_text(encoding="utf-8")
    file.write_text(text + appended, encoding="utf-8")
    try:
        yield
    finally:
        file.write_text(text, encoding="utf-8")


WITHOUT_EFFECT = {
    "src/granular_fronts/output/datasets.py": '"""Words."""\n# A comment.\n',
    "src/granular_fronts/output/long_names.yaml": "new_variable: words\n",
    "workflow/lib/job.py": "pass\n",
}
DUE_AND_NOT_DUE = {
    "output/style.py": (["fig01", "fig08"], ["initiate_front"]),
    "chain/strain.py": (["initiate_front", "fig01"], ["compute_heteroclinic", "fig08"]),
    "continuum/log_kdv_burgers/taylor.py": (
        ["compute_heteroclinic", "fig08"],
        ["initiate_front", "fig01"],
    ),
    "studies/damping_regimes.py": (
        ["study dataset: laws/damping_regimes"],
        ["study dataset: laws/materials", "study dataset: fronts/survey", "initiate_front"],
    ),
}
"""Beginnings of jobs due after a statement is appended to a file, and some that are not."""


def test_a_change_of_code_repeats_what_stands_on_it_and_nothing_else(finished):
    assert snakemake(*SMOKE, folder=finished).returncode == 0

    def due_after(name, appended):
        with changed_code(finished, name, appended):
            return jobs_due(*SMOKE, "--", "all", folder=finished)["all"]

    for name, words in WITHOUT_EFFECT.items():
        assert not due_after(name, words), name
    for name, (due, not_due) in DUE_AND_NOT_DUE.items():
        found = due_after(f"src/granular_fronts/{name}", "pass\n")
        for job in due:
            assert any(one.startswith(job) for one in found), (name, job)
        assert not [one for one in found if one.startswith(tuple(not_due))], name


def test_altered_number_is_refused(finished):
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
