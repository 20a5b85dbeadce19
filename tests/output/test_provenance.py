"""Records say what a figure or a table was made from, and disagreements are found."""

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

from granular_fronts.errors import InputError
from granular_fronts.output.datasets import read_dataset, read_origins, write_dataset
from granular_fronts.output.provenance import (
    data_digest,
    disagreements,
    origin,
    question_digest,
    read_record,
)
from granular_fronts.output.tables import write_table
from questions import questions, questions_on_demand

SCENE = {"law": {"alpha": 1.5, "gamma": 0.06}, "beads": 4}
NAME = "chain/scene"


def make_data(folder, scene=SCENE, shift=0.0):
    """A small dataset, and a table of its numbers."""
    velocity = xr.Variable("bead", np.arange(4.0) + shift, {"error_estimate": 0.0})
    dataset = xr.Dataset({"velocity": velocity}, {"bead": [1, 2, 3, 4]})
    write_dataset(dataset, folder / "data" / f"{NAME}.nc", scene_id="scene", config=scene)


def make_table(folder):
    """A table of the numbers in the dataset, with its record."""
    dataset = read_dataset(folder / "data" / f"{NAME}.nc")
    table = pd.DataFrame({"velocity": dataset["velocity"]})
    write_table(table, table, folder / "table.csv", folder / "table.md", [dataset])
    return folder / "table.json"


def found(folder, asked=SCENE):
    origins = read_origins(folder / "data", [NAME])
    return list(disagreements([folder / "table.json"], origins, {NAME: asked}))


@pytest.fixture
def results(tmp_path):
    make_data(tmp_path)
    make_table(tmp_path)
    return tmp_path


def test_what_belongs_together_agrees(results):
    assert found(results) == []


def test_record_names_its_files_and_the_origin_of_its_numbers(results):
    record = read_record(results / "table.json")
    assert list(record["files"]) == ["table.csv", "table.md"]
    attributes = read_dataset(results / "data" / f"{NAME}.nc").attrs
    assert record["made_from"] == [origin(attributes)]
    assert record["made_from"][0]["question"] == question_digest(SCENE)


def test_other_configuration_is_found(results):
    [sentence] = found(results, SCENE | {"beads": 5})
    assert sentence == "The data chain/scene answer another configuration: run the workflow again."


def test_missing_data_are_found(results):
    (results / "data" / f"{NAME}.nc").unlink()
    missing, unknown = found(results)
    assert missing.startswith("The data chain/scene are missing")
    assert unknown.startswith("table was made from other data of scene scene")


@pytest.mark.parametrize("change", [{"shift": 1e-15}, {"scene": SCENE | {"beads": 5}}])
def test_table_of_older_data_is_found(results, change):
    make_data(results, **change)
    sentences = found(results, change.get("scene", SCENE))
    assert sentences == [
        "table was made from other data of scene scene than lie there now: run the workflow again."
    ]


def test_changed_file_is_found(results):
    with (results / "table.csv").open("a") as table:
        table.write("1\n")
    [sentence] = found(results)
    assert "table.csv is not the file that its record describes" in sentence


def test_digest_of_a_question_ignores_the_order_of_keys_alone():
    swapped = {"beads": 4, "law": {"gamma": 0.06, "alpha": 1.5}}
    assert question_digest(SCENE) == question_digest(swapped)
    assert question_digest(SCENE) != question_digest(SCENE | {"beads": 5})


def test_digest_of_data_sees_values_names_and_shapes():
    dataset = xr.Dataset({"a": ("x", [1.0, 2.0]), "word": ((), "toda")})
    digests = {
        data_digest(other)
        for other in (
            dataset,
            dataset.assign(a=("x", [1.0, np.nextafter(2.0, 3.0)])),
            dataset.rename(a="b"),
            dataset.assign(a=("y", [1.0])),
            dataset.assign(word=((), "fpu")),
        )
    }
    assert len(digests) == 5
    assert data_digest(dataset) == data_digest(dataset.assign_attrs(solver="other"))


def test_data_read_back_have_the_digest_they_were_written_with(tmp_path):
    """A file keeps neither the type of text nor the sign of what is not a number."""
    texts = np.array(["", "stopped"], dtype=object)
    values = {"value": [-np.nan, -0.0], "message": texts, "passed": [True, False], "step": [1, 2]}
    given = xr.Dataset({name: ("case", value) for name, value in values.items()})
    write_dataset(given, tmp_path / "scene.nc", scene_id="scene", config={})
    dataset = read_dataset(tmp_path / "scene.nc")
    assert dataset.attrs["data_digest"] == data_digest(given) == data_digest(dataset)


@pytest.mark.parametrize(
    ("seconds", "altered"), [(0.0, False), (1.5, False), (-3.0, True), (3.0, True), (86400.0, True)]
)
def test_file_whose_time_is_not_the_one_that_was_noted_is_altered(results, seconds, altered):
    """An archive may round a time to two seconds."""
    file = results / "table.csv"
    noted = SimpleNamespace(endtime=file.stat().st_mtime)
    os.utime(file, (noted.endtime + seconds,) * 2)
    assert is_altered(str(file), noted) == altered
    assert not is_altered(str(results / "absent.csv"), noted)


def test_damaged_record_is_named(results):
    (results / "table.json").write_text('{"files": {')
    with pytest.raises(InputError, match=r"table\.json is damaged .*: delete it and run the work"):
        found(results)


def test_every_dataset_of_a_figure_answers_a_question():
    configuration = yaml.safe_load((ROOT / "config/default.yaml").read_text(encoding="utf-8"))
    figures = yaml.safe_load((ROOT / "workflow/figures.yaml").read_text(encoding="utf-8"))
    asked = questions(configuration) | questions_on_demand(configuration)
    for described in figures.values():
        for named in described["data"].values():
            if isinstance(named, str) and not named.startswith("campaigns/"):
                assert named in asked
    json.dumps(asked)
