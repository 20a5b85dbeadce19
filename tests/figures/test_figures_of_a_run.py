"""Every figure is drawn from the data of a run, and each curve is the variable it should be."""

import importlib
import re
from fnmatch import fnmatch
from functools import cache
from itertools import cycle
from string import ascii_lowercase

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_rgba
from pictures import curves, plane

from captions import read_texts
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.style import ALARM_COLOUR
from projects import ROOT, copy_project, lend_kernels, snakemake

U, V = "relative_displacement", "velocity"
RINGS = {"weak": "periodic/weak", "hertz": "periodic/hertz"}
FRONTS = {"underdamped": "fronts/underdamped", "overdamped": "fronts/overdamped"}
MODELS = ("logarithmic", "unlimited", "heteroclinic")

FIGURES = {
    "fig01": {"data": "chain/initiation_underdamped"},
    "fig02": {"data": "chain/initiation_underdamped"},
    "fig03": {"data": "chain/initiation_overdamped"},
    "fig04": {"data": "continuum/log_burgers_fronts"},
    "fig05": RINGS,
    "fig06": {"data": "periodic/weak"},
    "model_error": RINGS,
    "fig08": {"data": "continuum/front_profiles"},
    "exact_fronts": FRONTS,
    "fronts_compared": {"scenes": [*FRONTS.values()]},
    "continuum_errors": {"data": "fronts/survey"},
    "critical_damping": {"data": "fronts/critical_damping", "materials": "laws/materials"},
    "multipliers": {"data": "fronts/multipliers"},
    "jump_conditions": {"data": "laws/jump_conditions"},
    "damping_regimes": {"data": "laws/damping_regimes"},
    "numerical_damping": {"data": "laws/numerical_damping"},
}
"""What the function of each figure is given."""

SHOWN = {
    "fig01 steady": [f"{U}_steady over t_steady"],
    "fig01 transient": [f"{U}_transient over t_transient"],
    "fig01 snapshot": [f"{V} over bead"],
    "fig02 displacement": [f"{U}_grid"],
    "fig02 velocity": [f"{V}_grid"],
    "fig03 transient": [f"{U}_transient over t_transient"],
    "fig03 displacement": [f"{U}_grid"],
    "fig04 flux": [
        *["flux over force", "compression over force"] * 2,
        *["flux_limit over force", "force over force"],
    ],
    "fig04 front": ["front over xi", "front over xi", "front_limit over xi"],
    "fig05 relative_displacement": [f"{U} over bead"],
    "fig05 velocity": [f"{V} over bead"],
    "fig06 relative_displacement *": [f"{U}_logarithmic over site", f"{U} over bead"],
    "fig06 velocity *": [f"{V}_logarithmic over site", f"{V} over bead"],
    "fig08 well": ["potential over y"],
    "fig08 front *": ["rescaled_force over s"],
    "model_error": [f"{U}_sup_{model} over t_grid" for model in MODELS[:2]],
    "exact_fronts u *": [f"{U} over xi", f"{U}_shooting over xi_shooting"],
    "fronts_compared u *": [
        f"{U}_driven over xi_driven",
        *(f"{U}_{model} over xi" for model in MODELS),
        f"{U} over xi",
    ],
    "continuum_errors": [f"distance_{model} over gamma" for model in MODELS],
    "critical_damping plane*": [
        *(f"critical_damping_{name} over alpha" for name in ("tail", "double_root")),
        *(f"critical_damping_{name} over alpha" for name in ("long_wave", "overshoot")),
    ],
    "critical_damping peaks": [
        *(f"critical_damping_{name} over alpha" for name in ("tail", "double_root")),
        *(f"critical_damping_{name} over alpha" for name in ("long_wave", "overshoot")),
        *["second_peak_leads over alpha", "first_peak_stays_below over alpha"],
    ],
    "multipliers *damped": [
        *["essential_multiplier_imaginary over essential_multiplier_real"] * 2,
        "multiplier_imaginary over multiplier_real",
    ],
    "damping_regimes gamma": ["gamma over velocity_ratio"],
    "damping_regimes restitution": ["restitution over velocity_ratio"],
    "numerical_damping profile": [f"{U}_{run} over bead" for run in ("conservative", "damped")]
    + [f"{U}_method over bead"],
    "numerical_damping order": ["damping_distance over step", "conservative_distance over step"],
}
"""What the curves and planes of each panel show, in the order in which they are drawn, repeated."""


@cache
def finished_run():
    """The results folder of a run; where `make` has not left one, the small run of the tests."""
    if (ROOT / "results/checks.txt").exists():
        return ROOT / "results"
    project = ROOT / ".pytest_cache/small run"
    if not project.exists():
        project.mkdir(parents=True)
        copy = lend_kernels(copy_project(project))
        run = snakemake("--configfile", "config/smoke.yaml", folder=copy)
        assert run.returncode == 0, run.stderr
    return project / "copy/results/smoke"


@cache
def picture(figure):
    """The data of a figure in a list, and its panels by their names; drawn once for all tests."""

    def read(name):
        every.append(read_dataset(finished_run() / f"data/{name}.nc"))
        return every[-1]

    every = []
    given = {
        argument: [read(one) for one in name] if isinstance(name, list) else read(name)
        for argument, name in FIGURES[figure].items()
    }
    drawn = getattr(importlib.import_module(figure), figure)(**given)
    plt.close(drawn)
    panels = {axes.get_label(): axes for axes in drawn.axes if axes.get_label() != "<colorbar>"}
    return every, panels


def data_curves(axes):
    """Curves of three points or more, but for the unit circle."""
    lines = [line for line in curves(axes) if np.size(line.get_xdata()) > 2]
    return [line for line in lines if not np.allclose(np.hypot(*line.get_data()), 1.0)]


def holds(data, name, values):
    """Whether a variable of some dataset holds all of these numbers."""
    values = np.ma.filled(values, np.nan).astype(float).ravel()
    values = values[np.isfinite(values)]
    return values.size > 0 and any(
        np.isin(values, one[name].values).all() for one in data if name in one.variables
    )


@pytest.mark.parametrize("pattern", SHOWN)
def test_panels_show_the_variables_that_their_names_say(pattern):
    figure, _, name = pattern.partition(" ")
    data, panels = picture(figure)
    found = [axes for label, axes in panels.items() if fnmatch(label, name or "*")]
    assert found
    for axes in found:
        if " over " not in SHOWN[pattern][0]:
            assert holds(data, SHOWN[pattern][0], plane(axes).get_array())
            continue
        lines = data_curves(axes)
        assert lines
        for line, words in zip(lines, cycle(SHOWN[pattern])):
            ordinate, abscissa = words.split(" over ")
            assert holds(data, ordinate, line.get_ydata()), words
            assert holds(data, abscissa, line.get_xdata()), words
        drawn = {(line.get_linestyle(), np.ma.getdata(line.get_data()).tobytes()) for line in lines}
        assert len(drawn) == len(lines)
        assert len(lines) % len(SHOWN[pattern]) == 0


def test_a_curve_of_another_variable_would_be_noticed():
    data, panels = picture("continuum_errors")
    line = data_curves(next(iter(panels.values())))[0]
    assert holds(data, "distance_logarithmic", line.get_ydata())
    assert not holds(data, "distance_unlimited", line.get_ydata())
    assert not holds(data, "distance_logarithmic", 1.01 * line.get_ydata())


@pytest.mark.parametrize("figure", FIGURES)
def test_caption_names_no_letter_that_the_figure_lacks(figure):
    """Letters run along the rows, and a figure of one panel has none."""
    _, panels = picture(figure)
    letters = [f"({letter})" for letter in ascii_lowercase[: len(panels)]]
    letters = letters if len(letters) > 1 else [""]
    assert [axes.get_title("left") for axes in panels.values()] == letters
    every = (ROOT / "workflow/captions").glob(f"{figure}*.rst")
    [texts] = [file for file in every if re.match(rf"{figure}(_|$)", file.stem)]
    assert set(re.findall(r"\([a-p]\)", read_texts(texts).caption)) <= set(letters)


def test_rest_is_white_and_gaps_are_red_on_one_scale():
    meshes = [plane(picture(figure)[1]["displacement"]) for figure in ("fig02", "fig03")]
    for mesh in meshes:
        assert np.allclose(mesh.cmap(mesh.norm(0.0)), 1.0, atol=0.02)
        for gap in (-50.0, mesh.norm.vmin):
            assert mesh.cmap(mesh.norm(gap)) == to_rgba(ALARM_COLOUR)
    assert meshes[0].get_clim() == meshes[1].get_clim()


def test_gaps_wider_than_the_panel_of_figure_6_are_marked():
    [data], panels = picture("fig06")
    for row, time in enumerate(data["t"].values[1:]):
        axes = panels[f"relative_displacement {row}"]
        wide = data[U].sel(t=time) < axes.get_ylim()[0]
        marks = [line for line in axes.get_lines() if line.get_marker() == "v"]
        marked = [bead for line in marks for bead in line.get_xdata()]
        np.testing.assert_array_equal(marked, data["bead"].where(wide, drop=True))


def test_errors_of_continuum_fronts_are_distances_to_the_exact_one():
    scenes, panels = picture("fronts_compared")
    for row, data in enumerate(scenes):
        for line, model in zip(data_curves(panels[f"error {row}"]), MODELS, strict=True):
            np.testing.assert_array_equal(line.get_ydata(), data[f"{U}_{model}"] - data[U])


def test_the_phase_portrait_holds_its_orbit():
    [data], panels = picture("fig08")
    *trajectories, orbit = data_curves(panels["portrait"])[: data.sizes["trajectory"] + 1]
    for number, line in zip(data["trajectory"], trajectories, strict=True):
        one = data.sel(trajectory=number)
        np.testing.assert_array_equal(line.get_xdata(), one["rescaled_force_portrait"])
        np.testing.assert_array_equal(line.get_ydata(), one["slope_portrait"])
    assert holds([data.sel(mu=data.attrs["portrait_mu"])], "slope", orbit.get_ydata())


def test_multipliers_that_rounding_moves_are_left_out_and_that_nearest_to_one():
    [data], panels = picture("multipliers")
    for scene in data["scene"].values:
        lines = curves(panels[f"{scene} near 1"])
        windows = [line for line in lines if "behind" in str(line.get_label())]
        for line, behind in zip(windows, data["beads_behind"].values, strict=True):
            found = data.sel(scene=scene, beads_behind=behind)
            distance = np.hypot(found["multiplier_real"] - 1.0, found["multiplier_imaginary"])
            found = found.drop_isel(multiplier=int(np.nanargmin(distance)))
            exact = found.where(found["multiplier_rounding"] < 1e-2)
            np.testing.assert_array_equal(line.get_xdata(), exact["multiplier_real"])
            np.testing.assert_array_equal(line.get_ydata(), exact["multiplier_imaginary"])


def test_jump_conditions_are_distances_over_the_sum_of_both_errors():
    [data], panels = picture("jump_conditions")
    names = ["speed_exact", "speed_travelling", "power_exact"]
    names += ["speed_driven", "velocity_jump_driven", "power_driven"]
    for ratio, name in zip(data_curves(panels["distances"]), names, strict=True):
        theory = name.rpartition("_")[0] + "_expected"
        stated = data[f"{name}_error"] + data[f"{theory}_error"]
        np.testing.assert_array_equal(ratio.get_xdata(), (data[name] - data[theory]) / stated)


def test_damping_is_dashed_where_fronts_oscillate():
    [data], panels = picture("damping_regimes")
    lines = curves(panels["gamma"])
    marked = [line for line in lines if line.get_linestyle() == "None"]
    for marks, beta in zip(marked, data["beta"], strict=True):
        law = data.sel(beta=beta)
        oscillating = law["velocity_ratio"].where(law["gamma"] < law["critical_gamma"], drop=True)
        colour = marks.get_color()
        alike = [one for one in lines if one is not marks and one.get_color() == colour]
        dashed, full = (
            {x for line in alike if line.is_dashed() == dashes for x in line.get_xdata()}
            for dashes in (True, False)
        )
        assert dashed == set(oscillating.values)
        assert full | dashed == set(law["velocity_ratio"].values)
        assert len(full & dashed) <= 1
