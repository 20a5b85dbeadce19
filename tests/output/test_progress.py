"""Progress bars: rounded numbers, the scene's name, and one place that makes them."""

import importlib.util
import io
import re
import sys
import types
from contextlib import redirect_stderr

import pytest
from chains import driven_scene

from granular_fronts.campaign import chain_points
from granular_fronts.chain import simulate
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output import progress

SCENE = driven_scene(0.1, 10, 12.5)


@pytest.fixture
def at_once(monkeypatch):
    """Bars appear with their first moment."""
    monkeypatch.setattr(progress, "DELAY", 0.0)


class Terminal(io.StringIO):
    """What a terminal shows."""

    def isatty(self):
        return True


@pytest.fixture
def terminal(at_once):
    """A terminal on which bars appear with their first moment; a context for messages to it."""
    return redirect_stderr(Terminal())


def follow(times, end_time):
    """Show some times of a motion; None among them stops it."""
    with progress.time_bar("solving", end_time) as show_time:
        for time in times:
            show_time(time)


@pytest.mark.parametrize(
    ("end_time", "time", "words"),
    [
        (2600.0, 1975.8029451668194, "t = 1976 of 2600 "),
        (2600, 2600.0000001, "t = 2600 of 2600 "),
        (7.5, 1.0 / 3.0, "t = 0.33 of 7.50 "),
        (0.025, 0.01, "t = 0.0100 of 0.0250 "),
    ],
)
def test_times_are_rounded(terminal, end_time, time, words):
    with terminal as shown, pytest.raises(TypeError):
        follow([time, None], end_time)
    assert shown.getvalue().split("\r")[-1].count(words) == 1


def test_bar_of_a_chain_names_its_scene(terminal):
    with terminal as shown:
        simulate_chain(SCENE, "weak")
    bars = shown.getvalue()
    assert "scene weak, solving: " in bars
    assert "scene weak, estimating the error: " in bars
    assert "t = 12.5 of 12.5 " in bars
    assert not re.search(r"\d\.\d{4}", bars)


def count_three():
    """Pass three items through a bar."""
    assert list(progress.counted(iter("abc"), "solving", "point")) == list("abc")


def test_items_are_counted_on_a_terminal_and_nothing_is_shown_in_a_file(terminal, capsys):
    with terminal as shown:
        count_three()
    assert re.search("solving: 100%.* 3/3 ", shown.getvalue().split("\r")[-1])
    count_three()
    assert capsys.readouterr() == ("", "")


def test_a_notebook_without_widgets_shows_the_bar_of_the_terminal(at_once, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "ipykernel", types.ModuleType("ipykernel"))
    monkeypatch.setattr(progress, "_has_widgets", lambda: False)
    count_three()
    assert "solving: 100%" in capsys.readouterr().err


@pytest.mark.parametrize("found", [None, "a place"])
def test_widgets_are_looked_for(monkeypatch, found):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: found)
    assert progress._has_widgets() == (found is not None)


def test_least_time_of_a_long_scene_is_said_before(monkeypatch, capsys):
    monkeypatch.setattr(simulate, "LONG", 0.0)
    simulate_chain(SCENE, "weak")
    assert capsys.readouterr() == ("", "Scene weak takes at least 0 s on one core.\n")
    point = {"alpha": 1.5, "beta": 1.5, "gamma": 0.1, "delta": 1.0, "delta_right": 0.0}
    chain_points._solve_point(point | {"beads": 20, "crossings": 0.1}, None, 1e-6)
    assert capsys.readouterr().err == "A point of the campaign takes at least 0 s on one core.\n"


def test_a_bar_that_did_not_fail_has_reached_its_end(monkeypatch, terminal):
    """A notebook shows a bar in red that ended before, be it by the rounding of a difference."""
    bars, make = [], progress._bar
    monkeypatch.setattr(progress, "_bar", lambda **given: bars.append(make(**given)) or bars[-1])
    end_time, time = 7.7, 2.912101447893106
    assert time + (end_time - time) < end_time
    with terminal:
        follow([time, end_time], end_time)
        with pytest.raises(TypeError):
            follow([time, None], end_time)
    assert [bar.n for bar in bars] == [end_time, time]
