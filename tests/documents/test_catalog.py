"""The workflow as others use it: what the workflow catalogue asks for, and a module of another."""

import os
import re
import subprocess
import sys
import tomllib

import pytest
import yaml
from configurations import DEFAULT
from projects import ROOT, copy_project

MODULE = """
configfile: "config/config.yaml"
module fronts:
    snakefile: {snakefile}
    config: config
use rule * from fronts
"""
"""What `snakedeploy deploy-workflow` writes."""


def test_environment_for_conda_holds_the_pinned_packages():
    """Pip reads the path from the folder of the environment, wherever the workflow is used."""
    file = ROOT / "workflow/envs/main.yaml"
    dependencies = yaml.safe_load(file.read_text(encoding="utf-8"))["dependencies"]
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["requires-python"] == f">={dependencies[0].removeprefix('python=')}"
    [option] = dependencies[-1]["pip"]
    assert (file.parent / option.removeprefix("-r ")).resolve() == ROOT / "environment.txt"


def test_configuration_page_names_every_key():
    page = (ROOT / "config/README.md").read_text(encoding="utf-8")
    default = yaml.safe_load(DEFAULT.read_text(encoding="utf-8"))
    keys = {*default, *(f"scenes.{family}" for family in default["scenes"])} - {"scenes"}
    for key in keys:
        assert f"`{key}`" in page


def test_configuration_of_a_module_changes_nothing_by_itself():
    own = yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8"))
    assert own == {"results": yaml.safe_load(DEFAULT.read_text(encoding="utf-8"))["results"]}


def jobs_planned(folder, snakefile, configuration, *targets, **environment):
    """Plan targets of a workflow that uses this one, or its default; return what is printed."""
    (folder / "workflow").mkdir(parents=True)
    (folder / "workflow/Snakefile").write_text(MODULE.format(snakefile=snakefile))
    (folder / "config").mkdir()
    (folder / "config/config.yaml").write_text(yaml.safe_dump(configuration))
    return subprocess.run(
        [sys.executable, "-m", "snakemake", "--cores", "2", "--dry-run", *targets],
        cwd=folder,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.slow
def test_another_workflow_uses_a_clone_with_values_of_its_own(tmp_path):
    clone = f'"{ROOT}/workflow/Snakefile"'
    targets = ["all", "referee"]
    run = jobs_planned(tmp_path / "used", clone, {"results": "mine"}, *targets)
    assert run.returncode == 0, run.stderr
    assert re.search(r"^write_report +1$", run.stdout, re.MULTILINE)
    assert "mine/figures/fig01_initiation_underdamped.png" in run.stdout
    impossible = {"scenes": {"chain": {"initiation_overdamped": {"beads": -4}}}}
    run = jobs_planned(tmp_path / "refused", clone, impossible)
    assert run.returncode != 0
    assert "Scene initiation_overdamped: beads is -4" in run.stderr


def git(*arguments, folder):
    """Call git as somebody."""
    somebody = ["-c", "user.name=Somebody", "-c", "user.email=somebody@example.org"]
    subprocess.run(["git", *somebody, *arguments], cwd=folder, check=True, capture_output=True)


@pytest.mark.slow
def test_another_workflow_uses_a_tag_of_a_hosted_repository(tmp_path):
    """Git looks for the host in a folder; Snakemake fetches from there as from it."""
    project = copy_project(tmp_path)
    git("init", "--quiet", folder=project)
    git("add", "--all", folder=project)
    git("commit", "--quiet", "--message", "A version", folder=project)
    git("tag", "v1", folder=project)
    git("clone", "--bare", project, tmp_path / "host/somebody/fronts.git", folder=tmp_path)
    hosted = 'github("somebody/fronts", path="workflow/Snakefile", tag="v1")'
    redirected = {
        "GIT_CONFIG_COUNT": "1",
        "GIT_CONFIG_KEY_0": f"url.{tmp_path}/host/.insteadOf",
        "GIT_CONFIG_VALUE_0": "https://github.com/",
        "XDG_CACHE_HOME": str(tmp_path / "cache"),
    }
    run = jobs_planned(tmp_path / "used", hosted, {"results": "mine"}, **redirected)
    assert run.returncode == 0, run.stderr
    assert re.search(r"^write_report +1$", run.stdout, re.MULTILINE)
    [copy] = (tmp_path / "used/.snakemake/sources").iterdir()
    assert (copy / "src/granular_fronts/__init__.py").is_file()
