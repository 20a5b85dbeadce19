"""Progress bars: rounded numbers, the scene's name, and one place that makes them."""

import io
import re
import sys

import pytest
from projects import ROOT

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output import progress


@pytest.fixture
def shown(monkeypatch, capsys):
    """What bars have written since the last call, beginning with their first moment."""
    monkeypatch.setattr(progress, "DELAY", 0.0)
    return lambda: capsys.readouterr().err


@pytest.mark.parametrize(
    ("end_time", "time", "words"),
    [
        (2600.0, 1975.8029451668194, "t = 1976 of 2600 "),
        (2600, 2600.0000001, "t = 2600 of 2600 "),
        (7.5, 1.0 / 3.0, "t = 0.33 of 7.50 "),
        (0.025, 0.01, "t = 0.0100 of 0.0250 "),
    ],
)
def test_times_are_rounded(shown, end_time, time, words):
    with progress.time_bar("solving", end_time) as show_time:
        show_time(time)
    assert shown().split("\r")[-1].count(words) == 1


def test_every_item_is_counted_once(shown):
    assert list(progress.counted(iter("abc"), "solving", "point")) == list("abc")
    last = shown().split("\r")[-1]
    assert "solving: 100%" in last
    assert "3/3" in last


SCENE = {
    "law": {"alpha": 1.5, "beta": 1.5, "gamma": 0.1},
    "beads": 10,
    "boundary": {"kind": "pressure", "left": 0.1, "right": 0.0},
    "start": {"kind": "rest"},
    "end_time": 12.5,
    "tolerance": {"relative": 1e-8, "absolute": 1e-10},
    "record": {"snapshots": [12.5]},
}


def test_bar_of_a_chain_names_its_scene(shown):
    simulate_chain(SCENE, "weak")
    bars = shown()
    assert "scene weak, solving: " in bars
    assert "scene weak, estimating the error: " in bars
    assert "t = 12.5 of 12.5 " in bars
    assert not re.search(r"\d\.\d{4}", bars)


def test_bars_are_made_in_one_place():
    files = [*ROOT.glob("src/**/*.py"), *ROOT.glob("workflow/**/*.py")]
    users = [file.name for file in files if re.search(r"import tqdm|from tqdm", file.read_text())]
    assert users == ["progress.py"]


@pytest.mark.parametrize("widgets", [True, False])
def test_bar_of_a_notebook_needs_widgets(monkeypatch, widgets):
    """Without them tqdm.auto would warn, and warnings are errors here."""
    monkeypatch.setitem(sys.modules, "ipykernel", io)
    monkeypatch.setattr(progress, "_has_widgets", lambda: widgets)
    module = progress._bar_class().__module__
    assert module == ("tqdm.asyncio" if widgets else "tqdm.std")
