"""The README's picture: a front until it is back, a still of three times, and their record."""

import numpy as np
import pytest
from animate_front import CROSSINGS, FRAMES, STILLS, animate_front, at_times
from chains import driven_scene
from PIL import Image
from projects import ROOT

import granular_fronts as gf
from granular_fronts.accuracy import certain_sign
from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import digest, source_of

BEADS = 40


def write_scene(folder, gamma):
    record = {"snapshots": [], "grid": {"step": 1.0}, "arrival_level": 0.05}
    scene = driven_scene(gamma, BEADS, 160.0, record=record)
    write_dataset(gf.simulate_chain(scene), folder / "scene.nc", scene_id="scene", config=scene)
    return folder / "scene.nc"


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return write_scene(tmp_path_factory.mktemp("data"), gamma=0.06)


@pytest.fixture(scope="module")
def folder(dataset):
    files = {name: dataset.with_name(f"front.{name}") for name in ("gif", "pdf", "png")}
    animate_front(dataset, **files, provenance=dataset.with_name("front.json"))
    return dataset.parent


def test_the_picture_lasts_until_the_reflected_wave_is_back(dataset, folder):
    motion = read_dataset(dataset)
    shown = int(CROSSINGS * float(motion["arrival_time"].max())) + 1
    assert motion.sizes["t_grid"] > FRAMES > shown > 100
    with Image.open(folder / "front.gif") as picture:
        assert picture.n_frames == shown
    # The front runs at c = δ^(1/4).
    assert float(motion["arrival_time"].max()) == pytest.approx(BEADS / 0.1**0.25, rel=0.1)


def test_the_still_shows_the_front_before_and_after_its_reflection(dataset):
    motion = read_dataset(dataset)
    crossing = float(motion["arrival_time"].max())
    moments = at_times(motion, [share * crossing for share in STILLS])
    np.testing.assert_allclose(moments["t"], np.multiply(STILLS, crossing), atol=0.5)
    for row, time in enumerate(moments["t"].values):
        expected = motion["relative_displacement_grid"].sel(t_grid=time)
        np.testing.assert_array_equal(moments["relative_displacement"][row], expected)
    opened = (certain_sign(moments["relative_displacement"]) < 0).any("bead")
    assert opened.values.tolist() == [False, True, True]


def test_the_record_names_data_and_files(dataset, folder):
    record = read_json(folder / "front.json")
    assert record["made_from"] == [source_of(read_dataset(dataset))]
    assert record["files"] == {
        f"front.{ending}": digest((folder / f"front.{ending}").read_bytes())
        for ending in ("gif", "pdf", "png")
    }


def test_equal_data_give_equal_pictures(dataset, folder, tmp_path):
    files = {name: tmp_path / f"front.{name}" for name in ("gif", "pdf", "png")}
    animate_front(dataset, **files, provenance=tmp_path / "front.json")
    for path in files.values():
        assert path.read_bytes() == (folder / path.name).read_bytes()


def test_the_picture_of_the_readme_is_small_and_moves():
    path = ROOT / "docs" / "front.gif"
    assert path.stat().st_size < 2**20
    with Image.open(path) as picture:
        assert picture.n_frames == FRAMES
    assert "](docs/front.gif)" in (ROOT / "README.md").read_text(encoding="utf-8")
