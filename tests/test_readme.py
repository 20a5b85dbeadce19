"""Every command that the README shows is run, or at least planned, here."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


COMMANDS = [line for block in blocks("sh") for line in block.splitlines()]


def run(command, **environment):
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src"), **environment}
    return subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, env=environment, check=False
    )


@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("make")])
def test_make_knows_its_targets(command):
    outcome = run([*shlex.split(command), "--dry-run"])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.slow
@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("snakemake")])
def test_workflow_can_plan_its_targets(command):
    outcome = run([sys.executable, "-m", *shlex.split(command), "--dry-run", "--nolock"])
    assert outcome.returncode == 0, outcome.stderr


@pytest.mark.slow
@pytest.mark.parametrize("command", [c for c in COMMANDS if c.startswith("python")])
def test_script_runs_as_shown(command, tmp_path):
    words = shlex.split(command)[1:]
    words[-1] = str(tmp_path / words[-1])
    outcome = run([sys.executable, *words])
    assert outcome.returncode == 0, outcome.stderr
    assert Path(words[-1]).exists()


def test_all_commands_are_of_a_kind_that_is_tested():
    kinds = ("make", "snakemake", "python", "source .venv/bin/activate")
    assert all(command.startswith(kinds) for command in COMMANDS)


@pytest.mark.parametrize("code", blocks("python"))
def test_python_example_runs(code, capsys):
    exec(code, {})
    assert "±" in capsys.readouterr().out


@pytest.mark.parametrize("text", blocks("yaml"))
def test_shown_configuration_is_possible(text, tmp_path):
    from granular_fronts.scenes.configuration import check_configuration
    from granular_fronts.scenes.yaml_files import load_configuration

    override = tmp_path / "mine.yaml"
    override.write_text(text)
    check_configuration(load_configuration(ROOT / "config" / "default.yaml", override))


def test_named_files_exist():
    for name in re.findall(r"`((?:src|workflow|config|tests)/[\w./]+)`", README):
        assert (ROOT / name).exists(), name
