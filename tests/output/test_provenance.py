"""Provenance says what a figure or a table was made from, and disagreements are found."""

import json
import os
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest
import xarray as xr
import yaml
from altered_files import is_altered
from projects import ROOT

from dataset_parameters import default_parameters, parameters_on_demand, shown_front
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import read_dataset, read_sources, write_dataset
from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import (
    code_version,
    config_digest,
    data_digest,
    digest,
    disagreements,
    source_of,
)
from granular_fronts.output.tables import write_table

SCENE = {"law": {"alpha": 1.5, "gamma": 0.06}, "beads": 4}
OTHER = SCENE | {"beads": 5}
NAME = "chain/scene"


def make_data(folder, scene=SCENE, shift=0.0):
    """A small dataset."""
    velocity = xr.Variable("bead", np.arange(4.0) + shift, {"error_estimate": 0.0})
    dataset = xr.Dataset({"velocity": velocity}, {"bead": [1, 2, 3, 4]})
    write_dataset(dataset, folder / "data" / f"{NAME}.nc", scene_id="scene", config=scene)


@pytest.fixture
def results(tmp_path):
    """A dataset, and a table of its numbers."""
    make_data(tmp_path)
    dataset = read_dataset(tmp_path / "data" / f"{NAME}.nc")
    table = pd.DataFrame({"velocity": dataset["velocity"]})
    write_table(table, table, tmp_path / "table.csv", tmp_path / "table.md", [dataset])
    return tmp_path


def found(folder, scene=SCENE):
    sources = read_sources(folder / "data", [NAME, "chain/absent"])
    return list(disagreements(folder / "table.json", {NAME: scene, "chain/absent": {}}, sources))


def test_what_belongs_together_agrees(results):
    assert found(results) == []
    file = results / "table.json"
    provenance = read_json(file)
    assert provenance["code_version"] == code_version()
    assert provenance["files"] == {
        name: digest((results / name).read_bytes()) for name in ("table.csv", "table.md")
    }
    dataset = read_dataset(results / "data" / f"{NAME}.nc")
    assert provenance["made_from"] == [source_of(dataset)]
    assert source_of(dataset)["config_digest"] == config_digest(SCENE)
    assert list(disagreements(file, {"chain/another": OTHER})) == []


def append_to_table(folder):
    with (folder / "table.csv").open("a") as table:
        table.write("1\n")


ANSWERS_ANOTHER, OTHER_DATA = "another configuration of scene scene", "other data of scene scene"


@pytest.mark.parametrize(
    ("change", "scene", "words"),
    [
        (lambda folder: None, OTHER, ANSWERS_ANOTHER),
        (lambda folder: make_data(folder, OTHER), OTHER, ANSWERS_ANOTHER),
        (lambda folder: make_data(folder, OTHER), SCENE, OTHER_DATA),
        (lambda folder: make_data(folder, shift=1e-15), SCENE, OTHER_DATA),
        (lambda folder: (folder / "data" / f"{NAME}.nc").unlink(), SCENE, OTHER_DATA),
        (append_to_table, SCENE, "table.csv is not the file"),
        (lambda folder: (folder / "table.md").unlink(), SCENE, "table.md is not the file"),
    ],
)
def test_what_does_not_belong_together_is_found(results, change, scene, words):
    change(results)
    [sentence] = found(results, scene)
    assert words in sentence


def test_damaged_provenance_is_named(results):
    (results / "table.json").write_text('{"files": {')
    with pytest.raises(InputError, match=r"table\.json is damaged"):
        found(results)


def test_digest_of_parameters_ignores_the_order_of_keys_alone():
    swapped = {"beads": 4, "law": {"gamma": 0.06, "alpha": 1.5}}
    assert config_digest(SCENE) == config_digest(swapped) != config_digest(OTHER)


def test_digest_of_data_sees_values_names_and_shapes():
    dataset = xr.Dataset({"a": ("x", [1.0, 2.0]), "word": ((), "toda")})
    digests = {
        data_digest(other)
        for other in (
            dataset,
            dataset.assign(a=("x", [1.0, np.nextafter(2.0, 3.0)])),
            dataset.rename(a="b"),
            dataset.assign(a=(("y", "z"), [[1.0, 2.0]])),
            dataset.assign(a=("x", [1, 2])),
            dataset.assign(word=((), "fpu")),
        )
    }
    assert len(digests) == 6
    assert data_digest(dataset) == data_digest(dataset.assign_attrs(solver="other"))


def test_data_read_back_have_the_digest_they_were_written_with(tmp_path):
    """A file keeps neither the type of text nor the sign of what is not a number."""
    texts = np.array(["", "stopped"], dtype=object)
    values = {"value": [-np.nan, -0.0], "message": texts, "passed": [True, False], "step": [1, 2]}
    given = xr.Dataset({name: ("case", value) for name, value in values.items()})
    write_dataset(given, tmp_path / "scene.nc", scene_id="scene", config={})
    dataset = read_dataset(tmp_path / "scene.nc")
    assert dataset.attrs["data_digest"] == data_digest(given) == data_digest(dataset)
    assert data_digest(given) == data_digest(given.assign(value=("case", [np.nan, -0.0])))


@pytest.mark.parametrize(
    ("seconds", "altered"), [(0.0, False), (1.5, False), (-3.0, True), (3.0, True)]
)
def test_file_whose_time_is_not_the_one_that_was_noted_is_altered(tmp_path, seconds, altered):
    """An archive may round a time to two seconds."""
    file = tmp_path / "table.csv"
    file.touch()
    noted = SimpleNamespace(endtime=file.stat().st_mtime)
    os.utime(file, (noted.endtime + seconds,) * 2)
    assert is_altered(str(file), noted) == altered
    assert not is_altered(str(tmp_path / "absent.csv"), noted)
    assert not is_altered(str(file), None)


def test_every_dataset_of_a_figure_has_parameters(default):
    figures = yaml.safe_load((ROOT / "workflow/figures.yaml").read_text(encoding="utf-8"))
    parameters = default_parameters(default) | parameters_on_demand(default)
    for described in figures.values():
        for named in described["data"].values():
            if isinstance(named, str) and not named.startswith("campaigns/"):
                assert named in parameters
    assert parameters["chain/initiation_overdamped"]["law"]["gamma"] == 0.65
    assert shown_front(default).keys() > {"name", "gamma"}
    json.dumps(parameters)
