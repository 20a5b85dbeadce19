"""Files are whole, described, and refused with a sentence when they are not ours."""

import json

import netCDF4
import numpy as np
import pytest
import xarray as xr
from chains import driven_scene

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output.datasets import (
    DatasetError,
    data_digest,
    long_name,
    long_names,
    read_dataset,
    write_dataset,
)

EVERYTHING = {
    "snapshots": [5.0, 20.0],
    "probes": {"start": {"beads": [1, 2], "start": 0.0, "stop": 20.0, "step": 0.5}},
    "grid": {"step": 2.0},
    "arrival_level": 0.05,
    "extremes": True,
    "balances": True,
}


@pytest.fixture(scope="module")
def scene():
    return driven_scene(end_time=20.0, record=EVERYTHING)


@pytest.fixture(scope="module")
def dataset(scene):
    return simulate_chain(scene)


@pytest.fixture
def path(dataset, scene, tmp_path):
    write_dataset(dataset, tmp_path / "deep" / "scene.nc", scene_id="short", config=scene)
    return tmp_path / "deep" / "scene.nc"


def test_values_survive_and_every_variable_is_described(dataset, scene, path):
    stored = read_dataset(path, "short")
    xr.testing.assert_equal(stored, dataset)
    for name, variable in (*stored.variables.items(), *dataset.variables.items()):
        assert variable.attrs["units"] == "1"
        assert variable.attrs["long_name"] == long_name(name)
    for variable in stored.data_vars.values():
        assert variable.attrs["error_estimate"] >= 0.0 or np.isnan(variable).all()
        assert variable.attrs["error_method"]
    attributes = stored.attrs
    assert json.loads(attributes["config"]) == scene
    assert attributes["Conventions"] == "CF-1.11"
    assert "numpy" in attributes["software"]
    for name in ("steps_accepted", "right_hand_sides", "momentum_drift", "energy_drift"):
        assert attributes[name] >= 0
    assert attributes["relative_tolerance"] == scene["tolerance"]["relative"]


def test_suffixes_enter_the_long_names_and_given_ones_stay(tmp_path):
    assert long_name("relative_displacement_grid").endswith("(grid)")
    assert long_name("t_steady") == "time (steady)"
    assert long_name("first_peak_time") == long_names()["first_peak_time"]
    with pytest.raises(KeyError, match=r"unheard_of.*long_names\.yaml"):
        long_name("unheard_of")
    given = xr.Dataset({"unheard_of": ((), 1.0, {"long_name": "words", "units": "m"})})
    write_dataset(given, tmp_path / "given.nc", scene_id="given", config={})
    assert read_dataset(tmp_path / "given.nc")["unheard_of"].attrs == given["unheard_of"].attrs


def test_file_altered_by_its_smallest_bit_is_refused_until_it_is_written_again(path, scene):
    whole = read_dataset(path)
    with netCDF4.Dataset(path, "a") as dataset:
        velocity = dataset["total_velocity"]
        velocity[-1] = np.nextafter(velocity[-1], np.inf)
    with pytest.raises(DatasetError, match=r"scene\.nc was altered"):
        read_dataset(path)
    write_dataset(whole * 2.0, path, scene_id="short", config=scene)
    read_dataset(path)


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
            dataset.assign_coords(x=[0.0, 1.0]),
            dataset.assign_coords(x=[0.0, 2.0]),
        )
    }
    assert len(digests) == 8
    assert data_digest(dataset) == data_digest(dataset.assign_attrs(solver="other"))


def test_data_read_back_have_the_digest_they_were_written_with(tmp_path):
    """A file keeps neither the type of text nor the sign of what is not a number."""
    texts = np.array(["", "stopped"], dtype=object)
    values = {"value": [-np.nan, -0.0], "reason": texts, "converged": [True, False], "step": [1, 2]}
    given = xr.Dataset({name: ("material", value) for name, value in values.items()})
    write_dataset(given, tmp_path / "scene.nc", scene_id="scene", config={})
    dataset = read_dataset(tmp_path / "scene.nc")
    assert dataset.attrs["data_digest"] == data_digest(given) == data_digest(dataset)
    assert data_digest(given) == data_digest(given.assign(value=("material", [np.nan, -0.0])))


def test_what_is_no_dataset_of_this_project_or_scene_is_refused(path, tmp_path):
    foreign = tmp_path / "foreign.nc"
    netCDF4.Dataset(foreign, "w").close()
    with pytest.raises(DatasetError, match=r"foreign\.nc was not written by this project"):
        read_dataset(foreign)
    with pytest.raises(DatasetError, match=r"absent\.nc does not exist"):
        read_dataset(tmp_path / "absent.nc")
    with pytest.raises(DatasetError, match="scene short, but long is expected"):
        read_dataset(path, "long")
    path.write_bytes(path.read_bytes()[:500])
    with pytest.raises(DatasetError, match=r"scene\.nc is not a readable netCDF file"):
        read_dataset(path)
