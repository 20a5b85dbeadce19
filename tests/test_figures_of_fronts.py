"""Figures 4, 8 to 13 and 16: each curve, dot and colour is a number of a front's dataset."""

import numpy as np
from figure_samples import CONTINUUM, FIELDS
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

FRONTS = {"logarithmic": "(45)", "unlimited": "(46)", "heteroclinic": "heteroclinic"}


def test_figure_4_shows_fluxes_and_fronts_with_their_limit():
    data, panels = picture("fig04")
    drawn = iter(curves(panels["flux"]))
    for alpha in (1.5, 1.1):
        assert_curve(next(drawn), data["force"], data["flux"].sel(alpha=alpha))
        assert_curve(next(drawn), data["force"], data["compression"].sel(alpha=alpha))
    assert_curve(next(drawn), data["force"], data["flux_limit"])
    # y^(1/α) tends to y itself.
    assert_curve(next(drawn), data["force"], data["force"])
    fronts = [*data["front"], data["front_limit"]]
    for line, front in zip(curves(panels["front"]), fronts, strict=True):
        assert_curve(line, data["xi"], front)
    assert legend(panels["front"]) == [
        r"$\alpha = 1.5$",
        r"$\alpha = 1.1$",
        r"$\alpha \to 1^+$",
    ]
    assert_labels(panels["flux"], "$y$", r"$f_\alpha(y)$, dotted $y^{1/\alpha}$")
    assert_labels(panels["front"], r"$\xi$", r"$y_\alpha^{1/\alpha}$")


def test_figure_8_shows_the_well_with_its_bottom_and_the_saddle():
    data, panels = picture("fig08")
    well, points = curves(panels["well"])
    assert_curve(well, data["y"], data["potential"])
    assert_curve(points, [0.0, 1.0], [0.0, data["potential"].sel(y=1.0)])
    assert_labels(panels["well"], "$y$", "$W(y)$")
    [arrow] = panels["well"].texts
    assert arrow.xyann[0] == 1.0
    assert arrow.xy[0] < 0.1


def test_figure_8_shows_the_phase_portrait_with_the_orbit():
    data, panels = picture("fig08")
    axes = panels["portrait"]
    *trajectories, orbit, fixed = curves(axes)
    for line, number in zip(trajectories, data["trajectory"], strict=True):
        one = data.sel(trajectory=number)
        assert_curve(line, one["rescaled_force_portrait"], one["slope_portrait"])
    front = data.sel(mu=0.3)
    assert_curve(orbit, front["rescaled_force"], front["slope"])
    assert_curve(fixed, [-1.0, 0.0, 1.0], [0.0, 0.0, 0.0])
    # An arrow on each trajectory points to larger s, from s = 0.
    *_, last = axes.texts
    assert len(axes.texts) == 3
    assert last.xyann == tuple(front[name].sel(s=0.0) for name in ("rescaled_force", "slope"))
    assert last.xy == tuple(front[name].sel(s=2.0) for name in ("rescaled_force", "slope"))
    assert axes.get_title() == r"$\mu = 0.3$"
    assert_labels(axes, "$y$", "$z$")


def test_figure_8_shows_a_front_for_each_damping():
    data, panels = picture("fig08")
    assert list(panels) == ["well", "portrait", "front 0.3", "front 1", "front 2"]
    for mu in data["mu"].values:
        axes = panels[f"front {mu:g}"]
        [line] = curves(axes)
        assert_curve(line, data["s"], data["rescaled_force"].sel(mu=mu))
        assert axes.get_title() == rf"$\mu = {mu:g}$"
        assert_labels(axes, "$s$", r"$y_\mathrm{h}(s)$")


def test_figure_9_shows_both_methods_their_difference_and_residuals():
    *fronts, panels = picture("fig09")
    for column, data in enumerate(fronts):
        axes = panels[f"u {column}"]
        profile, shooting = curves(axes)
        assert_curve(profile, data["xi"], data["relative_displacement"])
        # Points of shooting stand at every bead only, where ξ is whole.
        whole = data["xi_shooting"] % 1.0 == 0.0
        assert 0 < whole.sum() < whole.size
        shot = data["relative_displacement_shooting"][whole.values]
        assert_curve(shooting, shot["xi_shooting"], shot)
        gamma = ("0.05", "0.65")[column]
        assert axes.get_title() == rf"$\alpha = 1.5$, $\gamma c = {gamma}$"
        assert_labels(axes, r"$\xi = n - ct$", r"$u/\delta$")

        axes = panels[f"difference {column}"]
        for line, field in zip(curves(axes), FIELDS, strict=True):
            assert_curve(line, data["xi_shooting"], np.abs(data[f"{field}_difference"]))
        assert legend(axes) == ["$u$", r"$\dot x$"]
        assert_labels(axes, r"$\xi$", "|shooting − profile|", "linear log")

        axes = panels[f"residual {column}"]
        for line, method in zip(curves(axes), ("profile", "shooting"), strict=True):
            residuals = data[f"residual_history_{method}"]
            assert_curve(line, np.arange(residuals.size), residuals)
        assert_labels(axes, "step", "residual", "linear log")
    assert legend(panels["u 0"]) == legend(panels["residual 0"]) == ["profile", "shooting"]


def test_figure_10_shows_five_models_of_each_front():
    scenes, panels = picture("fig10")
    ordinates = {
        "relative_displacement": r"$u/\delta$",
        "velocity": r"$\dot x/\delta^{(\alpha+1)/2}$",
    }
    for row, data in enumerate(scenes):
        for field in FIELDS:
            axes = panels[f"{field} {row}"]
            driven, *continuum, exact = curves(axes)
            assert_curve(driven, data["xi_driven"], data[f"{field}_driven"])
            for line, front in zip(continuum, CONTINUUM, strict=True):
                assert_curve(line, data["xi"], data[f"{field}_{front}"])
                assert line.get_label() == FRONTS[front]
            assert_curve(exact, data["xi"], data[field])
            gamma = ("0.05", "0.65")[row]
            assert axes.get_title() == rf"$\alpha = 1.5$, $\gamma c = {gamma}$"
            assert_labels(axes, r"$\xi = n - ct$" if row == 1 else "", ordinates[field])
    assert legend(axes) == ["driven chain", *FRONTS.values(), "exact"]


def test_figure_11_shows_errors_over_the_damping():
    data, panels = picture("fig11")
    assert list(panels) == ["1.02", "1.1", "1.5", "2"]
    for name, axes in panels.items():
        one = data.sel(alpha=float(name))
        for line, front in zip(curves(axes), CONTINUUM, strict=True):
            assert_curve(line, data["gamma"], one[f"distance_{front}"])
            assert line.get_label() == FRONTS[front]
        [critical] = set(axes.get_lines()) - set(curves(axes))
        assert critical.get_xdata() == [one["critical_damping"]] * 2
        assert axes.get_title() == rf"$\alpha = {name}$"
        ordinate = "largest error of $u/\\delta$" if name in ("1.02", "2") else ""
        assert_labels(axes, r"$\gamma c$" if name == "2" else "", ordinate, "log log")
    assert legend(panels["1.02"]) == list(FRONTS.values())


def test_figure_12_shows_the_overshoot_and_four_meanings_of_critical_damping():
    data, panels = picture("fig12")
    axes = panels["plane"]
    # Fronts that overshoot by less than 1e-8 stay white.
    overshoot = data["overshoot"].where(data["overshoot"] > 1e-8).transpose("gamma", "alpha")
    assert np.isnan(overshoot).sum() == 1
    assert_plane(axes, overshoot, r"overshoot $\max u/\delta - 1$")
    assert image(axes).get_clim() == (1e-8, 1.0)
    assert type(image(axes).norm).__name__ == "LogNorm"
    meanings = ("tail", "double_root", "long_wave", "overshoot")
    for line, name in zip(curves(axes), meanings, strict=True):
        assert_curve(line, data["alpha"], data[f"critical_damping_{name}"])
    [exchange] = set(axes.get_lines()) - set(curves(axes))
    assert exchange.get_xdata() == [1.3, 1.3]
    assert legend(axes) == [
        "tail: what governs the decay",
        "double root",
        r"long waves, $((1-1/\alpha)/3)^{1/2}$",
        "overshoot of 0.001",
    ]
    assert_labels(axes, r"$\alpha$", r"$\gamma c$", "linear log")


def test_figure_13_shows_all_multipliers_in_the_complex_plane():
    data, panels = picture("fig13")
    for front in ("underdamped", "overdamped"):
        one = data.sel(scene=front)
        for name in (front, f"{front} near 1"):
            circle, *waves_and_windows = curves(panels[name])[:6]
            x, y = circle.get_data()
            np.testing.assert_allclose(x**2 + y**2, 1.0, rtol=1e-14)
            for line, branch in zip(waves_and_windows[:2], one["branch"], strict=True):
                wave = one.sel(branch=branch)
                real, imaginary = (
                    wave[f"essential_multiplier_{part}"] for part in ("real", "imaginary")
                )
                assert_curve(line, real, imaginary)
            for line, behind in zip(waves_and_windows[2:], one["beads_behind"], strict=True):
                window = one.sel(beads_behind=behind)
                assert_curve(line, window["multiplier_real"], window["multiplier_imaginary"])
                assert line.get_label() == f"{int(behind)} beads behind"
        law = rf"$\alpha = {float(one['alpha']):g}$, $\gamma c = {float(one['gamma']):g}$"
        assert panels[front].get_title() == law
        assert panels[front].get_aspect() == 1.0
        assert_labels(panels[front], r"Re $z$", r"Im $z$")
        assert_labels(panels[f"{front} near 1"], r"Re $z$", r"Im $z$")
        *_, translation = curves(panels[f"{front} near 1"])
        assert_curve(translation, [1.0], [0.0])
    windows = [f"{behind} beads behind" for behind in (20, 40, 80)]
    assert legend(panels[front]) == ["compressed chain", *windows, "translation"]


def test_figure_16_shows_overshoot_width_and_regime_over_the_plane():
    data, _, _, panels = picture("fig16")
    plane = data.transpose("gamma", "alpha")
    # A logarithmic scale shows a front that does not overshoot as the smallest of all.
    assert_plane(panels["overshoot"], plane["overshoot"].clip(min=1e-7), "overshoot")
    assert image(panels["overshoot"]).get_clim() == (1e-6, 1.0)
    assert_plane(panels["width"], plane["width_10_90"], "width, 90 % to 10 %")
    for name in ("overshoot", "width"):
        assert type(image(panels[name]).norm).__name__ == "LogNorm"
    regime = image(panels["regime"])
    # Columns are α = 1.1, monotone, 1.3, swinging unseen, and 1.5, visibly, with one not solved.
    shown = np.ma.filled(regime.get_array(), np.nan)
    np.testing.assert_array_equal(shown, [[0.0, 1.0, 2.0], [0.0, 1.0, np.nan]])
    words = [text.get_text() for text in regime.colorbar.ax.get_xticklabels()]
    assert words == ["monotone", "oscillating", "by > 1 %"]


def test_figure_16_shows_critical_damping_and_real_beads_in_every_panel():
    _, critical, materials, panels = picture("fig16")
    for name, axes in panels.items():
        *lines, steel, cork = curves(axes)
        for line, meaning in zip(lines, ("tail", "double_root", "long_wave"), strict=True):
            assert_curve(line, critical["alpha"], critical[f"critical_damping_{meaning}"])
        # Beads obey Hertz's law, α = 3/2.
        for dot, gamma in zip((steel, cork), materials["gamma_printed"], strict=True):
            assert_curve(dot, [1.5], [gamma])
        assert annotations(axes) == ["steel", "cork"]
        ordinate = r"$\gamma c$" if name == "overshoot" else ""
        assert_labels(axes, r"$\alpha$", ordinate, "linear log")
    assert legend(axes) == ["tail turns real", "double root", r"long waves, $\mu = 2$"]
