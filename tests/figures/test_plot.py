"""Pictures in one line: each curve, mark and colour is a number of the dataset, for any law."""

import os
import subprocess
import sys

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest
from chains import driven_scene, given
from pictures import curves, plane

import granular_fronts as gf
from granular_fronts.errors import InputError

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
RECORD = {"snapshots": [12.0, 48.0, 60.0], "grid": {"step": 4.0}}
LOOSE = {"relative": 1e-8, "absolute": 1e-10}
PRESSED = driven_scene(0.06, 24, tolerance=LOOSE, record=RECORD)
# Toda's contacts pull, so that an extended one is not open.
PULLING = PRESSED | {
    "law": TODA,
    "boundary": {"kind": "ring"},
    "start": given(0.2 * np.sin(0.5 * np.arange(24)), np.zeros(24)),
}


@pytest.fixture(scope="module")
def pressed():
    return gf.simulate_chain(PRESSED)


@pytest.fixture(scope="module")
def pulling():
    return gf.simulate_chain(PULLING)


@pytest.fixture(scope="module")
def front():
    return gf.solve_front(alpha=1.5, gamma=0.1)


@pytest.fixture(autouse=True)
def _closed():
    yield
    plt.close("all")


def contacts(motion, u):
    """Relative displacements of contacts alone, of all beads but the last unless on a ring."""
    return u.isel(bead=slice(None, motion.attrs["contacts"]))


def marks(axes):
    """Lines that are no data: the marks of open contacts."""
    return [line for line in axes.get_lines() if line.get_transform() is not axes.transData]


def assert_curve(line, x, y):
    np.testing.assert_array_equal(line.get_xdata(), x)
    np.testing.assert_array_equal(line.get_ydata(), y)


def assert_plane(axes, values):
    """A panel colours these numbers over its abscissa and ordinate."""
    np.testing.assert_array_equal(np.ma.filled(plane(axes).get_array(), np.nan), values)
    corners = plane(axes).get_coordinates()
    for name, edges in zip(values.dims, (corners[:, 0, 1], corners[0, :, 0]), strict=True):
        assert np.all((edges[:-1] < values[name].values) & (values[name].values < edges[1:]))


def test_a_front_is_drawn_where_it_differs_from_its_states(front):
    axes = gf.plot.front(front)
    [line] = curves(axes)
    u = front["relative_displacement"]
    assert_curve(line, front["xi"], u)
    first, last = axes.get_xlim()
    hidden = u.where((front["xi"] < first) | (front["xi"] > last), drop=True)
    assert np.all((np.abs(hidden) <= 1e-3) | (np.abs(hidden - 1.0) <= 1e-3))
    assert np.abs(gf.evaluate_front(front, [first])[0] - 1.0) > 1e-3
    assert np.abs(gf.evaluate_front(front, [last])[0]) > 1e-3


def test_a_front_joins_another_and_leaves_its_limits(front):
    axes = gf.plot.front(gf.solve_front(law=TODA, states=(-2.0, 0.0)))
    limits = axes.get_xlim()
    assert gf.plot.front(front, axes) is axes
    assert len({line.get_color() for line in curves(axes)}) == len(curves(axes)) == 2
    assert axes.get_xlim() == limits


@pytest.mark.parametrize("name", ["pressed", "pulling"])
def test_a_chain_is_drawn_at_each_snapshot_with_its_open_contacts(request, name):
    motion = request.getfixturevalue(name)
    upper, lower = gf.plot.chain(motion)
    u = contacts(motion, motion["relative_displacement"])
    assert u.sizes["bead"] == (23 if name == "pressed" else 24)
    for row in range(3):
        assert_curve(curves(upper)[row], u["bead"], u[row])
        assert_curve(curves(lower)[row], motion["bead"], motion["velocity"][row])
    assert len({line.get_color() for line in curves(upper)}) == len(curves(upper)) == 3
    drawn = marks(upper)
    assert bool(drawn) == (name == "pressed")
    assert float(u.min()) < 0.0
    for row, line in enumerate(drawn):
        opened = u[row] < -u.attrs["error_estimate"]
        np.testing.assert_array_equal(line.get_xdata(), u["bead"][opened])
        assert line.get_color() == curves(upper)[row].get_color()
    heights = [line.get_ydata()[0] for line in drawn if np.size(line.get_ydata())]
    assert len(set(heights)) == len(heights) == (2 if name == "pressed" else 0)


def test_a_contact_extended_by_less_than_its_error_is_not_open(pressed):
    motion = pressed.isel(t=[0]).copy(deep=True)
    error = motion["relative_displacement"].attrs["error_estimate"]
    for extension, expected in ((0.5 * error, []), (2.0 * error, [4])):
        motion["relative_displacement"][:, 3] = -extension
        [snapshot] = marks(gf.plot.chain(motion)[0])
        assert snapshot.get_xdata().tolist() == expected


def test_gaps_do_not_hide_the_compressions(pressed):
    """The panel goes as far below zero as above; where contacts hold, all is shown."""
    wide = pressed.copy(deep=True)
    wide["relative_displacement"][-1, 3] = -50.0
    largest = float(wide["relative_displacement"].max())
    assert gf.plot.chain(wide)[0].get_ylim() == pytest.approx((-1.1 * largest, 1.1 * largest))
    # Narrower gaps leave no space unused.
    narrow = wide.clip(-0.01, largest).assign_attrs(wide.attrs)
    assert gf.plot.chain(narrow)[0].get_ylim()[0] == pytest.approx(-0.01 - 0.05 * (largest + 0.01))
    held = wide.assign_attrs(contacts_open=0)
    assert gf.plot.chain(held)[0].get_ylim()[0] < -50.0


def test_space_and_time_are_coloured_up_to_the_largest_compression(pressed, pulling):
    left, right = gf.plot.space_time(pressed)
    u = contacts(pressed, pressed["relative_displacement_grid"])
    assert_plane(left, u)
    assert_plane(right, pressed["velocity_grid"])
    largest = float(u.max())
    assert plane(left).get_clim() == (-largest, largest)
    assert plane(left).colorbar.extend == "min"
    held, moving = gf.plot.space_time(pulling)
    assert plane(held).colorbar.extend == "neither"
    velocity = pulling["velocity_grid"]
    assert plane(moving).get_clim() == (velocity.min(), velocity.max())
    assert velocity.min() < 0.0


@pytest.mark.parametrize("draw", [gf.plot.chain, gf.plot.space_time])
def test_a_chain_is_drawn_into_given_panels(pressed, draw):
    given = plt.figure().subplots(1, 2)
    assert draw(pressed, ax=given) == tuple(given)
    assert draw(pressed)[0].figure is not given[0].figure
    with pytest.raises(InputError, match="give two axes"):
        draw(pressed, ax=given[0])


def test_a_notebook_shows_figures_and_keeps_its_looks(pressed, front):
    """It shows figures that pyplot keeps."""
    plt.rcdefaults()
    before = dict(matplotlib.rcParams)
    axes = [gf.plot.front(front), gf.plot.chain(pressed)[0], gf.plot.space_time(pressed)[0]]
    assert [plt.figure(number) for number in plt.get_fignums()] == [each.figure for each in axes]
    assert dict(matplotlib.rcParams) == before


def test_backend_that_is_not_installed_is_named():
    command = [sys.executable, "-c", "import granular_fronts as gf; gf.plot"]
    env = os.environ | {"MPLBACKEND": "inline_of_a_notebook"}
    run = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    assert run.stderr.endswith("Unset MPLBACKEND, or set it to agg.\n")
