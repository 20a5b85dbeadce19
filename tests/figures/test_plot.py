"""Pictures in one line: each curve, mark and colour is a number of the dataset, for any law."""

import doctest
import os
import subprocess
import sys

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray as xr
from chains import driven_scene
from pictures import assert_curve, assert_labels, assert_plane, curves, image, legend

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.output.style import ALARM_COLOUR

TODA = {"elastic": {"kind": "toda"}, "viscous": {"kind": "linear", "gamma": 0.3}}
RECORD = {"snapshots": [12.0, 24.0, 60.0], "grid": {"step": 4.0}}
TIMES = {"tolerance": {"relative": 1e-8, "absolute": 1e-10}, "record": RECORD, "end_time": 60.0}
RING = {
    "boundary": {"kind": "ring"},
    "start": {
        "kind": "given",
        "relative_displacement": [0.2 * np.sin(0.5 * n) for n in range(24)],
        "velocity": [0.0] * 24,
    },
}
SCENES = {
    "pressure": driven_scene(0.06, 24, **TIMES),
    "piston": driven_scene(0.3, 24, **TIMES) | {"boundary": {"kind": "piston", "velocity": 0.05}},
    "ring": driven_scene(0.2, 24, **TIMES) | RING,
    "toda": driven_scene(0.06, 24, **TIMES) | RING | {"law": TODA},
}
OPENING = {"pressure": 1, "piston": 1, "ring": 1, "toda": 0}


@pytest.fixture(scope="module")
def motions():
    return {name: gf.simulate_chain(scene, name) for name, scene in SCENES.items()}


@pytest.fixture(scope="module")
def fronts():
    return {
        "powers": gf.solve_front(alpha=1.5, gamma=0.1),
        "toda": gf.solve_front(law=TODA, states=(-2.0, 0.0)),
    }


@pytest.fixture(autouse=True)
def _closed():
    yield
    plt.close("all")


def contacts(motion, u):
    """Relative displacements of contacts alone, of all beads but the last unless on a ring."""
    return u.isel(bead=slice(None, motion.attrs["contacts"]))


def opened(u):
    """Whether contacts are extended by more than the error of their relative displacements."""
    return u < -u.attrs["error_estimate"]


def marks(axes):
    """Lines that are no data: the marks of open contacts."""
    return [line for line in axes.get_lines() if line.get_transform() is not axes.transData]


# Fronts.


def test_a_front_is_drawn_where_it_differs_from_its_states(fronts):
    front = fronts["powers"]
    axes = gf.plot.front(front)
    [line] = curves(axes)
    assert_curve(line, front["xi"], front["relative_displacement"])
    assert_labels(axes, r"$\xi = n - ct$", r"compression $u/\delta$")
    first, last = axes.get_xlim()
    u = front["relative_displacement"]
    hidden = u.where((front["xi"] < first) | (front["xi"] > last), drop=True)
    assert np.all((np.abs(hidden) <= 1e-3) | (np.abs(hidden - 1.0) <= 1e-3))
    assert np.abs(gf.evaluate_front(front, [first])[0] - 1.0) > 1e-3
    assert np.abs(gf.evaluate_front(front, [last])[0]) > 1e-3


def test_a_front_of_any_law_joins_another_in_the_units_of_its_law(fronts):
    axes = gf.plot.front(fronts["toda"])
    limits = axes.get_xlim()
    assert_labels(axes, r"$\xi = n - ct$", "compression $u$")
    assert gf.plot.front(fronts["powers"], axes) is axes
    assert len(curves(axes)) == 2
    assert len({line.get_color() for line in curves(axes)}) == 2
    assert axes.get_xlim() == limits


# Chains.


@pytest.mark.parametrize("name", SCENES)
def test_a_chain_is_drawn_at_each_snapshot_with_its_open_contacts(motions, name):
    motion = motions[name]
    assert motion.attrs["contacts"] == (24 if name in ("ring", "toda") else 23)
    assert motion.attrs["contacts_open"] == OPENING[name]
    upper, lower = gf.plot.chain(motion)
    u = contacts(motion, motion["relative_displacement"])
    for row in range(3):
        assert_curve(curves(upper)[row], u["bead"], u[row])
        assert_curve(curves(lower)[row], motion["bead"], motion["velocity"][row])
    assert len(curves(upper)) == len({line.get_color() for line in curves(upper)}) == 3
    assert_labels(upper, "bead $n$", "compression $u_n$")
    assert_labels(lower, "bead $n$", r"velocity $\dot x_n$")
    assert legend(lower)[:3] == ["$t = 12$", "$t = 24$", "$t = 60$"]
    drawn = marks(upper)
    if not OPENING[name]:
        # Toda's contacts pull, so that an extended one is not open.
        assert drawn == []
        assert float(u.min()) < 0.0
        return
    for row, line in enumerate(drawn):
        np.testing.assert_array_equal(line.get_xdata(), u["bead"][opened(u)[row]])
        assert line.get_color() == curves(upper)[row].get_color()
    heights = [line.get_ydata()[0] for line in drawn if np.size(line.get_ydata())]
    assert len(set(heights)) == len(heights)
    assert opened(u).any()
    assert legend(upper)[-1] == "open contacts"


def test_a_contact_extended_by_less_than_its_error_is_not_open(motions):
    motion = motions["pressure"].isel(t=[0]).copy(deep=True)
    error = motion["relative_displacement"].attrs["error_estimate"]
    for extension, expected in ((0.5 * error, []), (2.0 * error, [4])):
        motion["relative_displacement"][:, 3] = -extension
        [snapshot] = marks(gf.plot.chain(motion)[0])
        assert snapshot.get_xdata().tolist() == expected


def test_gaps_do_not_hide_the_compressions(motions):
    """The panel goes as far below zero as above; where contacts hold, all is shown."""
    wide = motions["pressure"].copy(deep=True)
    wide["relative_displacement"][-1, 3] = -50.0
    largest = float(wide["relative_displacement"].max())
    assert gf.plot.chain(wide)[0].get_ylim() == pytest.approx((-1.1 * largest, 1.1 * largest))
    # Narrower gaps leave no space unused.
    narrow = wide.clip(-0.01, largest).assign_attrs(wide.attrs)
    assert gf.plot.chain(narrow)[0].get_ylim()[0] == pytest.approx(-0.01 - 0.05 * (largest + 0.01))
    held = wide.assign_attrs(contacts_open=0)
    assert gf.plot.chain(held)[0].get_ylim()[0] < -50.0


def test_space_and_time_are_coloured_with_gaps_in_red(motions):
    motion = motions["pressure"]
    left, right = gf.plot.space_time(motion)
    u = contacts(motion, motion["relative_displacement_grid"])
    assert_plane(left, u, "compression $u_n$")
    assert_plane(right, motion["velocity_grid"], r"velocity $\dot x_n$")
    largest = float(u.max())
    assert image(left).get_clim() == (-largest, largest)
    assert image(left).colorbar.extend == "min"
    red = matplotlib.colors.to_rgba(ALARM_COLOUR)
    assert image(left).cmap(image(left).norm(-1.01 * largest)) == red
    held, _ = gf.plot.space_time(motions["toda"])
    assert image(held).colorbar.extend == "neither"


@pytest.mark.parametrize("draw", [gf.plot.chain, gf.plot.space_time])
def test_a_chain_is_drawn_into_given_panels(motions, draw):
    given = plt.figure().subplots(1, 2)
    assert draw(motions["pressure"], ax=given) == tuple(given)
    assert draw(motions["pressure"])[0].figure is not given[0].figure
    with pytest.raises(InputError, match="give two axes"):
        draw(motions["pressure"], ax=given[0])


# Notebooks.


def test_a_notebook_shows_figures_and_keeps_its_looks(motions, fronts):
    """It shows figures that pyplot keeps."""
    before = dict(matplotlib.rcParams)
    axes = [gf.plot.front(fronts["powers"]), gf.plot.chain(motions["pressure"])[0]]
    axes.append(gf.plot.space_time(motions["pressure"])[0])
    assert [plt.figure(number) for number in plt.get_fignums()] == [each.figure for each in axes]
    assert dict(matplotlib.rcParams) == before


# What cannot be drawn.


@pytest.mark.parametrize(
    ("draw", "given", "words"),
    [
        (gf.plot.front, 3, "front is 3"),
        (gf.plot.front, xr.Dataset(), r"relative_displacement on \(xi\)"),
        (gf.plot.chain, xr.Dataset(), r"on \(t, bead\): .* snapshots: \[10\]"),
        (gf.plot.space_time, xr.Dataset(), r"relative_displacement_grid .* grid: \{step: 1\}"),
    ],
)
def test_what_cannot_be_drawn_is_refused_by_its_name(draw, given, words):
    with pytest.raises(InputError, match=words):
        draw(given)


def test_what_has_nothing_to_show_says_so(fronts):
    unsolved = fronts["powers"].assign_attrs(converged=0, reason="it is too steep")
    with pytest.raises(InputError, match="it is too steep"):
        gf.plot.front(unsolved)
    with pytest.raises(InputError, match="ax is 'x'"):
        gf.plot.front(fronts["powers"], ax="x")


def test_examples_run():
    found = doctest.testmod(gf.plot, extraglobs={"gf": gf})
    assert found.failed == 0 < found.attempted


def test_backend_that_is_not_installed_is_named():
    command = [sys.executable, "-c", "import granular_fronts as gf; gf.plot"]
    env = os.environ | {"MPLBACKEND": "inline_of_a_notebook"}
    run = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    assert "'inline_of_a_notebook' is not a valid value" in run.stderr
    assert run.stderr.endswith("Unset MPLBACKEND, or set it to agg.\n")
