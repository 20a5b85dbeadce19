"""Papers of others: folders that add to the lists of the main paper, and leave its run as it is."""

import re
import shlex

import pandas as pd
import papers as papers_of_others
import pytest
import yaml
from pages import ROOT, carry_out, commands, load_script
from tabulate_statements import find_measure

from granular_fronts.errors import InputError
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.statements import (
    ANSWERS,
    NOT_JUDGED,
    criterion_of,
    range_of_criterion,
    scenes_of,
)
from granular_fronts.scenes.yaml_files import read_yaml
from projects import copy_project, jobs_due, lend_kernels, snakemake

PAGE = ROOT / "docs" / "papers" / "your_paper.md"
SUBJECTS = "A paper, in two", "A figure of a paper"
TABLES = papers_of_others.listed_in_papers("tables")
STATEMENTS = [
    (table, statement)
    for table, described in TABLES.items()
    for statement in read_yaml(ROOT / described["folder"] / described["statements"])
]


@pytest.mark.parametrize(("table", "statement"), STATEMENTS, ids=lambda one: str(one)[:60])
def test_every_statement_can_be_measured_and_judged(table, statement):
    assert callable(find_measure(statement["measure"]))
    made = {name.rpartition("/")[2] for name in TABLES[table]["data"]}
    assert set(scenes_of(statement)) <= made
    if statement["expected"] == NOT_JUDGED:
        assert statement["not_judged"]
        return
    assert statement["expected"] in ANSWERS[statement["kind"]]
    assert (statement["kind"] == "finding") == ("printed" not in statement)
    low, high, _ = range_of_criterion(criterion_of(statement))
    assert low < high


def test_the_run_by_default_makes_nothing_of_a_paper(tmp_path):
    plan = jobs_due("--config", f"results={tmp_path}", "--", "all", "papers/rosas_2007", "papers")
    assert not [job for job in plan["all"] if "rosas_2007" in job]
    assert plan["papers/rosas_2007"] >= {
        "initiate_front scene: rosas_2007_weak",
        "study study: fronts/rosas_2007_fronts",
        "plot_rosas_2007_pulses",
        "tabulate_rosas_2007_statements",
        "check_rosas_2007",
    }
    assert plan["papers"] >= plan["papers/rosas_2007"] - {"papers/rosas_2007"}
    assert "initiate_front scene: initiation_underdamped" not in plan["papers"]


def read(folder, **given):
    """A paper with what is given, as the workflow reads it."""
    file = folder / "author_2026" / "paper.yaml"
    file.parent.mkdir()
    file.write_text(yaml.safe_dump(given), encoding="utf-8")
    return papers_of_others._read_paper(file)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"scene": {}}, "has scene: its keys are title, scenes, studies, figures, tables"),
        ({"scenes": {"chains": {}}}, r"has scenes\.chains: choose chain or"),
        ({"figures": {"pulses": {}}}, "names pulses, but its names begin with author_2026_"),
        (
            {"scenes": {"chain": {"author_2026_a": {"beads": 4}}}},
            "Scene author_2026_a: law is missing",
        ),
    ],
)
def test_a_mistake_in_a_paper_is_a_sentence(tmp_path, given, words):
    with pytest.raises(InputError, match=words):
        read(tmp_path, **given)


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    """A copy of the project with the paper of the page."""
    copy = lend_kernels(copy_project(tmp_path_factory.mktemp("project")))
    for subject in SUBJECTS:
        assert all(
            name.startswith("papers/author_2026/") for name in carry_out(copy, subject, page=PAGE)
        )
    return copy


@pytest.mark.slow
def test_a_paper_is_added_as_the_page_says(project):
    wanted = [shlex.split(line)[-1] for line in commands(PAGE)]
    assert wanted == ["papers/author_2026", "author_2026_wave"]
    outcome = snakemake(*wanted, folder=project)
    assert outcome.returncode == 0, outcome.stderr
    verdict = (project / "results/papers/author_2026.txt").read_text(encoding="utf-8")
    assert verdict == "All 1 verdicts are the expected ones.\n"
    [row] = pd.read_csv(project / "results/tables/author_2026_statements.csv").to_dict("records")
    assert row["computed"] == pytest.approx(1.0, abs=1e-4)
    assert (project / "results/figures/author_2026_wave.png").exists()


@pytest.mark.slow
def test_another_verdict_than_the_expected_one_ends_the_run(project):
    statements = project / "papers/author_2026/statements.yaml"
    written = statements.read_text(encoding="utf-8")
    statements.write_text(written.replace('"1.00"', '"1.10"'), encoding="utf-8")
    outcome = snakemake("papers/author_2026", folder=project)
    statements.write_text(written, encoding="utf-8")
    assert outcome.returncode != 0
    assert "not reproduced, but reproduced is expected" in outcome.stdout + outcome.stderr


@pytest.mark.slow
def test_the_page_of_a_paper_shows_what_is_computed(project):
    outcome = snakemake("papers/rosas_2007", folder=project)
    assert outcome.returncode == 0, outcome.stderr
    page = (ROOT / "docs/papers/rosas_2007.md").read_text(encoding="utf-8")
    shown = [
        float(number.replace("−", "-"))
        for number in re.findall(r"^\| .* \| ([−\d.]+)(?: ± [\d.]+)? \|$", page, re.MULTILINE)
    ]
    rows = pd.read_csv(project / "results/tables/rosas_2007_statements.csv")
    computed = rows["computed"][[0, 2, 3, 4, 5]]
    assert shown == pytest.approx(computed.tolist(), rel=3e-3)
    [separation] = re.findall(r"two pulses is γ = ([\d.]+) ± ([\d.]+)\.", page)
    assert float(separation[0]) == pytest.approx(
        rows["computed"].iloc[-1], abs=float(separation[1])
    )
    listed = load_script("generate").papers_page(project / "results")
    for row in pd.read_csv(project / "results/tables/rosas_2007_findings.csv").itertuples():
        [value] = re.findall(
            rf"^\| {re.escape(row.quantity)} \| (\S+) ± \S+ \|", listed, re.MULTILINE
        )
        assert float(value.replace("−", "-")) == pytest.approx(row.computed, abs=row[3])
        assert row.verdict == "holds"
    front = read_dataset(project / "results/data/fronts/rosas_2007_fronts.nc")
    [pair] = re.findall(r"overshoot is ([\d.]+), that of the exact front ([\d.]+)\.", page)
    last = front.sel(gamma=0.05).isel(contact=-1)
    assert float(pair[0]) == pytest.approx(float(last["overshoot"]), abs=5.1e-5)
    assert float(pair[1]) == pytest.approx(float(last["exact_overshoot"]), abs=5.1e-5)
    [places] = re.findall(r"^(\d+) for γ = 0.1, ([\d ]+) for γ = 0.05 and (\d+) for", page, re.M)
    found = front["contact_of_critical_damping"].sel(gamma=[0.1, 0.05, 0.3]).values
    assert [float(place.replace(" ", "")) for place in places] == pytest.approx(found, rel=0.03)


def page_beside_run(project, paper):
    """The page of a paper, after the run that it shows."""
    outcome = snakemake(f"papers/{paper}", folder=project)
    assert outcome.returncode == 0, outcome.stderr
    return (ROOT / f"docs/papers/{paper}.md").read_text(encoding="utf-8")


@pytest.mark.slow
def test_the_page_on_dispersive_shocks_shows_what_is_computed(project):
    page = page_beside_run(project, "weak_damping")
    shown = re.findall(r"^\| .* \| ([\d.]+) ± ([\d.]+) \|$", page, re.MULTILINE)
    rows = pd.read_csv(project / "results/tables/weak_damping_findings.csv")
    found = rows[["computed", "numerical error"]].values
    for (value, error), (computed, stated) in zip(shown, found, strict=True):
        assert float(value) == pytest.approx(computed, abs=float(error))
        assert float(error) == pytest.approx(stated, rel=0.3, abs=1e-8)


@pytest.mark.slow
def test_the_page_on_dimers_shows_what_is_computed(project):
    page = page_beside_run(project, "jayaprakash_2011")
    rows = re.findall(r"^\| (\d) \| ([\d.]+) \| ([^|]+) \| ([^|]+) \|$", page, re.MULTILINE)
    found = read_dataset(project / "results/data/chain/jayaprakash_2011_ratios.nc")
    assert len(rows) == found.sizes["order"] == found.sizes["resonance_order"]
    for order, (_, exact, *others) in enumerate(rows):
        assert float(exact) == pytest.approx(float(found["antiresonance"][order]), abs=1e-14)
        for shown, name in zip(others, ("resonance", "resonance_attenuation"), strict=True):
            value, error = found[name][order], found[f"{name}_error"][order]
            if "±" not in shown:
                assert float(shown.split(",")[0]) == pytest.approx(float(value), rel=5e-3)
                continue
            number, stated = map(float, shown.split(" ± "))
            assert number == pytest.approx(float(value), abs=stated)
            assert 0.9 * float(error) <= stated <= 2.0 * float(error)
