"""The log file of a step holds the whole story and ends with the sentence."""

import errno
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from projects import ROOT

from step import argument_types, from_workflow, load_yaml_or_leaf, run_step

DEFAULT = ROOT / "config" / "default.yaml"
HELP = ROOT / "workflow" / "scripts" / "study.py"
PATHS = ("src", "workflow/lib", "tests/support", "tests/workflow")
ENVIRONMENT = os.environ | {"PYTHONPATH": os.pathsep.join(str(ROOT / path) for path in PATHS)}


class Group(dict):
    """Snakemake's named files: iterating gives the values, items() the names too."""

    def __iter__(self):
        return iter(self.values())


class Job:
    """What Snakemake puts into a script, as far as a step needs it."""

    def __init__(self, log, **params):
        self.params = Group(params)
        self.input = Group(files=["a.nc", "b.nc"], modules=["c.py"])
        self.output = Group(page="d.html")
        self.log = [str(log)]


def run_failing(step, log, **params):
    with pytest.raises(SystemExit, match="1"):
        run_step(step, Job(log, **params))
    return log.read_text().splitlines()


def test_log_of_a_refusal_begins_with_the_call_and_ends_with_the_sentence(tmp_path, capfd):
    def refuse(page: Path, scene: dict) -> None:
        """Print in every way, and refuse."""
        print("to stdout")
        print("to stderr", file=sys.stderr)
        print("\rsolving: 10%\rsolving: 100%", end="", file=sys.stderr)
        print(file=sys.stderr)
        os.write(2, b"past Python\n")
        raise ValueError(f"{page} cannot be written: name another.")

    lines = run_failing(refuse, tmp_path / "log", scene={"beads": list(range(200))})
    assert " refuse: page=d.html, scene={'beads': [0, 1, 2," in lines[0]
    assert len(lines[0]) < 160
    story = "\n".join(lines)
    for words in ["to stdout\nto stderr\n", "past Python\n", "Traceback"]:
        assert words in story
    assert "solving" not in story
    sentence = "d.html cannot be written: name another."
    assert lines[-1] == sentence
    shown = capfd.readouterr()
    assert shown.out == "to stdout\n"
    assert shown.err.endswith(f"{sentence}\n")
    assert "Traceback" not in shown.err


def test_unexpected_error_is_named_last(tmp_path, capfd):
    def stumble(page: Path) -> None:
        """Fail without a sentence."""
        raise KeyError("mu")

    lines = run_failing(stumble, tmp_path / "log")
    assert lines[-1] == "The step failed unexpectedly, KeyError: 'mu'"
    assert any(line.startswith("Traceback") for line in lines)
    assert "Traceback" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("number", "words"),
    [
        (errno.ENOSPC, "no space left in /some: free some"),
        (errno.ENOENT, "/some/file cannot be read or written (No such file or directory)"),
        (errno.EISDIR, "/some/file cannot be read or written (Is a directory)"),
    ],
)
def test_fault_of_a_file_is_a_sentence_even_without_a_log(tmp_path, capfd, number, words):
    def fill(page: Path) -> None:
        """Fail as a write outside of the project's own functions does."""
        raise OSError(number, os.strerror(number), "/some/file")

    for log in (tmp_path / "log", "/dev/full"):
        with pytest.raises(SystemExit, match="1"):
            run_step(fill, Job(log))
        shown = capfd.readouterr().err
        assert words in shown
        assert shown.count("\n") == 1


def test_finished_step_leaves_a_short_log_and_the_streams_as_they_were(tmp_path, capfd):
    def finish(page: Path) -> None:
        """Print half a line."""
        print("half", end="", file=sys.stderr)

    streams = sys.stdout, sys.stderr
    run_step(finish, Job(tmp_path / "log"))
    assert (sys.stdout, sys.stderr) == streams
    call, printed = (tmp_path / "log").read_text().splitlines()
    assert call.endswith(" finish: page=d.html")
    assert printed == "half"
    os.write(2, b"")
    assert capfd.readouterr().err == "half"


def test_rule_gives_a_step_what_it_takes(tmp_path):
    def step(files: list[Path], page: Path, scene: dict) -> None:
        """Take some of what the rule names."""

    assert from_workflow(argument_types(step), Job(tmp_path / "log", scene={"beads": 2})) == {
        "files": [Path("a.nc"), Path("b.nc")],
        "page": Path("d.html"),
        "scene": {"beads": 2},
    }


def test_leaf_of_a_file_is_read_from_the_command_line():
    assert load_yaml_or_leaf(f"{DEFAULT}:scenes.chain.initiation_overdamped.law") == {
        "alpha": 1.5,
        "beta": 1.5,
        "gamma": 0.65,
    }
    assert load_yaml_or_leaf("{alpha: 1.5}") == {"alpha": 1.5}


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("{a: 1}", r"scene is not what measure takes \('beads'\)"),
        (f"{DEFAULT}:scenes.chian", "stops at chian: choose one of chain,"),
    ],
)
def test_wrong_mapping_by_hand_is_a_sentence(monkeypatch, capsys, given, words):
    def measure(scene: dict) -> None:
        """Measure."""
        scene["beads"]

    monkeypatch.setattr(sys, "argv", ["measure", "--scene", given])
    with pytest.raises(SystemExit) as ended:
        run_step(measure)
    assert re.search(words, f"{ended.value}{capsys.readouterr().err}")


@pytest.mark.parametrize("arguments", [["-m", "granular_fronts.scenes", DEFAULT], [HELP, "--help"]])
def test_program_whose_output_nobody_reads_ends_in_silence(arguments):
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, *arguments]
    run = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, env=ENVIRONMENT)
    os.close(writer)
    assert (run.returncode, run.stderr) == (-signal.SIGPIPE, b"")


INTERRUPTED = """
import sys
from pathlib import Path
from test_step import Job
from step import run_step

def wait(page: Path):
    raise KeyboardInterrupt

run_step(wait, Job(sys.argv[1]))
"""


def test_interrupted_step_says_how_to_go_on(tmp_path):
    """A process of its own, whose descriptors are real ones."""
    command = [sys.executable, "-c", INTERRUPTED, str(tmp_path / "log")]
    run = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, check=False)
    sentence = "Interrupted: run the same command again to go on."
    assert (run.returncode, run.stderr) == (130, f"{sentence}\n")
    assert (tmp_path / "log").read_text().splitlines()[-1] == sentence
