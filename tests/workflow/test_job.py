"""The log file of a job holds the whole story and ends with the sentence."""

import os
import signal
import subprocess
import sys
from types import SimpleNamespace

import pytest

from granular_fronts.errors import InputError
from job import job
from projects import ROOT

DEFAULT = ROOT / "config" / "default.yaml"


def run_failing(step, log):
    with pytest.raises(SystemExit, match="1"), job(SimpleNamespace(log=[str(log)])):
        step()
    return log.read_text().splitlines()


def test_log_of_a_refusal_ends_with_the_sentence_alone(tmp_path, capfd):
    def refuse():
        """Print in every way, and refuse."""
        print("to stdout")
        print("to stderr", file=sys.stderr)
        raise InputError("d.html cannot be written: name another.")

    lines = run_failing(refuse, tmp_path / "log")
    assert lines == ["to stdout", "to stderr", "d.html cannot be written: name another."]
    assert capfd.readouterr() == ("", "")


def test_unexpected_error_shows_where_it_is(tmp_path):
    def stumble():
        """Fail without a sentence."""
        raise KeyError("mu")

    lines = run_failing(stumble, tmp_path / "log")
    assert lines[0].startswith("Traceback")
    assert lines[-1] == "KeyError: 'mu'"


def test_program_whose_output_nobody_reads_ends_in_silence():
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "granular_fronts.scenes", DEFAULT]
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    run = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, env=environment)
    os.close(writer)
    assert (run.returncode, run.stderr) == (-signal.SIGPIPE, b"")
