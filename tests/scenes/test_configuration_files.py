"""YAML files, results folders and the command line: what is wrong is named with its place."""

import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from configurations import DEFAULT, ROOT, SMOKE

from granular_fronts.errors import InputError
from granular_fronts.scenes.configuration import argument_errors, check_configuration, folder_errors
from granular_fronts.scenes.yaml_files import LONGEST_FILE, load_configuration, merge, read_yaml


@pytest.mark.parametrize("files", [[DEFAULT], [DEFAULT, SMOKE]], ids=["default", "smoke"])
def test_configuration_files_are_accepted(files):
    check_configuration(load_configuration(*files))


def test_smoke_changes_values_but_not_what_is_drawn(default):
    smoke = load_configuration(DEFAULT, SMOKE)
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


def test_checking_waits_for_no_heavy_import():
    module = "granular_fronts.scenes.configuration"
    code = f"import {module}, sys; print({{'numpy', 'numba'}} & set(sys.modules))"
    environment = {"PYTHONPATH": str(ROOT / "src")}
    command = [sys.executable, "-c", code]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert run.stdout == "set()\n"


@pytest.mark.parametrize(
    ("results", "words"),
    [
        ("$HOME/x", ["'$'", "use letters"]),
        ("x" * 10_000, ["File name too long", "shorten it"]),
        ("~/x", ["results is ~/x", f"write {Path.home()}/x"]),
        ("pyproject.toml/results", ["pyproject.toml is a file", "name a folder"]),
    ],
)
def test_folder_that_cannot_receive_results_is_refused(monkeypatch, results, words):
    monkeypatch.chdir(ROOT)
    [sentence] = folder_errors(results)
    for word in words:
        assert word in sentence


def test_folder_that_is_not_writable_is_refused(monkeypatch, tmp_path):
    monkeypatch.setattr("os.access", lambda path, mode: path != tmp_path)
    [sentence] = folder_errors(str(tmp_path / "new" / "results"))
    assert f"nothing can be written into {tmp_path}" in sentence
    assert not [*folder_errors(str(tmp_path / "new" / "results"), writes=False)]


@pytest.mark.parametrize("results", ["results", "results/smoke", "/tmp", "resultate-2é"])
def test_usual_folder_is_accepted(results):
    assert not [*folder_errors(results)]


def test_mapping_after_config_names_the_way():
    [sentence] = argument_errors({"scenes": {"chain": {}}, "results": "x", "chunk_seconds": 3})
    assert "--config scenes=…" in sentence
    assert "--configfile mine.yaml" in sentence


BOMB = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n" + "".join(
    f"a{i}: &a{i} [{','.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 10)
)
"""Ten thousand million values in ten lines."""

YAML_REFUSED = [
    ("a: b: c", ["line 1, column 5", "no YAML", "correct it"]),
    ("a: 1\nb: {c: 1, d: 2, c: 3}", ["line 2, column 17", "the key c stands twice", "keep one"]),
    ("[1, 2]", ["holds no mapping", "write key: value"]),
    ("a: \x00", ["is no YAML"]),
    ("a: 2026-13-45", ["is no YAML (month must be in 1..12)"]),
    ("a: 1\ngamma: 1:30", ["line 2, column 8", "YAML reads 1:30 as 90", "the number you mean"]),
    ("a: {beads: 0420}", ["line 1, column 12", "YAML reads 0420 as 272"]),
    ("a: &a {b: *a}", ["line 1, column 11", "*a stands inside itself"]),
    ("{a: " * 100_000, ["column 397", "more than 100 mappings or lists nest here"]),
    (BOMB, ["line 6, column 46", "more than 1,000,000 values", "write fewer"]),
    ("__use_yte__: true\na: ?1 + 1", ["is a template", "runs as Python"]),
]


@pytest.mark.parametrize(("text", "words"), YAML_REFUSED)
def test_wrong_yaml_is_refused_with_its_place(tmp_path, text, words):
    file = tmp_path / "mine.yaml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load_configuration(DEFAULT, file)
    [sentence] = str(caught.value).splitlines()
    assert sentence.startswith(str(file))
    for word in words:
        assert word in sentence


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, r"cannot be read .* name a text file"),
        ("a: 1".encode("utf-16"), r"cannot be read .* name a text file in UTF-8"),
        (b" " * (LONGEST_FILE + 1), r"longer than 64 MiB: write fewer"),
    ],
)
def test_file_that_is_no_text_of_usual_length_is_refused(tmp_path, content, words):
    file = tmp_path / "mine.yaml"
    if content:
        file.write_bytes(content)
    with pytest.raises(InputError, match=rf"mine\.yaml (is )?{words}"):
        load_configuration(file)


@pytest.mark.parametrize("text", ["1.5", "1_000", "0.5", "-0", "0", "'1:30'", "'0420'", "07:45"])
def test_number_that_has_one_meaning_is_read(tmp_path, text):
    file = tmp_path / "mine.yaml"
    file.write_text(f"a: {text}", encoding="utf-8")
    assert str(read_yaml(file)["a"]) == str(yaml.safe_load(text))


def test_merged_keys_may_be_overridden(tmp_path):
    """The key that overrides a merged one stands once; so it does where it is merged again."""
    file = tmp_path / "mine.yaml"
    text = "a: &a {x: 1, y: 2}\nb: &b\n  <<: *a\n  x: 3\nc:\n  <<: *b\n  y: 4\nd: *b"
    file.write_text(text, encoding="utf-8")
    loaded = load_configuration(file)
    assert loaded["c"] == {"x": 3, "y": 4}
    assert loaded["d"] == {"x": 3, "y": 2}


def dry_run(*arguments):
    command = [sys.executable, "-m", "snakemake", "--cores", "1", "--dry-run", *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def test_workflow_names_what_only_files_show_and_the_way_beside_mappings(tmp_path):
    """Snakemake hands over merged values only, in which one of two repeated keys is lost."""
    file = tmp_path / "mine.yaml"
    file.write_text("results: results/a\nresults: results/b\n", encoding="utf-8")
    for arguments, words in (
        (["--configfile", str(file)], f"{file}, line 2, column 1: the key results stands twice"),
        (["--config", "scenes={chain: {a: {law: {gamma: 0.2}}}}"], "--configfile mine.yaml"),
    ):
        run = dry_run("fig04", *arguments)
        assert run.returncode == 1
        assert words in run.stderr
        assert "Traceback" not in run.stderr


def test_wrong_file_is_located_from_the_command_line(tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text("a: b: c", encoding="utf-8")
    command = [sys.executable, "-m", "granular_fronts.scenes", DEFAULT, file]
    environment = {"PYTHONPATH": str(ROOT / "src")}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert run.returncode == 1
    assert run.stderr.startswith(f"{file}, line 1, column 5: this is no YAML")
