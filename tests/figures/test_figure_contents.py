"""Every curve, dot and colour of a figure is a number of its data, under the right name.

What a figure draws of a sample is traced back to the variables of the sample and compared with
`references/figures.yaml`; the rest of this file is what no line of that file says.
"""

import matplotlib.pyplot as plt
import numpy as np
import pytest
import yaml
from figure_samples import SAMPLES, ring
from pictures import LISTED, curves, draw, image, legend, picture
from plot_fig05 import plot_fig05
from traces import REFERENCE, Sample, describe

from granular_fronts.output.style import ALARM_COLOUR, compression_map, velocity_map

SHOWN = yaml.safe_load(REFERENCE.read_text(encoding="utf-8"))


def test_every_figure_is_drawn_from_a_sample_of_what_the_workflow_names():
    assert SAMPLES.keys() == LISTED.keys() == SHOWN.keys()
    for figure, sample in SAMPLES.items():
        assert sample().keys() == LISTED[figure]["data"].keys()


@pytest.mark.parametrize("figure", SAMPLES)
def test_figure_shows_the_variables_of_its_data(figure):
    assert describe(figure) == SHOWN[figure]


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


def test_figure_2_shows_wide_gaps_in_red():
    _, shown = picture("fig02")
    plane = image(shown["displacement"])
    assert plane.colorbar.extend == "min"
    assert plane.cmap(plane.norm(-0.2)) == plt.matplotlib.colors.to_rgba(ALARM_COLOUR)


def test_figure_5_shows_no_other_time_than_the_start():
    with pytest.raises(KeyError, match="'t'"):
        plot_fig05(ring(1.1, [15.0]), ring(1.5, [15.0]))


def test_figure_8_has_arrows_to_the_saddle_and_towards_larger_s():
    data, shown = picture("fig08")
    [arrow] = shown["well"].texts
    assert arrow.xyann[0] == 1.0
    assert arrow.xy[0] < 0.1
    *_, last = shown["portrait"].texts
    assert len(shown["portrait"].texts) == 3
    front = data.sel(mu=0.3)
    assert last.xyann == tuple(front[name].sel(s=0.0) for name in ("rescaled_force", "slope"))
    assert last.xy == tuple(front[name].sel(s=2.0) for name in ("rescaled_force", "slope"))


def test_figure_12_leaves_fronts_that_do_not_overshoot_white():
    data, shown = picture("fig12")
    hidden = (data["overshoot"] <= 1e-8).transpose("gamma", "alpha")
    assert hidden.sum() == 1
    np.testing.assert_array_equal(np.ma.getmaskarray(image(shown["plane"]).get_array()), hidden)


def test_figure_15_lists_only_what_occurs():
    given = SAMPLES["fig15"]()
    given["data"]["error"][2] = given["data"]["error"][0]
    given["data"]["passed"][:] = 1
    assert legend(draw("fig15", given).axes[0]) == ["limit", "passed"]


def test_figure_16_leaves_fronts_without_overshoot_white_and_unsolved_ones_red():
    data, curves, _, shown = picture("fig16")
    plane = image(shown["overshoot"])
    # Columns are α = 1.1, monotone, 1.3, swinging unseen, and 1.5, visibly, with one not solved.
    colours = plane.cmap(plane.norm(plane.get_array()))
    white, red = (plt.matplotlib.colors.to_rgba(name) for name in ("white", ALARM_COLOUR))
    assert (colours[:, :2] == white).all()
    assert (colours[1, 2] == red).all()
    assert tuple(colours[0, 2]) not in (white, red)
    assert plane.norm.vmin == curves.attrs["overshoot_cut"]
    assert plane.colorbar.extend == "min"
    width = np.ma.filled(image(shown["width"]).get_array(), np.nan)
    np.testing.assert_array_equal(width, data["width_10_90"].transpose("gamma", "alpha"))


def test_figure_16_names_its_regions_on_the_right_sides_of_all_curves():
    _, curves, _, shown = picture("fig16")
    axes = shown["overshoot"]
    critical = [curves[f"critical_damping_{name}"] for name in ("tail", "long_wave", "overshoot")]
    axes.set_ylim(0.01, 10.0)
    places = {text.get_text(): text for text in axes.texts}
    for word, above in (("monotone", True), ("oscillating", False)):
        share = places[word].get_position()
        _, gamma = axes.transData.inverted().transform(axes.transAxes.transform(share))
        assert all(np.all((gamma > curve) == above) for curve in critical)


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


def test_colour_maps_keep_their_order_in_grey():
    weights = [0.2126, 0.7152, 0.0722, 0.0]
    for colour_map in (compression_map(), velocity_map()):
        assert np.all(np.diff(colour_map(np.linspace(0.0, 1.0, 33)) @ weights) < 0.0)
