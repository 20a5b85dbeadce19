"""A real notebook shows a bar of widgets while a chain is solved, and pictures after it.

It needs the packages that build the manual, which `make docs` installs.
"""

import os

import pytest

from projects import ROOT

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient", reason="make docs installs what runs notebooks")
pytest.importorskip("ipywidgets", reason="make docs installs the widgets")

SOLVE = """
from tqdm.auto import tqdm

import granular_fronts as gf
from granular_fronts.chain import simulate

simulate.tqdm = lambda **given: tqdm(**given | {{"delay": {delay}}})
motion = gf.simulate_chain(
    {{
        "law": {{"alpha": 1.5, "beta": 1.5, "gamma": 0.1}},
        "beads": 10,
        "boundary": {{"kind": "pressure", "left": 0.1, "right": 0.0}},
        "start": {{"kind": "rest"}},
        "end_time": 12.5,
        "tolerance": {{"relative": 1e-8, "absolute": 1e-10}},
        "record": {{"snapshots": [12.5], "grid": {{"step": 2.5}}}},
    }},
    "weak",
)
"""
WIDGET = "application/vnd.jupyter.widget-view+json"


@pytest.fixture(scope="module")
def notebook():
    """A notebook after it ran: bars at once, none since the work was short, and pictures."""
    cells = [SOLVE.format(delay=0.0), SOLVE.format(delay=60.0)]
    cells += ["gf.plot.chain(motion);", "gf.plot.space_time(motion);"]
    given = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    source = os.pathsep.join([str(ROOT / "src"), os.environ.get("PYTHONPATH", "")])
    nbclient.NotebookClient(given, kernel_name="python3").execute(
        env=os.environ | {"PYTHONPATH": source}
    )
    return given


def widgets(notebook):
    """State of every widget, by its identifier."""
    states = notebook.metadata["widgets"]["application/vnd.jupyter.widget-state+json"]["state"]
    return {name: widget["state"] for name, widget in states.items()}


@pytest.mark.slow
def test_each_solve_has_a_bar_that_ended_well(notebook):
    shown = [output.data[WIDGET]["model_id"] for output in notebook.cells[0].outputs]
    found = widgets(notebook)
    assert len(shown) == 2
    for box, activity in zip(shown, ("solving", "estimating the error"), strict=True):
        left, bar, _ = (found[each.removeprefix("IPY_MODEL_")] for each in found[box]["children"])
        assert left["value"].replace("\u2007", " ") == f"scene weak, {activity}: 100%"
        assert (bar["value"], bar["max"], bar["bar_style"]) == (12.5, 12.5, "success")


@pytest.mark.slow
def test_short_work_shows_no_bar(notebook):
    assert notebook.cells[1].outputs == []


@pytest.mark.slow
def test_pictures_are_shown(notebook):
    """The first of them starts the notebook's backend, which must serve those that follow."""
    for cell in notebook.cells[2:]:
        [figure] = cell.outputs
        assert "image/png" in figure.data
