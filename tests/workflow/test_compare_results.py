"""Changes between two results folders, in units of the errors that they state."""

import csv

import numpy as np
import pytest
import xarray as xr
from compare_results import compare_results

from granular_fronts.output.datasets import write_dataset

ERROR = 1.0e-9


def compare(tmp_path, before, after, errors=None):
    """The rows of the report, whether or not the comparison ends with an error.

    Each folder has one dataset of speeds, each with its error or all with the same.
    """
    for name, speeds in (("before", before), ("after", after)):
        dataset = xr.Dataset({"speed": ("law", np.asarray(speeds))})
        dataset["speed"].attrs = {"error_estimate": ERROR, "error_method": "given"}
        if errors is not None:
            dataset["speed_error"] = ("law", np.asarray(errors))
        path = tmp_path / name / "data/fronts/scene.nc"
        write_dataset(dataset, path, scene_id="scene", config={})
    report = tmp_path / "changes.csv"
    try:
        compare_results(tmp_path / "before", tmp_path / "after", report)
    finally:
        with report.open() as file:
            rows = list(csv.DictReader(file))
    return rows


@pytest.mark.parametrize(
    ("before", "after", "ratio"),
    [*((0.0, units * ERROR, units / 2.0) for units in (0.0, 0.5, 1.9)), (np.nan, np.nan, 0.0)],
)
def test_a_change_within_both_errors_passes(tmp_path, capsys, before, after, ratio):
    rows = compare(tmp_path, [before, 1.0], [after, 1.0])
    assert float(rows[0]["over_stated_error"]) == pytest.approx(ratio)
    assert "1 variables of 1 datasets" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("before", "after", "errors", "words"),
    [
        (0.0, 2.1 * ERROR, None, r"1\.1 times the stated errors, in speed of fronts/scene"),
        (0.0, 1.0e-12, [1.0e-13, 1.0e-9], "5 times the stated errors"),
        (np.nan, 0.0, None, "inf times the stated errors"),
        (0.0, np.nan, None, "inf times the stated errors"),
    ],
    ids=["larger", "its own error", "appears", "vanishes"],
)
def test_a_larger_change_is_named(tmp_path, before, after, errors, words):
    with pytest.raises(ValueError, match=words):
        compare(tmp_path, [before, 1.0], [after, 1.0], errors)


def test_folders_without_a_shared_dataset_are_refused(tmp_path):
    with pytest.raises(ValueError, match="share no dataset"):
        compare_results(tmp_path, tmp_path / "empty", tmp_path / "changes.csv")
