import json
import re
import tomllib

import pytest
import yaml
from packaging.requirements import Requirement

from captions import read_texts
from projects import ROOT, jobs_due, rules_due, snakemake

FIGURES = sorted(file.stem for file in (ROOT / "workflow/captions").glob("[!t]*.rst"))
DRAWN = [name.partition("_")[0] if name.startswith("fig") else name for name in FIGURES]


@pytest.fixture(scope="module")
def targets():
    """All rules that can be named."""
    run = snakemake("--list-target-rules")
    named = re.findall(r"^(\w+) \(", run.stdout, re.MULTILINE)
    return [name for name in named if name != "campaign"]


@pytest.fixture(scope="module")
def plan(tmp_path_factory, targets):
    """The jobs behind each target, where nothing is there yet.

    Planned together, since a target that could not be planned alone would stop this plan too.
    """
    nothing = f"results={tmp_path_factory.mktemp('plan') / 'results'}"
    return jobs_due("--config", nothing, "--", *targets)


def test_every_target_can_be_planned(plan, targets):
    assert plan.keys() >= set(targets) >= {*DRAWN, "all", "figures", "tables", "report"}
    assert plan["all"] >= {*DRAWN, "report", "compute_heteroclinic scene: front_profiles"}


def test_figure_solves_only_its_own_scene(plan):
    solved = {job for job in plan["fig03"] if job.startswith("initiate_front")}
    assert solved == {"initiate_front scene: initiation_overdamped"}


def test_lint_finds_nothing():
    run = snakemake("--lint")
    assert run.returncode == 0, run.stdout


def test_impossible_configuration_is_refused_before_any_job(tmp_path):
    override = tmp_path / "override.yaml"
    scenes = {"chain": {"initiation_overdamped": {"law": {"gamma": -0.5}}}}
    override.write_text(yaml.safe_dump({"scenes": scenes}))
    run = snakemake("--configfile", override, "--config", f"results={tmp_path / 'results'}")
    assert run.returncode != 0
    assert "Scene initiation_overdamped: law.gamma is -0.5" in run.stderr
    assert "Traceback" not in run.stderr
    assert "File " not in run.stderr
    assert not (tmp_path / "results").exists()


def test_files_replace_other_kinds_and_the_command_line_wins(tmp_path):
    """Snakemake itself would leave keys of the boundary and the law that are below."""
    files = [tmp_path / "one.yaml", tmp_path / "two.yaml"]
    boundary, law = {"kind": "piston", "velocity": 0.05}, {"elastic": {"kind": "toda"}}
    for file, changes in zip(files, ({"boundary": boundary}, {"law": law}), strict=True):
        scenes = {"chain": {"initiation_underdamped": changes}}
        file.write_text(yaml.safe_dump({"results": "no folder?", "scenes": scenes}))
    results = f"results={tmp_path / 'results'}"
    run = snakemake("--dry-run", "--configfile", *files, "--config", results, "--", "fig01")
    assert run.returncode == 0, run.stderr
    assert "initiate_front" in rules_due(run)


def test_an_option_of_which_snakemake_would_drop_the_first_is_refused():
    given = ["--configfile", "config/smoke.yaml"]
    run = snakemake("--dry-run", *given, *given)
    assert run.returncode != 0
    assert "--configfile is given twice" in run.stderr


@pytest.mark.slow
def test_smoke_run_makes_everything(finished):
    page = (finished / "results/smoke/report.html").read_text(encoding="utf-8")
    assert page.count("data:image/png;base64,") == len(FIGURES)
    plan = snakemake("--dry-run", "--configfile", "config/smoke.yaml", folder=finished)
    assert plan.returncode == 0, plan.stderr
    assert not rules_due(plan)


@pytest.mark.slow
def test_own_report_of_snakemake_shows_every_figure_with_its_caption(finished, tmp_path):
    page = tmp_path / "report.html"
    run = snakemake("--report", page, "--configfile", "config/smoke.yaml", folder=finished)
    assert run.returncode == 0, run.stderr
    shown = page.read_text(encoding="utf-8")
    for name in FIGURES:
        assert f"{name}.png" in shown
        title = read_texts(ROOT / f"workflow/captions/{name}.rst").title
        assert json.dumps(title) in shown


def pinned_in(file):
    """The versions of each package that a file pins, which names no package index."""
    text = (ROOT / file).read_text()
    assert "://" not in text
    pinned = {}
    for name, version in re.findall(r"^([\w.-]+)==([\w.]+)", text, re.MULTILINE):
        pinned.setdefault(name, set()).add(version)
    return pinned


def test_environments_pin_every_dependency_within_its_range_and_agree():
    """The project's and the one that builds the manual are installed into one environment."""
    here, manual = pinned_in("environment.txt"), pinned_in("docs/environment.txt")
    described = tomllib.loads((ROOT / "pyproject.toml").read_text())
    project = described["project"]
    required = [*project["dependencies"], *described["build-system"]["requires"]]
    required += [one for extra in project["optional-dependencies"].values() for one in extra]
    for pinned, requirements in (here, required), (manual, described["dependency-groups"]["docs"]):
        for requirement in map(Requirement, requirements):
            versions = pinned[requirement.name.lower()]
            assert all(requirement.specifier.contains(version) for version in versions)
    for name in here.keys() & manual.keys():
        assert manual[name] <= here[name]
