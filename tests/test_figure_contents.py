"""No panel of a figure stays empty, and each follows its data."""

import numpy as np
import pytest
import yaml
from figure_samples import SAMPLES
from pictures import draw, empty_panels, numbers, panels, sampled
from projects import ROOT

LISTED = yaml.safe_load((ROOT / "workflow" / "figures.yaml").read_text(encoding="utf-8"))


def changed(given, change):
    """The datasets of a figure with another number wherever one was measured."""

    def change_all(data):
        return data.assign(
            {name: change(each) for name, each in data.items() if each.dtype.kind == "f"}
        )

    return {
        name: list(map(change_all, data)) if isinstance(data, list) else change_all(data)
        for name, data in given.items()
    }


def test_every_figure_is_drawn_from_a_sample_here():
    assert SAMPLES.keys() == LISTED.keys()


@pytest.mark.parametrize("figure", SAMPLES)
def test_figure_is_given_what_the_workflow_names(figure):
    assert SAMPLES[figure]().keys() == LISTED[figure]["data"].keys()


@pytest.mark.parametrize("figure", SAMPLES)
def test_each_panel_shows_its_data(figure):
    given, drawn = sampled(figure)
    assert empty_panels(drawn) == []
    other = panels(draw(figure, changed(given, lambda values: 1.0 - 0.8 * values)))
    for name, axes in panels(drawn).items():
        before, after = (np.concatenate(list(numbers(each))) for each in (axes, other[name]))
        assert before.shape != after.shape or np.any(before != after), name


@pytest.mark.parametrize("figure", ["fig04", "fig10", "fig12"])
def test_panels_without_numbers_count_as_empty(figure):
    """The negative control of the test above."""
    drawn = draw(figure, changed(SAMPLES[figure](), lambda values: np.nan * values))
    assert empty_panels(drawn)
