"""The container recipe, its steps executed in an empty folder with an environment of its own."""

import os
import shlex
import shutil
import subprocess
import sys

import pytest
from projects import CACHES, ROOT


def instructions():
    """Instructions of the recipe with what follows them, comments and line breaks taken out."""
    lines = (ROOT / "Containerfile").read_text(encoding="utf-8").splitlines()
    text = "\n".join(line for line in lines if not line.startswith("#")).replace("\\\n", " ")
    return [tuple(line.split(maxsplit=1)) for line in text.splitlines() if line]


def copy(words, folder):
    """Do what COPY does: several files into a folder, or a folder as another."""
    *sources, target = words
    for source in sources:
        place = folder / target if len(sources) == 1 else folder / target / source
        if (ROOT / source).is_dir():
            shutil.copytree(ROOT / source, place, ignore=shutil.ignore_patterns(*CACHES))
        else:
            shutil.copy(ROOT / source, place)


def execute(folder, environment):
    """Execute the recipe in a folder that stands for the root of the image.

    Returns the working directory at the end, and the command.
    """
    place, command = folder, []
    for instruction, rest in instructions():
        match instruction:
            case "WORKDIR":
                place = folder / rest.lstrip("/")
                place.mkdir(parents=True)
            case "COPY":
                copy(rest.split(), place)
            case "ENV":
                name, _, value = rest.partition("=")
                environment[name] = value
            case "RUN":
                subprocess.run(["bash", "-euc", rest], cwd=place, env=environment, check=True)
            case "CMD":
                command = [word.strip(",") for word in shlex.split(rest.strip("[]"))]
    return place, command


@pytest.mark.slow
def test_steps_of_the_recipe_make_a_workflow_with_compiled_kernels(tmp_path):
    """In an empty root: a figure is then drawn, and nothing is compiled for it."""
    subprocess.run([sys.executable, "-m", "venv", tmp_path / "python"], check=True)
    kept = {"HOME", "LANG", "TMPDIR", *(name for name in os.environ if name.startswith("PIP_"))}
    environment = {name: os.environ[name] for name in kept & set(os.environ)}
    environment["PATH"] = f"{tmp_path}/python/bin:/usr/local/bin:/usr/bin:/bin"
    place, command = execute(tmp_path / "root", environment)
    assert list((place / ".numba_cache").iterdir())
    assert not (place / ".snakemake").exists()
    figure = ["--configfile", "config/smoke.yaml", "--", "fig03"]
    subprocess.run([*command, *figure], cwd=place, env=environment, check=True)
    assert (place / "results/smoke/figures/fig03_initiation_overdamped.pdf").is_file()
    logs = (place / "results/smoke/logs").rglob("*.log")
    assert not [log for log in logs if "Compiling the kernels" in log.read_text(encoding="utf-8")]
