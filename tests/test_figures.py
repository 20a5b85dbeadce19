"""Figures show the numbers of their datasets: the artists behind each panel, not the pixels."""

import importlib

import matplotlib.pyplot as plt
import numpy as np
import pytest
from chains import driven_scene

from granular_fronts.campaign.chunks import cut
from granular_fronts.campaign.definition import check_campaign
from granular_fronts.campaign.merging import chunk_dataset, merge_chunks
from granular_fronts.chain import simulate_chain
from granular_fronts.datasets import read_dataset, write_dataset

BEADS = 24


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    record = {
        "snapshots": [20.0],
        "probes": {
            "steady": {"beads": [6, 9, 12], "start": 5.0, "stop": 30.0, "step": 0.5},
            "transient": {"beads": [1, 3], "start": 0.0, "stop": 10.0, "step": 0.5},
        },
        "grid": {"step": 2.0},
        "extremes": True,
    }
    scene = driven_scene(0.06, BEADS, 80.0, record=record)
    path = tmp_path_factory.mktemp("data") / "scene.nc"
    write_dataset(simulate_chain(scene), path, scene_id="scene", config=scene)
    return path


@pytest.fixture
def draw(path, monkeypatch, tmp_path):
    """Run a plot script and hand out its figure before it is saved, and its data."""

    def run(name):
        script = importlib.import_module(name)
        kept = []
        monkeypatch.setattr(script, "save_figure", lambda figure, pdf, png: kept.append(figure))
        getattr(script, name)(path, tmp_path / "a.pdf", tmp_path / "a.png")
        return kept[0], read_dataset(path)

    yield run
    plt.close("all")


def panels(figure):
    return [axes for axes in figure.axes if axes.get_xlabel()]


def assert_draws_probes(axes, data, name):
    probes = data[f"relative_displacement_{name}"]
    assert len(axes.get_lines()) == probes.sizes[f"bead_{name}"]
    for line, bead in zip(axes.get_lines(), probes[f"bead_{name}"].values, strict=True):
        np.testing.assert_array_equal(line.get_ydata(), probes.sel({f"bead_{name}": bead}))
        assert line.get_label() == f"$n = {bead}$"
    looks = {(line.get_color(), line.get_linestyle()) for line in axes.get_lines()}
    assert len(looks) == len(axes.get_lines())


def assert_draws_grid(axes, values):
    drawn = np.asarray(axes.collections[0].get_array()).reshape(values.shape)
    np.testing.assert_array_equal(drawn, values)
    assert axes.get_xlabel() == "$n$"


def test_figure_1_draws_probes_and_a_snapshot(draw):
    figure, data = draw("plot_fig01")
    steady, snapshot, transient = panels(figure)
    assert_draws_probes(steady, data, "steady")
    assert_draws_probes(transient, data, "transient")
    np.testing.assert_array_equal(snapshot.get_lines()[0].get_ydata(), data["velocity"].isel(t=0))
    assert snapshot.get_title() == "$t = 20$"


def test_figure_2_draws_both_space_time_diagrams_and_clips_the_gaps(draw):
    figure, data = draw("plot_fig02")
    displacement, velocity = (axes for axes in panels(figure) if axes.get_xlabel() == "$n$")
    assert_draws_grid(displacement, data["relative_displacement_grid"].isel(bead=slice(None, -1)))
    assert_draws_grid(velocity, data["velocity_grid"])
    image = displacement.collections[0]
    assert image.get_clim() == (-0.14, 0.14)
    red, green, blue, _ = image.cmap(-0.5)
    assert red > 0.7
    assert max(green, blue) < 0.2


def test_figure_3_draws_probes_and_a_space_time_diagram(draw):
    figure, data = draw("plot_fig03")
    transient, displacement = panels(figure)[:2]
    assert_draws_probes(transient, data, "transient")
    assert_draws_grid(displacement, data["relative_displacement_grid"].isel(bead=slice(None, -1)))


def test_saved_files_are_reproducible(path, tmp_path):
    from plot_fig03 import plot_fig03

    for name in ("one", "two"):
        plot_fig03(path, tmp_path / f"{name}.pdf", tmp_path / f"{name}.png")
    for ending in ("pdf", "png"):
        one, two = (tmp_path / f"{name}.{ending}" for name in ("one", "two"))
        assert one.read_bytes() == two.read_bytes()
    assert len(list(tmp_path.iterdir())) == 4


def lightness(colour):
    red, green, blue = plt.matplotlib.colors.to_rgb(colour)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_colour_maps_keep_their_order_in_grey():
    from granular_fronts.style import compression_map, velocity_map

    for colour_map in (compression_map(), velocity_map()):
        values = [lightness(colour_map(x)) for x in np.linspace(0.0, 1.0, 33)]
        assert np.all(np.diff(values) < 0.0)


@pytest.fixture(scope="module")
def atlas(tmp_path_factory):
    """A small campaign of fronts and the critical damping over its exponents."""
    folder = tmp_path_factory.mktemp("atlas")
    axes = {"alpha": [1.1, 1.3, 1.5], "gamma": [0.05, 0.2, 0.6]}
    asked = check_campaign({"kind": "front", "axes": axes}, "fronts_atlas")
    [chunk] = cut(asked, np.ones(asked.shape, dtype=bool), 100)
    solved = asked.kind.solve_chunk(chunk.points(), chunk.settings)
    file = folder / f"{chunk.name}.nc"
    write_dataset(
        chunk_dataset(chunk, solved, 1.0), file, scene_id=chunk.name, config=chunk._asdict()
    )
    merged = merge_chunks(asked, [file])
    write_dataset(merged, folder / "atlas.nc", scene_id="fronts_atlas", config=axes)
    trace = importlib.import_module("map_critical_damping").map_critical_damping
    few = {
        "alpha": {"start": 1.1, "stop": 1.6, "num": 3},
        "gamma": {"start": 0.1, "stop": 1, "num": 2},
    }
    trace(few | {"overshoot_cut": 1e-3}, folder / "curves.nc")
    return folder / "atlas.nc", folder / "curves.nc"


def test_fig16_shows_the_atlas_with_curves_and_beads(atlas, monkeypatch, tmp_path):
    script = importlib.import_module("plot_fig16")
    kept = []
    monkeypatch.setattr(script, "save_figure", lambda figure, pdf, png: kept.append(figure))
    beads = {"steel": {"gamma": 0.05}}
    script.plot_fig16(*atlas, beads, tmp_path / "a.pdf", tmp_path / "a.png")
    data, curves = read_dataset(atlas[0]), read_dataset(atlas[1])
    overshoot, width, regime = panels(kept[0])[:3]
    shown = width.collections[0].get_array().reshape(3, 3)
    np.testing.assert_array_equal(shown, data["width_10_90"].transpose("gamma", "alpha"))
    shown = regime.collections[0].get_array().reshape(3, 3)
    np.testing.assert_array_equal(shown[-1], 0)
    np.testing.assert_array_equal(shown[0], 2)
    assert not np.ma.getmaskarray(overshoot.collections[0].get_array()).any()
    for axes in (overshoot, width, regime):
        *lines, bead = axes.get_lines()
        for line, name in zip(lines, ("tail", "double_root", "long_wave"), strict=True):
            np.testing.assert_array_equal(line.get_ydata(), curves[f"critical_damping_{name}"])
        assert list(bead.get_xydata()[0]) == [1.5, 0.05]
    plt.close("all")
