"""Files of a figure: reproducible, with a filled caption, and with the names of their data.

What each figure shows is checked in `test_figures_of_a_run`.
"""

import json
from functools import cache
from types import SimpleNamespace

import matplotlib.pyplot as plt
import pytest
from chains import driven_scene
from matplotlib.figure import Figure

import drawing
from captions import read_texts
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output.datasets import (
    DatasetError,
    configuration_of,
    read_dataset,
    write_dataset,
)
from granular_fronts.output.style import new_figure
from projects import ROOT

RECORD = {
    "probes": {
        "steady": {"beads": [6, 9, 12], "start": 5.0, "stop": 30.0, "step": 0.5},
        "transient": {"beads": [1, 3], "start": 0.0, "stop": 10.0, "step": 0.5},
    },
    "grid": {"step": 2.0},
    "arrival_level": 0.05,
}


@cache
def motion(gamma, end):
    tolerance = {"relative": 1e-8, "absolute": 1e-10}
    record = RECORD | {"snapshots": [end]}
    scene = driven_scene(gamma, 24, end, tolerance=tolerance, record=record)
    return simulate_chain(scene).assign_attrs(config=json.dumps(scene))


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    path = tmp_path_factory.mktemp("data") / "scene.nc"
    data = motion(0.06, 80.0)
    write_dataset(data, path, scene_id="scene", config=configuration_of(data))
    return path


def probes(data):
    """A figure of one panel."""
    figure, panels = new_figure(1.0, [["panel"]])
    panels["panel"].plot(data["t_transient"], data["relative_displacement_transient"])
    return figure


def empty(data):
    """A figure whose caption is all that matters."""
    return Figure()


def make_files(path, stem, caption, paper=None, draw=empty):
    """Write the files of a figure with some caption, and return the caption that is filled."""
    texts = stem.with_suffix(".texts")
    texts.write_text(f"Title\n=====\n\n.. Words.\n\n{caption}", encoding="utf-8")
    endings = {"pdf": "pdf", "png": "png", "caption": "rst"}
    files = {name: stem.with_suffix(f".{ending}") for name, ending in endings.items()}
    shown = {"scene": [{}, paper]}
    drawing.write_figure(draw, texts, SimpleNamespace(**files), shown, data=path)
    return files["caption"].read_text(encoding="utf-8")


def test_files_name_their_data_and_are_reproducible_whatever_looks_a_user_likes(path, tmp_path):
    scene, digest = configuration_of(read_dataset(path)), read_dataset(path).attrs["data_digest"]
    for name in ("one", "two"):
        plt.rcParams.update({"text.usetex": name == "one", "figure.facecolor": "red"})
        caption = make_files(path, tmp_path / name, "γ = {{ data.law.gamma }}.", scene, probes)
        assert caption == "γ = 0.06.\n"
    for ending in ("pdf", "png"):
        written = (tmp_path / f"one.{ending}").read_bytes()
        assert written == (tmp_path / f"two.{ending}").read_bytes()
        assert f"scene:{digest}".encode() in written
    assert len(list(tmp_path.iterdir())) == 2 * 4


def test_caption_says_where_the_scene_is_not_the_papers_and_holds_no_markup_of_data(path, tmp_path):
    scene = configuration_of(read_dataset(path))
    paper = scene | {"law": scene["law"] | {"gamma": 0.21}}
    caption = make_files(path, tmp_path / "fig", "A caption.", paper)
    assert "law.gamma is 0.06 instead of 0.21." in caption
    caption = make_files(
        path, tmp_path / "fig", "{{ '\n\n.. raw:: html\n\n   *x_*' }}{{ ', a:b' }}"
    )
    first, *others = caption.splitlines()
    assert first == r".. raw\:\: html \*x\_\*, a\:b"
    assert "Scene scene is not one of the paper's." in " ".join(others)
    with pytest.raises(DatasetError, match="strength"):
        make_files(path, tmp_path / "fig", "γ = {{ data.law.strength }}.")


@pytest.mark.parametrize(
    ("gamma", "end", "said", "unsaid"),
    [
        (0.06, 32.0, "It oscillates | A front runs along", "reflect | fly off | other end"),
        (0.06, 80.0, "wave reflected there | fly off | the other end reflects", "both ends"),
        (0.65, 200.0, "both ends reflect | does not visibly | strong damping", "fly off | It osc"),
    ],
)
def test_captions_of_a_chain_say_what_it_does(gamma, end, said, unsaid):
    captions = " ".join(
        drawing._fill(read_texts(texts).caption, {"data": drawing._described(motion(gamma, end))})
        for texts in sorted((ROOT / "workflow/captions").glob("fig0[123]_*.rst"))
    )
    assert not [words for words in said.split(" | ") if words not in captions]
    assert not [words for words in unsaid.split(" | ") if words in captions]


def test_data_of_something_else_are_named(path, tmp_path):
    other = tmp_path / "other.nc"
    data = read_dataset(path).drop_vars("relative_displacement_transient")
    write_dataset(data, other, scene_id="other", config=configuration_of(data))
    with pytest.raises(DatasetError, match=r"other\.nc does not hold .* '\w+'\): let"):
        make_files(other, tmp_path / "fig", "A caption.", draw=probes)
    assert not (tmp_path / "fig.png").exists()
