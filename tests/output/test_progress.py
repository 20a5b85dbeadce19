"""Progress bars: rounded numbers, the scene's name, and one place that makes them."""

import io
import re
import sys
import types
from contextlib import redirect_stderr, suppress

import pytest

from granular_fronts.chain import simulate
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output import progress


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
    interrupted = suppress(KeyboardInterrupt)
    with terminal as shown, interrupted, progress.time_bar("solving", end_time) as show_time:
        show_time(time)
        raise KeyboardInterrupt
    assert shown.getvalue().split("\r")[-1].count(words) == 1


def test_every_item_is_counted_once(terminal):
    with terminal as shown:
        assert list(progress.counted(iter("abc"), "solving", "point")) == list("abc")
    last = shown.getvalue().split("\r")[-1]
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


def test_bar_of_a_chain_names_its_scene(terminal):
    with terminal as shown:
        simulate_chain(SCENE, "weak")
    bars = shown.getvalue()
    assert "scene weak, solving: " in bars
    assert "scene weak, estimating the error: " in bars
    assert "t = 12.5 of 12.5 " in bars
    assert not re.search(r"\d\.\d{4}", bars)


@pytest.mark.usefixtures("at_once")
def test_nothing_is_shown_where_messages_go_into_a_file(capsys):
    simulate_chain(SCENE, "weak")
    assert list(progress.counted("abc", "solving", "point")) == list("abc")
    assert capsys.readouterr() == ("", "")


def test_least_time_of_a_long_scene_is_said_before(monkeypatch, capsys):
    monkeypatch.setattr(simulate, "LONG", 0.0)
    simulate_chain(SCENE, "weak")
    assert capsys.readouterr() == ("", "Scene weak takes at least 0 s on one core.\n")


@pytest.mark.usefixtures("at_once")
def test_a_notebook_without_widgets_shows_the_bar_of_the_terminal(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "ipykernel", types.ModuleType("ipykernel"))
    monkeypatch.setattr(progress, "_has_widgets", lambda: False)
    assert list(progress.counted("abc", "solving", "point")) == list("abc")
    assert "solving: 100%" in capsys.readouterr().err


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


def follow(times, end_time):
    """Show some times of a motion."""
    with progress.time_bar("solving", end_time) as show_time:
        for time in times:
            show_time(time)
