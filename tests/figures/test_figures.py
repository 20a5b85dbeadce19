"""Files of a figure: reproducible, with a filled caption, and with the names of their data.

What each figure shows is checked in `test_figures_of_a_run`.
"""

import json
from types import SimpleNamespace

import matplotlib.pyplot as plt
import pytest
from chains import driven_scene
from fig03 import fig03

import drawing
from captions import read_texts
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output.datasets import (
    DatasetError,
    configuration_of,
    read_dataset,
    write_dataset,
)
from projects import ROOT

BEADS = 24
RECORD = {
    "snapshots": [20.0],
    "probes": {
        "steady": {"beads": [6, 9, 12], "start": 5.0, "stop": 30.0, "step": 0.5},
        "transient": {"beads": [1, 3], "start": 0.0, "stop": 10.0, "step": 0.5},
    },
    "grid": {"step": 2.0},
    "extremes": True,
    "arrival_level": 0.05,
}


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    scene = driven_scene(0.06, BEADS, 80.0, record=RECORD)
    path = tmp_path_factory.mktemp("data") / "scene.nc"
    write_dataset(simulate_chain(scene), path, scene_id="scene", config=scene)
    return path


ENDINGS = {"pdf": "pdf", "png": "png", "caption": "rst"}


def make_files(path, stem, caption, paper=None):
    """Run the step of figure 3, with a caption of the test's."""
    texts = stem.with_suffix(".texts")
    texts.write_text(f"Title\n=====\n\n.. Words.\n\n{caption}", encoding="utf-8")
    files = {name: stem.with_suffix(f".{ending}") for name, ending in ENDINGS.items()}
    shown = {"scene": [{}, paper]}
    drawing.write_figure(fig03, texts, SimpleNamespace(**files), shown, data=path)


def test_saved_files_are_reproducible_whatever_looks_a_user_likes(path, tmp_path):
    (tmp_path / "one").mkdir()
    (tmp_path / "two").mkdir()
    for name in ("one", "two"):
        plt.rcParams.update({"text.usetex": True, "figure.facecolor": "red"})
        make_files(path, tmp_path / name / "fig", "A caption.")
    for ending in ENDINGS.values():
        one, two = (tmp_path / name / f"fig.{ending}" for name in ("one", "two"))
        assert one.read_bytes() == two.read_bytes()
    assert len(list((tmp_path / "one").iterdir())) == 4


def test_files_name_the_data_and_the_caption_is_filled_with_what_was_computed(path, tmp_path):
    data = read_dataset(path)
    scene = configuration_of(data)
    make_files(path, tmp_path / "fig", "γ = {{ data.law.gamma }}.", scene)
    assert (tmp_path / "fig.rst").read_text(encoding="utf-8") == "γ = 0.06.\n"
    keyword = f"scene:{data.attrs['data_digest']}".encode()
    for ending in ("pdf", "png"):
        assert keyword in (tmp_path / f"fig.{ending}").read_bytes()


def test_caption_says_where_the_scene_is_not_the_papers_and_holds_no_markup_of_data(path, tmp_path):
    scene = configuration_of(read_dataset(path))
    paper = scene | {"law": scene["law"] | {"gamma": 0.21}}
    make_files(path, tmp_path / "fig", "A caption.", paper)
    caption = (tmp_path / "fig.rst").read_text(encoding="utf-8")
    assert "law.gamma is 0.06 instead of 0.21." in caption
    make_files(path, tmp_path / "fig", "{{ '\n\n.. raw:: html\n\n   *x_*' }}{{ ', a:b' }}")
    first, *others = (tmp_path / "fig.rst").read_text(encoding="utf-8").splitlines()
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
    scene = driven_scene(gamma, BEADS, end, record=RECORD | {"snapshots": [end]})
    motion = simulate_chain(scene).assign_attrs(config=json.dumps(scene))
    captions = " ".join(
        drawing._fill(read_texts(texts).caption, {"data": drawing._described(motion)})
        for texts in sorted((ROOT / "workflow/captions").glob("fig0[123]_*.rst"))
    )
    assert not [words for words in said.split(" | ") if words not in captions]
    assert not [words for words in unsaid.split(" | ") if words in captions]


def test_data_of_something_else_are_named(path, tmp_path):
    other = tmp_path / "other.nc"
    data = read_dataset(path).drop_vars("relative_displacement_transient")
    write_dataset(data, other, scene_id="other", config=configuration_of(data))
    with pytest.raises(DatasetError, match=r"other\.nc does not hold .* '\w+'\): let"):
        make_files(other, tmp_path / "fig", "A caption.")
    assert not (tmp_path / "fig.png").exists()
