"""Errors and times of the solvers: the second opinion, the measurement, and its table."""

import numpy as np
import pandas as pd
import pytest
from measure_log_burgers import measure_scene
from rings import SCENES, scene_with
from tabulate_log_burgers import COLUMNS, tabulate_log_burgers

from granular_fronts.continuum.log_burgers.solution import solve
from granular_fronts.output.datasets import write_dataset
from granular_fronts.reference_methods.fourier import evolve_fourier


@pytest.mark.parametrize("name", ["weak", "hertz"])
def test_fourier_method_and_finite_volumes_agree(name):
    scene = scene_with(name, end_time=30.0)
    accurate = solve(scene, 1.0, [30.0], 2048, 1e-9)
    run = evolve_fourier(scene, 1024, 0.005)
    assert np.abs(run.values - accurate.rescaled_force(0, run.xi)).max() < 2.0e-8


def test_steps_of_the_fourier_method_are_of_fourth_order():
    scene = scene_with("hertz", end_time=30.0)
    runs = [evolve_fourier(scene, 512, step) for step in (0.02, 0.01, 0.0025)]
    errors = [np.abs(run.values - runs[-1].values).max() for run in runs[:-1]]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(4.0, abs=0.2)


def test_measured_errors_are_those_of_the_schemes():
    problem = {
        "reference": {"cells": 1024, "tolerance": 1e-9, "points": 512, "longest_step": 0.005},
        "upwind_points": [500, 1000],
        "cells": [128, 256],
        "longest_steps": [0.02],
        "repeats": 1,
    }
    runs = pd.DataFrame(measure_scene("weak", problem, SCENES["weak"]))
    errors = runs.set_index(["start", "scheme", "grid"])["error"]
    assert runs["reference_error"].max() < 1e-8
    assert errors["kinks", "upwind", 1000] == pytest.approx(2.8e-2, rel=0.02)
    assert errors["kinks", "finite_volumes", 256] < 1e-5
    assert errors["kinks", "uniform_cells", 256] > 2.0 * errors["kinks", "finite_volumes", 256]
    assert errors["smooth", "finite_volumes", 256] < 1e-5
    assert errors["kinks", "fourier", 512] < 1e-6
    assert (runs["seconds"] > 0).all()


def test_table_holds_order_and_verdict(tmp_path):
    grids = {"upwind": ([100, 200], [0.4, 0.2], [1.0, 8.0])}
    grids["finite_volumes"] = ([10, 20, 40], [6.4e-3, 1e-4, 1.5625e-6], [1e-3, 2e-3, 4e-3])
    rows = [
        {"scene": "weak", "alpha": 1.1, "start": "kinks", "scheme": scheme, "grid": grid}
        | {"setting": 1e-3, "error": error, "reference_error": 1e-11, "seconds": seconds}
        | {"steps": 1, "right_hand_sides": 10}
        for scheme, columns in grids.items()
        for grid, error, seconds in zip(*columns, strict=True)
    ]
    dataset = pd.DataFrame(rows).rename_axis("run").to_xarray()
    path = tmp_path / "log_burgers.nc"
    config = {"weak": {"problem": {"milliseconds": 5}}}
    write_dataset(dataset, path, scene_id="precision_log_burgers", config=config)
    tabulate_log_burgers(path, tmp_path / "a.csv", tmp_path / "a.md")
    table = pd.read_csv(tmp_path / "a.csv")
    assert list(table.columns) == COLUMNS
    np.testing.assert_allclose(table["order"], [np.nan, 1.0, np.nan, 6.0, 6.0])
    sentence = (tmp_path / "a.md").read_text(encoding="utf-8").splitlines()[-1]
    assert "errs by 0.2 and takes 8e+03 ms" in sentence
    assert "8e+03 times faster (asked: 1000)" in sentence
    assert "to 1e-05 in 4 ms (asked: 5 ms) and to 1e-08 never: not all" in sentence
