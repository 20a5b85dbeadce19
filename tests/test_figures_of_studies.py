"""Figures 14, 15, 17 and 18: each point is a number of its dataset, failures are seen as such."""

import numpy as np
from figure_samples import SAMPLES
from pictures import (
    annotations,
    assert_curve,
    assert_labels,
    curves,
    draw,
    legend,
    picture,
    sampled,
)

from granular_fronts.output.style import ALARM_COLOUR


def test_figure_14_shows_time_against_error_from_loose_to_tight():
    data, panels = picture("fig14")
    assert panels["contact_loss"].get_ylabel() == ""
    assert panels["ring_hertz"].get_ylabel() == "seconds"
    for problem, axes in panels.items():
        drawn = iter(curves(axes))
        for method in data["method"].values:
            runs = data.sel({"problem": problem, "method": method, "tolerance": [1e-4, 1e-6, 1e-8]})
            solved = runs.isel(tolerance=np.isfinite(runs["error"].values))
            assert_curve(next(drawn), solved["error"], solved["seconds"])
            # Runs beside which the machine did something else are hollow.
            disturbed = solved.isel(tolerance=solved["disturbed"].values == 1.0)
            hollow = next(drawn)
            assert_curve(hollow, disturbed["error"], disturbed["seconds"])
            assert hollow.get_markerfacecolor() == "white"
        [reference] = set(axes.get_lines()) - set(curves(axes))
        assert reference.get_xdata() == [data["reference_error"].sel(problem=problem)] * 2
        assert f"{axes.get_xscale()} {axes.get_yscale()}" == "log log"
        assert axes.get_title() == problem.replace("_", " ")


def test_figure_14_names_methods_failures_and_what_is_not_installed():
    _, panels = picture("fig14")
    _, drawn = sampled("fig14")
    assert sorted(annotations(panels["ring_hertz"])) == ["scipy dop853", "strain form"]
    assert "\nfailed at 1e-08: scipy dop853" in panels["contact_loss"].get_xlabel()
    assert "failed" not in panels["ring_hertz"].get_xlabel()
    assert panels["ring_hertz"].get_xlabel().startswith("largest error (reference ")
    assert drawn.get_supxlabel() == "not installed here: diffrax dopri8"


def test_figure_15_tells_cases_that_pass_from_those_that_do_not():
    data, panels = picture("fig15")
    axes = panels["cases"]
    limits, passed, failed, refused = curves(axes)
    assert_curve(limits, data["limit"], [0, -1, -2])
    assert_curve(passed, data["error"][:1], [0])
    assert_curve(failed, data["error"][1:2], [-1])
    # There is no error to show, so that a cross stands at the edge.
    assert_curve(refused, [1e-17], [-2])
    assert failed.get_color() == refused.get_color() == ALARM_COLOUR
    assert legend(axes) == ["limit", "passed", "failed", "no result"]
    names = [text.get_text() for text in axes.get_yticklabels()]
    assert names == ["gamma 1e-6", "alpha 1.02", "colliding fronts"]
    assert_labels(axes, "error", "", "log linear")


def test_figure_15_lists_only_what_occurs():
    given = SAMPLES["fig15"]()
    given["data"]["error"][2] = given["data"]["error"][0]
    given["data"]["passed"][:] = 1
    axes = draw("fig15", given).axes[0]
    assert legend(axes) == ["limit", "passed"]


def test_figure_15_shows_the_order_through_contact_events():
    data, panels = picture("fig15")
    axes = panels["orders"]
    for line, method in zip(curves(axes), data["method"], strict=True):
        one = data.sel({"method": method})
        assert_curve(line, one["event_steps"], one["event_error"])
        assert line.get_label().endswith(f": slope {float(one['observed_order']):.1f}")
    assert [label.split(":")[0] for label in legend(axes)] == [
        "events located",
        "$(x, w)$, blind",
        r"$(x, \dot x)$, blind",
    ]
    assert_labels(axes, "steps", "error after a collision", "log log")


MEASURED = {
    "speed, exact front": "speed_exact",
    "power, exact front": "power_exact",
    "speed, exact front in a chain": "speed_travelling",
    "speed, driven chain": "speed_driven",
    "velocity jump, driven chain": "velocity_jump_driven",
    "power, driven chain": "power_driven",
}


def test_figure_17_shows_distances_over_the_sum_of_both_errors():
    data, panels = picture("fig17")
    ratios, errors = curves(panels["ratio"]), curves(panels["error"])
    for ratio, error, (label, name) in zip(ratios, errors, MEASURED.items(), strict=True):
        theory = name.rpartition("_")[0] + "_expected"
        distance = data[name] - data[theory]
        stated = data[f"{name}_error"] + data[f"{theory}_error"]
        # A distance in units of the stated error, so that theory holds between −1 and 1.
        assert_curve(ratio, distance / stated, [2, 1, 0])
        assert_curve(error, data[f"{name}_error"] / data[theory], [2, 1, 0])
        assert ratio.get_label() == label
    assert legend(panels["ratio"]) == list(MEASURED)
    names = [text.get_text() for text in panels["ratio"].get_yticklabels()]
    assert names == ["Toda", "FPU α", "Hertz Kuwabara–Kono"]
    assert_labels(panels["ratio"], "(measured − theory) / stated error", "")
    assert_labels(panels["error"], "stated error, relative", "", "log linear")
    [band] = panels["ratio"].patches
    assert (band.get_x(), band.get_width()) == (-1.0, 2.0)
    shown = np.concatenate([line.get_xdata() for line in ratios])
    assert np.abs(shown).max() < panels["ratio"].get_xlim()[1]


def test_figure_17_shows_exact_fronts_with_their_states():
    data, panels = picture("fig17")
    axes = panels["profile"]
    for line, law in zip(curves(axes), data["law"][1:], strict=True):
        assert_curve(line, data["xi"], data["profile"].sel(law=law))
    states = [
        f"{float(one['state_minus']):g} to {float(one['state_plus']):g}"
        for one in (data.isel(law=law) for law in (1, 2))
    ]
    assert legend(axes) == [f"FPU α, {states[0]}", f"Hertz Kuwabara–Kono, {states[1]}"]
    assert_labels(axes, r"$\xi = n - |c|t$", r"$(R - R_a)/(R_b - R_a)$")


def test_figure_18_shows_damping_dashed_where_fronts_oscillate():
    data, panels = picture("fig18")
    drawn = iter(curves(panels["gamma"]))
    for beta in data["beta"]:
        law = data.sel(beta=beta)
        oscillating = (law["gamma"] < law["critical_gamma"]).values
        assert 0 < oscillating.sum() < oscillating.size
        full, dashed = next(drawn), next(drawn)
        assert_curve(full, data["velocity_ratio"], np.where(oscillating, np.nan, law["gamma"]))
        assert_curve(dashed, data["velocity_ratio"], np.where(oscillating, law["gamma"], np.nan))
        assert full.get_linestyle() == "-" != dashed.get_linestyle()
        assert full.get_color() == dashed.get_color()
    assert not list(drawn)
    assert_labels(panels["gamma"], "$v_p/v_c$", r"$\gamma$ of the front", "log log")
    assert panels["gamma"].get_title() == "full: overdamped, dashed: oscillating"


def test_figure_18_shows_restitution_over_velocity():
    data, panels = picture("fig18")
    for line, values in zip(curves(panels["restitution"]), data["restitution"], strict=True):
        assert_curve(line, data["velocity_ratio"], values)
    assert legend(panels["restitution"]) == [r"$\beta = 1$", r"$\beta = 1.5$"]
    assert_labels(panels["restitution"], "$v_0/v_c$", "restitution $e$", "log linear")
    assert panels["restitution"].get_ylim() == (0.0, 1.0)
