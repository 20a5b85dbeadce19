"""Figures 1 to 7b and 19: each curve, dot and colour is a number of the chain's dataset."""

import numpy as np
import pytest
from figure_samples import EQUATIONS, FIELDS, ring
from pictures import (
    annotations,
    assert_curve,
    assert_labels,
    assert_plane,
    curves,
    image,
    legend,
    picture,
)
from plot_fig05 import plot_fig05

from granular_fronts.output.style import ALARM_COLOUR


def assert_probes(axes, data, name):
    """A curve for each bead of a probe set, each of another look."""
    probes = data[f"relative_displacement_{name}"].transpose(f"bead_{name}", ...)
    drawn = curves(axes)
    for line, probe in zip(drawn, probes, strict=True):
        assert_curve(line, data[f"t_{name}"], probe)
        assert line.get_label() == f"$n = {int(probe[f'bead_{name}'])}$"
    assert len({(line.get_color(), str(line.get_linestyle())) for line in drawn}) == len(drawn)
    assert_labels(axes, "$t$", "$u_n(t)$")
    assert axes.get_xlim() == (data[f"t_{name}"][0], data[f"t_{name}"][-1])


def test_figure_1_shows_probes_and_the_velocities_at_one_time():
    data, panels = picture("fig01")
    assert_probes(panels["steady"], data, "steady")
    assert_probes(panels["transient"], data, "transient")
    assert legend(panels["transient"]) == ["$n = 1$", "$n = 3$"]
    [velocities] = curves(panels["snapshot"])
    assert_curve(velocities, data["bead"], data["velocity"].isel(t=0))
    assert_labels(panels["snapshot"], "$n$", r"$\dot x_n$")
    assert panels["snapshot"].get_title() == "$t = 20$"


def test_figure_1_names_each_bead_above_its_largest_compression():
    data, panels = picture("fig01")
    probes = data["relative_displacement_steady"]
    assert annotations(panels["steady"]) == ["$n = 6$", "$n = 9$", "$n = 12$"]
    for text, bead in zip(panels["steady"].texts, data["bead_steady"], strict=True):
        curve = probes.sel(bead_steady=bead)
        assert text.xy == (curve.idxmax(), curve.max())


def test_figure_2_shows_both_space_time_diagrams_and_gaps_in_red():
    data, panels = picture("fig02")
    compressions = data["relative_displacement_grid"].isel(bead=slice(None, -1))
    assert_plane(panels["displacement"], compressions, "$u_n(t)$")
    assert_plane(panels["velocity"], data["velocity_grid"], r"$\dot x_n(t)$")
    assert_labels(panels["displacement"], "$n$", "$t$")
    assert_labels(panels["velocity"], "$n$", "")
    shown = image(panels["displacement"])
    # The paper clips at 0.14 where δ is 0.1.
    assert shown.get_clim() == pytest.approx((-0.14, 0.14))
    assert shown.colorbar.extend == "min"
    rgb = [int(ALARM_COLOUR[first : first + 2], 16) / 255 for first in (1, 3, 5)]
    np.testing.assert_allclose(shown.cmap(shown.norm(-0.2))[:3], rgb)
    assert image(panels["velocity"]).get_clim()[0] == 0.0


def test_figure_3_shows_the_first_beads_and_the_whole_chain():
    data, panels = picture("fig03")
    assert_probes(panels["transient"], data, "transient")
    assert legend(panels["transient"]) == ["$n = 1$", "$n = 3$"]
    compressions = data["relative_displacement_grid"].isel(bead=slice(None, -1))
    assert_plane(panels["displacement"], compressions, "$u_n(t)$")
    assert_labels(panels["displacement"], "$n$", "$t$")


LABELS = {"relative_displacement": "$u_n$", "velocity": r"$\dot x_n$"}


def test_figure_5_shows_the_start_of_both_rings():
    *rings, panels = picture("fig05")
    assert list(panels) == [f"{field} {row}" for row in range(2) for field in FIELDS]
    for row, (data, alpha) in enumerate(zip(rings, ("1.1", "1.5"), strict=True)):
        for field in FIELDS:
            axes = panels[f"{field} {row}"]
            [dots] = curves(axes)
            assert_curve(dots, data["bead"], data[field].sel(t=0.0))
            assert dots.get_linestyle() == "None"
            assert annotations(axes) == [rf"$\alpha = {alpha}$"]
            assert_labels(axes, "$n$" if row else "", LABELS[field])


def test_figure_5_shows_no_other_time_than_the_start():
    with pytest.raises(KeyError, match="'t'"):
        plot_fig05(ring(1.1, [15.0]), ring(1.5, [15.0]))


@pytest.mark.parametrize("figure", ["fig06", "fig07"])
def test_figures_6_and_7_show_ring_and_equation_after_the_start(figure):
    data, panels = picture(figure)
    assert list(panels) == [f"{field} {row}" for row in (1, 2) for field in FIELDS]
    for row, t in ((1, 15.0), (2, 30.0)):
        for field in FIELDS:
            axes = panels[f"{field} {row}"]
            equation, dots = curves(axes)
            assert_curve(equation, data["site"], data[f"{field}_logarithmic"].sel(t=t))
            assert_curve(dots, data["bead"], data[field].sel(t=t))
            assert (equation.get_linestyle(), dots.get_linestyle()) == ("-", "None")
            assert axes.get_title() == f"$t = {t:g}$"
            assert_labels(axes, "$n$" if row == 2 else "", LABELS[field])
    assert legend(axes) == ["equation (41)", "chain"]


def test_figure_7b_shows_three_distances_to_two_equations():
    *rings, panels = picture("fig07b")
    kinds = {"sup": "largest", "rms": "rms", "floor": "solvers"}
    numbers = {"logarithmic": "(41)", "unlimited": "(40)"}
    expected = [(kind, equation) for kind in kinds for equation in EQUATIONS]
    for row, (data, alpha) in enumerate(zip(rings, ("1.1", "1.5"), strict=True)):
        for field in FIELDS:
            axes = panels[f"{field} {row}"]
            for line, (kind, equation) in zip(curves(axes), expected, strict=True):
                # The distance is zero at the start, where chain and equation agree.
                later = data[f"{field}_{kind}_{equation}"].isel(t_grid=slice(1, None))
                assert_curve(line, later["t_grid"], later)
                assert line.get_label() == f"{numbers[equation]} {kinds[kind]}"
            assert axes.get_title().startswith(rf"$\alpha = {alpha}$")
            ordinate = "" if field == "velocity" else "difference chain to equation"
            assert_labels(axes, "$t$" if row else "", ordinate, "linear log")
    assert legend(axes) == [f"{numbers[equation]} {kinds[kind]}" for kind, equation in expected]


def test_figure_19_shows_three_chains_and_the_damping_that_theta_means():
    data, panels = picture("fig19")
    axes = panels["profile"]
    for line, name in zip(curves(axes), ("conservative", "damped", "method"), strict=True):
        assert_curve(line, data["bead"], data[f"relative_displacement_{name}"])
    # γ = (2θ − 1)h, with θ = 3/4 and h = 0.12.
    assert legend(axes) == [
        "conservative chain",
        r"damped chain, $\gamma = 0.06$",
        r"$\theta$-method, $\theta = 0.75$, $h = 0.12$",
    ]
    assert axes.get_title() == "$t = 12$"
    assert_labels(axes, "$n$", "$u_n$")


def test_figure_19_shows_both_distances_over_the_step():
    data, panels = picture("fig19")
    axes = panels["order"]
    drawn = iter(curves(axes))
    for theta in data["theta"].values:
        row = data.sel(theta=theta)
        for name, style in (("damping_distance", "-"), ("conservative_distance", ":")):
            line = next(drawn)
            assert_curve(line, data["step"], row[name])
            assert line.get_linestyle() == style
    assert not list(drawn)
    orders = [f"{float(order):.2f}" for order in data["order"]]
    assert legend(axes) == [
        rf"$\theta = {theta:g}$, order {order}"
        for theta, order in zip((0.75, 1.0), orders, strict=True)
    ]
    assert_labels(axes, "$h$", r"$\max_n |\Delta u_n|/\delta$", "log log")
