"""`make` installs what environment.txt names, once, and again where that names something else."""

import os
import shutil
import subprocess
import tomllib

import pytest
import yaml

from projects import ROOT

PINS = {"lint": "environment.txt", "docs": "docs/environment.txt"}


@pytest.fixture
def installed(tmp_path):
    """A folder in which everything is installed, as far as make can see."""
    (tmp_path / "docs").mkdir()
    for name in ("Makefile", "pyproject.toml", *PINS.values()):
        shutil.copy(ROOT / name, tmp_path / name)
    (tmp_path / ".venv").mkdir()
    parts = [(tmp_path / name).read_text() for name in ("environment.txt", "pyproject.toml")]
    (tmp_path / ".venv/installed").write_text("".join(parts))
    shutil.copy(tmp_path / "docs/environment.txt", tmp_path / ".venv/docs-installed")
    return tmp_path


def installs(folder, target):
    """The pins that make would install for a target."""
    run = subprocess.run(
        ["make", "--dry-run", target], cwd=folder, capture_output=True, text=True, check=True
    )
    return {name for name in PINS.values() if f"-r {name}" in run.stdout}


def test_what_is_pinned_is_installed_once_and_again_when_it_changes_not_by_time_stamps(installed):
    for target, pins in PINS.items():
        file = installed / pins
        os.utime(file, (4e9, 4e9))
        assert not installs(installed, target)
        was = file.read_text()
        file.write_text(was + "another==1.0\n")
        os.utime(file, (0, 0))
        assert pins in installs(installed, target)
        file.write_text(was)
    # The manual's is made anew with the environment.
    (installed / ".venv/installed").write_text("")
    assert installs(installed, "docs") == set(PINS.values())


@pytest.mark.parametrize("name", ["a b", "a:b"])
def test_blank_or_colon_in_the_path_is_named_before_anything_is_installed(tmp_path, name):
    folder = tmp_path / name
    folder.mkdir()
    for file in ("Makefile", "pyproject.toml", "environment.txt"):
        shutil.copy(ROOT / file, folder)
    run = subprocess.run(["make", "lint"], cwd=folder, capture_output=True, text=True, check=False)
    assert f"move {folder}." in run.stderr
    assert not (folder / ".venv").exists()


def test_pip_installs_into_the_environment_whatever_a_user_has_set(installed):
    (installed / ".venv/installed").write_text("")
    python = installed / "python"
    python.write_text('#!/bin/sh\nmkdir -p .venv/bin; cp "$0" .venv/bin/python; env >> seen\n')
    python.chmod(0o755)
    away = dict.fromkeys(["PIP_USER", "PIP_TARGET", "PIP_PREFIX", "PIP_ROOT"], "1")
    command = ["make", ".venv/installed", f"PYTHON={python}"]
    subprocess.run(command, cwd=installed, env=os.environ | away, capture_output=True, check=True)
    seen = (installed / "seen").read_text().splitlines()
    assert "PIP_USER=0" in seen
    assert not [line for line in seen if line.startswith(("PIP_TARGET", "PIP_PREFIX", "PIP_ROOT="))]


def test_environment_for_conda_holds_the_pinned_packages():
    """Pip reads the path from the folder of the environment."""
    file = ROOT / "workflow/envs/main.yaml"
    dependencies = yaml.safe_load(file.read_text(encoding="utf-8"))["dependencies"]
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["requires-python"] == f">={dependencies[0].removeprefix('python=')}"
    [option] = dependencies[-1]["pip"]
    assert (file.parent / option.removeprefix("-r ")).resolve() == ROOT / "environment.txt"
