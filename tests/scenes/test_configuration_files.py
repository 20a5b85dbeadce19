"""YAML files, results folders and the command line: what is wrong is named with its place."""

from pathlib import Path

import pytest
from configurations import DEFAULT, ROOT, SMOKE, assert_refused
from pages import run_module

from granular_fronts.scenes.configuration import check_configuration, folder_errors
from granular_fronts.scenes.yaml_files import load_configuration, merge, parse_yaml
from projects import snakemake


def test_shipped_files_are_accepted_and_smoke_changes_values_but_not_what_is_drawn(default):
    smoke = load_configuration(DEFAULT, SMOKE)
    for configuration in (default, smoke):
        check_configuration(configuration)
    assert smoke["results"] != default["results"]
    for name, scene in default["scenes"]["chain"].items():
        record = smoke["scenes"]["chain"][name]["record"]
        assert record.keys() == scene["record"].keys()
        assert record["probes"].keys() == scene["record"]["probes"].keys()


def test_merge_goes_deep_and_replaces_lists():
    below = {"a": {"b": 1, "c": [1, 2, 3]}, "d": 4}
    above = {"a": {"c": [5]}}
    assert merge(below, above) == {"a": {"b": 1, "c": [5]}, "d": 4}
    assert below["a"]["c"] == [1, 2, 3]


PRESSURE = {"kind": "pressure", "left": 0.1, "right": 0}
TODA = {"elastic": {"kind": "toda", "rate": 2}}


@pytest.mark.parametrize(
    ("key", "below", "above", "merged"),
    [
        (
            "boundary",
            PRESSURE,
            {"kind": "piston", "velocity": 1},
            {"kind": "piston", "velocity": 1},
        ),
        ("boundary", PRESSURE, {"kind": "pressure", "left": 2}, PRESSURE | {"left": 2}),
        ("boundary", PRESSURE, {"left": 2}, PRESSURE | {"left": 2}),
        ("law", {"alpha": 1.5, "gamma": 0.1}, TODA, TODA),
        ("law", TODA, {"alpha": 2}, {"alpha": 2}),
        ("law", {"alpha": 1.5}, {"viscous": None}, {"viscous": None}),
        ("law", {"alpha": 1.5, "gamma": 0.1}, {"gamma": 1}, {"alpha": 1.5, "gamma": 1}),
        ("law", TODA, {"elastic": {"rate": 1}}, {"elastic": {"kind": "toda", "rate": 1}}),
        ("force", {"pulse": {"height": 1}}, {"table": {"times": [0]}}, {"table": {"times": [0]}}),
        ("force", {"pulse": {"height": 1}}, {"pulse": {"height": 2}}, {"pulse": {"height": 2}}),
        ("probes", {"pulse": {"step": 1}}, {"table": {}}, {"pulse": {"step": 1}, "table": {}}),
        ("probes", {"kind": {"step": 1}}, {"kind": {"stop": 2}}, {"kind": {"step": 1, "stop": 2}}),
        ("record", {"grid": {"step": 5}, "extremes": True}, {"grid": None}, {"extremes": True}),
        # A decimal comma in braces, {alpha: 1,5}, is not lost.
        ("law", {"alpha": 1.5}, {"alpha": 1, 5: None}, {"alpha": 1, 5: None}),
    ],
)
def test_merge_replaces_what_is_of_another_kind_and_takes_away_what_is_null(
    key, below, above, merged
):
    assert merge({key: below}, {key: above}) == {key: merged}


@pytest.mark.parametrize(
    ("results", "words"),
    [
        ("$HOME/x", "results is '$HOME/x' | '$'"),
        (" x", "blanks around"),
        ("x" * 10_000, "File name too long"),
        ("~/x", f"results is ~/x | {Path.home()}/x"),
        ("pyproject.toml/results", "pyproject.toml is a file"),
        *[(name, None) for name in ("results", "results/smoke", "/tmp", "resultate-2é")],
    ],
)
def test_folder_that_cannot_receive_results_is_refused(monkeypatch, results, words):
    monkeypatch.chdir(ROOT)
    found = [*folder_errors(results)]
    assert len(found) == (words is not None)
    for sentence in found:
        assert_refused(sentence, words)


def test_folder_that_is_not_writable_is_refused_where_something_is_written(monkeypatch, tmp_path):
    monkeypatch.setattr("os.access", lambda path, mode: path != tmp_path)
    [sentence] = folder_errors(str(tmp_path / "new" / "results"))
    assert f"nothing can be written into {tmp_path}" in sentence
    assert not [*folder_errors(str(tmp_path / "new" / "results"), writes=False)]


def test_merged_keys_may_be_overridden():
    """The key that overrides a merged one stands once; so it does where it is merged again."""
    text = "a: &a {x: 1, y: 2}\nb: &b\n  <<: *a\n  x: 3\nc:\n  <<: *b\n  y: 4\nd: *b"
    loaded = parse_yaml(text, "mine.yaml")
    assert loaded["c"] == {"x": 3, "y": 4}
    assert loaded["d"] == {"x": 3, "y": 2}


REPEATED = "results: results/a\nresults: results/b\n"
PLACE = "mine.yaml, line 2, column 1: the key results is given twice"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (REPEATED, PLACE),
        (
            "scenes: {chain: {initiation_overdamped: {law: {gamma: -0.5}}}}",
            "Scene initiation_overdamped: law.gamma is -0.5",
        ),
        ("results: pyproject.toml", "pyproject.toml is a file"),
    ],
)
def test_program_says_what_is_wrong(tmp_path, monkeypatch, text, words):
    monkeypatch.chdir(ROOT)
    file = tmp_path / "mine.yaml"
    file.write_text(text, encoding="utf-8")
    assert words in run_module(monkeypatch, "granular_fronts.scenes", DEFAULT, file)


@pytest.mark.parametrize(
    ("option", "given", "words"),
    [
        ("--configfile", "mine.yaml", PLACE),
        ("--config", "scenes={chain: {a: {law: {gamma: 0.2}}}}", "--configfile mine"),
    ],
)
def test_workflow_says_where_a_file_is_wrong_and_what_mappings_need(tmp_path, option, given, words):
    """Snakemake hands over merged values only, in which one of two repeated keys is lost."""
    file = tmp_path / "mine.yaml"
    file.write_text(REPEATED, encoding="utf-8")
    run = snakemake("--dry-run", "fig04", option, given.replace(file.name, str(file)))
    assert run.returncode == 1
    assert words in run.stderr
    assert "Traceback" not in run.stderr
    assert "File " not in run.stderr
