"""Every curve, dot and colour of a figure is a number of its data, under the right name.

What a figure draws of a sample is traced back to the variables of the sample and compared with
`references/figures.yaml`; the rest of this file is what no line of that file says.
"""

import re
from string import ascii_lowercase

import numpy as np
import pytest
import yaml
from figure_samples import SAMPLES, TAKEN, ring
from matplotlib.colors import to_rgba
from pictures import LISTED, annotations, curves, draw, image, legend, panels, picture, sampled
from plot_fig05 import plot_fig05
from projects import ROOT
from scipy.special import stdtrit
from traces import REFERENCE, Sample, describe

from granular_fronts.output.style import ALARM_COLOUR, compression_map, velocity_map

GREY = [0.2126, 0.7152, 0.0722, 0.0]
SHOWN = yaml.safe_load(REFERENCE.read_text(encoding="utf-8"))


def test_every_figure_is_drawn_from_a_sample_of_what_the_workflow_names():
    assert SAMPLES.keys() == LISTED.keys() == SHOWN.keys(), "see A figure in docs/extending.md"
    for figure, sample in SAMPLES.items():
        assert sample().keys() == LISTED[figure]["data"].keys()


@pytest.mark.parametrize("figure", SAMPLES)
def test_figure_shows_the_variables_of_its_data(figure):
    assert describe(figure) == SHOWN[figure]
    for given in SAMPLES[figure]().values():
        for data in given if isinstance(given, list) else [given]:
            assert TAKEN.isdisjoint(data.dims)


@pytest.mark.parametrize("figure", SAMPLES)
def test_caption_names_no_letter_that_the_figure_lacks(figure):
    """Letters run along the rows, and a figure of one panel has none."""
    _, drawn = sampled(figure)
    shown = panels(drawn).values()
    places = [axes.get_subplotspec() for axes in shown]
    assert places == sorted(places, key=lambda place: (place.rowspan.start, place.colspan.start))
    letters = [f"({letter})" for letter in ascii_lowercase[: len(places)]]
    letters = letters if len(letters) > 1 else [""]
    assert [axes.get_title("left") for axes in shown] == letters
    caption = (ROOT / "workflow" / "report" / f"{figure}.rst").read_text(encoding="utf-8")
    assert set(re.findall(r"\([a-p]\)", caption)) <= set(letters)


def test_curve_of_other_numbers_has_another_name_and_one_out_of_place_has_none():
    """The negative control of the test above."""
    data, shown = picture("fig11")
    sample, line = Sample({"data": data}), curves(shown["1.1"])[0]
    name = sample.curve(line)
    x, y = (np.array(values) for values in line.get_data())
    line.set_ydata(data["distance_unlimited"].sel(alpha=1.1))
    assert sample.curve(line) == name.replace("distance_logarithmic", "distance_unlimited")
    line.set_ydata(1.01 * y)
    assert "distance" not in sample.curve(line)
    line.set_data(x[::-1], y)
    assert "over gamma" not in sample.curve(line)
    line.set_data(x, y)


def test_figure_1_names_each_bead_above_its_largest_compression():
    data, shown = picture("fig01")
    probes = data["relative_displacement_steady"]
    for text, bead in zip(shown["steady"].texts, data["bead_steady"], strict=True):
        curve = probes.sel(bead_steady=bead)
        assert text.xy == (curve.idxmax(), curve.max())


def test_figures_2_and_3_have_white_rest_red_gaps_and_the_same_scale():
    scales = []
    for figure in ("fig02", "fig03"):
        *_, shown = picture(figure)
        plane = image(shown["displacement"])
        scales.append((plane.get_clim(), plane.cmap(plane.norm(0.05))))
        assert np.allclose(plane.cmap(plane.norm(0.0)), 1.0, atol=0.02)
    assert scales[0] == scales[1]
    assert scales[0][0] == pytest.approx((-0.14, 0.14))
    given = SAMPLES["fig02"]()
    given["data"]["relative_displacement_grid"][3, 4] = -50.0
    plane = image(panels(draw("fig02", given))["displacement"])
    assert plane.colorbar.extend == "min"
    assert plane.cmap(plane.norm(-50.0)) == to_rgba(ALARM_COLOUR)


def test_figure_2_shows_the_free_end_when_the_front_arrives():
    data, shown = picture("fig02")
    [inset] = shown["displacement"].child_axes
    plane = data["relative_displacement_grid"].isel(bead=slice(None, -1))
    np.testing.assert_array_equal(image(inset).get_array(), plane)
    assert inset.get_xlim()[1] == data["bead"][-1]
    first, last = inset.get_ylim()
    assert first < data["arrival_time"].max() < last


def test_figure_5_shows_no_other_time_than_the_start():
    with pytest.raises(KeyError, match="'t'"):
        plot_fig05(ring(1.1, [15.0]), ring(1.5, [15.0]))


def test_figure_6_marks_gaps_that_do_not_fit_with_the_width_of_the_widest():
    given = SAMPLES["fig06"]()
    given["data"]["relative_displacement"][1, 3:5] = [-3.25, -2.0]
    shown = panels(draw("fig06", given))
    first, second = shown["relative_displacement 0"], shown["relative_displacement 1"]
    assert first.get_ylim() == second.get_ylim()
    [marks] = [line for line in curves(first) if line.get_marker() == "v"]
    np.testing.assert_array_equal(marks.get_xdata(), given["data"]["bead"][3:5])
    assert annotations(first) == ["gap of 3.2"]
    assert annotations(second) == []


def test_figure_8_has_arrows_to_the_saddle_and_towards_larger_s():
    data, shown = picture("fig08")
    arrow, *_ = shown["well"].texts
    assert arrow.xyann[0] == 1.0
    assert arrow.xy[0] < 0.1
    *_, last = shown["portrait"].texts
    assert len(shown["portrait"].texts) == 3
    front = data.sel(mu=0.3)
    assert last.xyann == tuple(front[name].sel(s=0.0) for name in ("rescaled_force", "slope"))
    assert last.xy == tuple(front[name].sel(s=2.0) for name in ("rescaled_force", "slope"))


def test_figure_10_shows_errors_of_compression_and_no_spike():
    scenes, shown = picture("fig10")
    for row, data in enumerate(scenes):
        exact = data["relative_displacement"]
        drawn = curves(shown[f"error {row}"])
        for line, name in zip(drawn, ("logarithmic", "unlimited", "heteroclinic"), strict=False):
            expected = data[f"relative_displacement_{name}"] - exact
            np.testing.assert_array_equal(line.get_ydata(), expected)
        low, high = shown[f"relative_displacement {row}"].get_ylim()
        assert low < exact.min() < exact.max() < high < exact.max() + 1.0


def test_figure_12_is_white_where_its_colour_bar_is():
    data, materials, shown = picture("fig12")
    bands = shown["plane"].collections
    above = [data["critical_damping_overshoot"], *data["overshoot_level"]]
    for band, curve in zip(bands, above, strict=True):
        drawn = band.get_paths()[0].vertices[:, 1]
        assert np.isin(curve.dropna("alpha"), drawn).all()
    assert np.all(np.diff([band.get_facecolor()[0] @ GREY for band in bands]) < 0.0)
    assert annotations(shown["plane"])[: materials.sizes["material"]] == ["steel", "cork"]


def test_figure_13_leaves_out_what_rounding_moves():
    data, shown = picture("fig13")
    for scene in data["scene"].values:
        windows = [line for line in curves(shown[scene]) if "behind" in str(line.get_label())]
        for line, behind in zip(windows, data["beads_behind"].values, strict=True):
            one = data.sel(scene=scene, beads_behind=behind)
            hidden = (one["multiplier_rounding"] >= 1e-2).values
            np.testing.assert_array_equal(np.isnan(line.get_xdata()), hidden)
    assert 0 < (data["multiplier_rounding"] >= 1e-2).sum() < data["multiplier_rounding"].size


def test_figure_15_lists_only_what_occurs():
    given = SAMPLES["fig15"]()
    given["data"]["error"][2] = given["data"]["error"][0]
    given["data"]["passed"][:] = 1
    assert legend(draw("fig15", given).axes[0]) == ["limit", "passed"]


def test_figure_17_shows_distances_over_the_sum_of_both_errors():
    data, shown = picture("fig17")
    names = [
        "speed_exact",
        "speed_travelling",
        "power_exact",
        "speed_driven",
        "velocity_jump_driven",
    ]
    names.append("power_driven")
    ratios = [*curves(shown["exact"]), *curves(shown["driven"])]
    errors = curves(shown["error"])
    for ratio, error, name in zip(ratios, errors, names, strict=True):
        theory = name.rpartition("_")[0] + "_expected"
        stated = data[f"{name}_error"] + data[f"{theory}_error"]
        np.testing.assert_array_equal(ratio.get_xdata(), (data[name] - data[theory]) / stated)
        np.testing.assert_array_equal(error.get_xdata(), data[f"{name}_error"] / data[theory])
    for name in ("exact", "driven"):
        # Theory holds between −1 and 1.
        [band] = shown[name].patches
        assert (band.get_x(), band.get_width()) == (-1.0, 2.0)
        marks = curves(shown[name])
        assert np.abs([line.get_xdata() for line in marks]).max() < shown[name].get_xlim()[1]
        # No two marks of a lattice are at one height, or nearer to another lattice.
        heights = np.stack([line.get_ydata() for line in marks])
        assert np.abs(heights - [[2, 1, 0]]).max() < 0.5
        assert np.diff(np.sort(heights, axis=0), axis=0).min() > 0.2


def test_figure_18_dashes_where_fronts_oscillate_and_leaves_no_hole():
    data, shown = picture("fig18")
    drawn = iter(curves(shown["gamma"]))
    for dashed, full, beta in zip(drawn, drawn, data["beta"], strict=True):
        law = data.sel(beta=beta)
        oscillating = (law["gamma"] < law["critical_gamma"]).values
        assert dashed.get_color() == full.get_color()
        assert dashed.is_dashed()
        assert not full.is_dashed()
        assert np.isfinite(dashed.get_ydata()).all()
        np.testing.assert_array_equal(np.isfinite(full.get_ydata()), ~oscillating)
        assert 0 < oscillating.sum() < oscillating.size


def test_figure_26_has_the_means_over_the_seeds_with_their_errors():
    _, _, draws, _, shown = picture("fig26")
    energy = draws["transmitted_energy"]
    drawn = (np.asarray(line.get_ydata(), float) for line in curves(shown["draws"])[2:5])
    mean, *ends = drawn
    standard = energy.std("beads_mass_random_seed", ddof=1) / 2**0.5
    error = 0.5 * stdtrit(1, 0.975) * standard + 1e-6
    np.testing.assert_allclose(mean, energy.mean("beads_mass_random_seed"))
    for end, sign in zip(ends, (-1.0, 1.0), strict=True):
        np.testing.assert_allclose(end, mean + sign * error)


def test_figure_20_names_the_damping_and_the_ratio_that_it_shows():
    samples = SAMPLES["fig20"]()
    for name, axis, values in (("damping", "damping", [0.3, 0.7]), ("mu", "mu", [3.0, 8.0])):
        samples[name] = samples[name].assign_coords({axis: values})
    limits = panels(draw("fig20", samples))
    assert limits["damping"].get_title().endswith(r"$\gamma c = 0.7$")
    assert limits["mu"].get_title().startswith(r"$\mu = 3$")


def test_colour_maps_keep_their_order_in_grey():
    greys = [each(np.linspace(0.0, 1.0, 33)) @ GREY for each in (compression_map(), velocity_map())]
    for grey in (greys[0][16:], greys[0][16::-1], greys[1]):
        assert np.all(np.diff(grey) < 0.0)
