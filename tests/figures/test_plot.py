"""Pictures in one line: each curve, mark and colour is a number of the dataset, for any law."""

import base64
import doctest
import io
import re

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray as xr
from chains import driven_scene
from pictures import assert_curve, assert_labels, assert_plane, curves, image, legend
from PIL import Image

import granular_fronts as gf
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.errors import InputError
from granular_fronts.output.movies import MARK_HEIGHT, moving_chain
from granular_fronts.output.style import ALARM_COLOUR, TEXT_WIDTH

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


# Fronts and sweeps.


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


def test_a_sweep_shows_the_overshoot_of_every_front_that_has_one():
    sweep = gf.sweep_fronts(alpha=1.5, gammas=[0.1, 0.2, 2.0])
    axes = gf.plot.sweep(sweep)
    [line] = curves(axes)
    assert sweep["overshoot"][2] < 1e-12 < sweep["overshoot"][1]
    assert_curve(line, sweep["gamma"], [*sweep["overshoot"].values[:2], np.nan])
    assert_labels(axes, r"$\gamma$", r"overshoot $\max u/\delta - 1$", "linear log")
    [text] = gf.plot.sweep(sweep.isel(gamma=[2])).texts
    assert text.get_text() == "no overshoot"


def test_a_sweep_of_chains_is_named_by_what_it_measures():
    """The first maximum at a bead is no overshoot of a front."""
    named = ("gamma", [0.3, 0.1], {"long_name": "first maximum"})
    axes = gf.plot.sweep(xr.Dataset({"overshoot": named}, {"gamma": [0.1, 0.2]}))
    assert_labels(axes, r"$\gamma$", "first maximum", "linear log")


def test_label_of_a_sweep_of_chains_fits_beside_it():
    meaning = KINDS["chain"].scalars["overshoot"]
    named = ("gamma", [0.3, 0.1], {"long_name": meaning})
    axes = gf.plot.sweep(xr.Dataset({"overshoot": named}, {"gamma": [0.1, 0.2]}))
    axes.figure.canvas.draw()
    assert axes.get_ylabel().split() == meaning.split()
    label = axes.yaxis.label.get_window_extent()
    assert axes.figure.bbox.y0 <= label.y0 < label.y1 <= axes.figure.bbox.y1
    assert axes.figure.bbox.x0 <= label.x0


def test_a_sweep_of_any_law_goes_through_a_factor():
    sweep = gf.sweep_fronts(law=TODA, states=(-2.0, 0.0), factors=[0.8, 1.0])
    axes = gf.plot.sweep(sweep)
    assert_curve(curves(axes)[0], sweep["factor"], sweep["overshoot"])
    assert_labels(axes, "factor of $W$", "overshoot of the strain", "linear log")


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
    """Neither beside snapshots, nor in a moving picture."""
    motion = motions["pressure"].isel(t=[0], t_grid=[0, 1]).copy(deep=True)
    error = motion["relative_displacement_grid"].attrs["error_estimate"]
    motion["relative_displacement"].attrs["error_estimate"] = error
    for extension, expected in ((0.5 * error, []), (2.0 * error, [4])):
        for name in ("relative_displacement", "relative_displacement_grid"):
            motion[name][:, 3] = -extension
        _, show = moving_chain(motion)
        moving = show(1)[-1]
        snapshot, *_ = marks(gf.plot.chain(motion)[0])
        assert snapshot.get_xdata().tolist() == moving.get_xdata().tolist() == expected


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


# Moving pictures.


@pytest.mark.parametrize("name", ["pressure", "toda"])
def test_each_frame_shows_its_time(motions, name):
    motion = motions[name]
    figure, show = moving_chain(motion)
    strip, upper, lower = figure.axes
    [circles] = strip.collections
    u = contacts(motion, motion["relative_displacement_grid"])
    for row in (0, 7, 15):
        show(row)
        assert_curve(curves(upper)[0], u["bead"], u[row])
        assert_curve(curves(lower)[0], motion["bead"], motion["velocity_grid"][row])
        assert upper.get_title("left") == f"time $t = {4 * row}$"
        np.testing.assert_array_equal(circles.get_array(), u[row, : circles.get_array().size])
        assert len(marks(upper)) == OPENING[name]
        for line in marks(upper):
            np.testing.assert_array_equal(line.get_xdata(), u["bead"][opened(u)[row]])
            assert np.all(line.get_ydata() == MARK_HEIGHT)
    assert_labels(upper, "", "compression $u_n$")
    assert_labels(lower, "bead $n$", r"velocity $\dot x_n$")


@pytest.mark.parametrize("name", SCENES)
def test_circles_are_where_the_beads_are(name):
    """Up to one scale neighbours come closer by u, and each bead moves by its ∫ẋ dt."""
    scene = SCENES[name] | {"record": RECORD | {"grid": {"step": 0.125}}}
    motion = gf.simulate_chain(scene, name)
    figure, show = moving_chain(motion)
    [circles] = figure.axes[0].collections
    u = contacts(motion, motion["relative_displacement_grid"]).values
    places = []
    for row in range(motion.sizes["t_grid"]):
        show(row)
        places.append(np.asarray(circles.get_offsets())[:, 0])
    closer = 1.0 - np.diff(places, axis=1)
    shown = u[:, : closer.shape[1]]
    scale = np.sum(closer * shown) / np.sum(shown**2)
    np.testing.assert_allclose(closer, scale * shown, atol=1e-9 * scale)
    travelled = np.subtract(places[-1], places[0]) / scale
    way = motion["velocity_grid"].integrate("t_grid").values[: travelled.size]
    np.testing.assert_allclose(travelled, way, atol=0.01 * np.abs(u).max())


def test_a_moving_picture_has_the_frames_asked_for(motions, tmp_path):
    movie = gf.plot.animate(motions["pressure"], frames=4)
    assert movie.rows == [0, 5, 10, 15]
    assert gf.plot.animate(motions["pressure"]).rows == list(range(16))
    for ending in ("GIF", "png", "webp"):
        movie.write(tmp_path / f"front.{ending}")
        with Image.open(tmp_path / f"front.{ending}") as written:
            assert written.n_frames == 4
            assert written.size[0] == int(120 * TEXT_WIDTH)
            assert written.info["loop"] == 0
    for refused in ("front.mp4", "nowhere/front.gif"):
        with pytest.raises(InputError, match=re.escape(refused[-4:])):
            movie.write(tmp_path / refused)


def test_what_changes_in_a_moving_picture_is_drawn_as_in_a_whole_one(motions):
    movie = gf.plot.animate(motions["ring"], frames=3)
    for row, frame in zip(movie.rows, list(movie.frames()), strict=True):
        movie.show(row)
        canvas = matplotlib.backends.backend_agg.FigureCanvasAgg(movie.figure)
        canvas.draw()
        whole = np.asarray(canvas.buffer_rgba())[..., :3].astype(int)
        # Lines that end on an axis lie above it here and below it there.
        differing = np.any(np.abs(whole - np.asarray(frame)) > 40, axis=-1)
        assert differing.mean() < 2e-3
    first, last = list(movie.frames())[:: len(movie.rows) - 1]
    assert np.any(np.asarray(first) != np.asarray(last))


def test_few_colours_keep_open_contacts_red(motions, tmp_path):
    movie = gf.plot.animate(motions["pressure"])
    movie.write(tmp_path / "front.gif")
    u = contacts(motions["pressure"], motions["pressure"]["relative_displacement_grid"])
    openings = opened(u).sum("bead").values
    red = np.array(matplotlib.colors.to_rgb(ALARM_COLOUR)) * 255
    reds = []
    with Image.open(tmp_path / "front.gif") as written:
        for frame in range(written.n_frames):
            written.seek(frame)
            pixels = np.asarray(written.convert("RGB"), dtype=float)
            reds.append(int(np.sum(np.abs(pixels - red).max(axis=-1) < 20)))
    assert openings[0] == 0 < openings.max()
    assert reds[openings.argmax()] > reds[0]


# Notebooks.


def test_a_notebook_shows_figures_and_moving_pictures_and_keeps_its_looks(motions, fronts):
    """It shows figures that pyplot keeps; a moving picture is the value of its cell."""
    before = dict(matplotlib.rcParams)
    axes = [gf.plot.front(fronts["powers"]), gf.plot.chain(motions["pressure"])[0]]
    axes.append(gf.plot.space_time(motions["pressure"])[0])
    page = gf.plot.animate(motions["pressure"], frames=2)._repr_html_()
    assert [plt.figure(number) for number in plt.get_fignums()] == [each.figure for each in axes]
    assert dict(matplotlib.rcParams) == before
    source, alternative = re.fullmatch(
        r'<img src="data:image/gif;base64,(.+)" alt="(.+)">', page
    ).groups()
    with Image.open(io.BytesIO(base64.b64decode(source))) as shown:
        assert shown.n_frames == 2
    assert "from t = 0 to t = 60." in alternative


# What cannot be drawn.

GRID_OF_CHAINS = xr.Dataset({"overshoot": (("alpha", "gamma"), [[0.1, 0.2]])})


@pytest.mark.parametrize(
    ("draw", "given", "words"),
    [
        (gf.plot.front, 3, "front is 3"),
        (gf.plot.front, xr.Dataset(), r"relative_displacement on \(xi\)"),
        (gf.plot.sweep, None, "sweep is None"),
        (gf.plot.sweep, xr.Dataset(), r"overshoot on \(gamma\): "),
        (gf.plot.sweep, GRID_OF_CHAINS, r"overshoot on \(gamma\), but on \(alpha, gamma\): "),
        (gf.plot.chain, xr.Dataset(), r"on \(t, bead\): .* snapshots: \[10\]"),
        (gf.plot.space_time, xr.Dataset(), r"relative_displacement_grid .* grid: \{step: 1\}"),
        (gf.plot.animate, xr.Dataset(), r"relative_displacement_grid .* grid: \{step: 1\}"),
    ],
)
def test_what_cannot_be_drawn_is_refused_by_its_name(draw, given, words):
    with pytest.raises(InputError, match=words):
        draw(given)


def test_what_has_nothing_to_show_says_so(motions, fronts):
    unsolved = fronts["powers"].assign_attrs(converged=0, reason="it is too steep")
    with pytest.raises(InputError, match="it is too steep"):
        gf.plot.front(unsolved)
    with pytest.raises(InputError, match="axes is 'x'"):
        gf.plot.front(fronts["powers"], axes="x")
    with pytest.raises(InputError, match="frames is 0"):
        gf.plot.animate(motions["pressure"], frames=0)


def test_examples_run():
    found = doctest.testmod(gf.plot, extraglobs={"gf": gf})
    assert found.failed == 0 < found.attempted
