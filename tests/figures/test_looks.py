"""A curve looks the same in every figure; colours differ for the colour-blind and in grey."""

from itertools import combinations

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D
from pictures import curves, sampled
from traces import Sample

from granular_fronts.output.style import ALARM_COLOUR, LOOKS, PROBE_COLOURS

# Of linear colours, Machado, Oliveira and Fernandes (2009), severity 1.
SIGHT = {
    "normal": np.eye(3),
    "no green": [[0.367, 0.861, -0.228], [0.280, 0.673, 0.047], [-0.012, 0.043, 0.969]],
    "no red": [[0.152, 1.053, -0.205], [0.115, 0.786, 0.099], [-0.004, -0.048, 1.052]],
    "no blue": [[1.256, -0.077, -0.179], [-0.078, 0.931, 0.148], [0.005, 0.691, 0.304]],
}
XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def lab(colour, sight):
    """CIE L*, a*, b* of a colour as somebody sees it."""
    rgb = np.array(to_rgb(colour))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    x, y, z = XYZ @ np.clip(SIGHT[sight] @ linear, 0.0, 1.0) / XYZ.sum(axis=1)
    fx, fy, fz = (np.cbrt(t) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116 for t in (x, y, z))
    return np.array([116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)])


@pytest.mark.parametrize("sight", SIGHT)
def test_no_two_colours_are_alike_to_anybody(sight):
    """A difference of 2.3 is the least that is seen; one of 6.8 was lost between thin lines."""
    seen = [lab(colour, sight) for colour in (*PROBE_COLOURS, ALARM_COLOUR)]
    assert min(np.linalg.norm(one - other) for one, other in combinations(seen, 2)) > 18.0


def test_curves_that_meet_differ_in_grey_and_in_their_dashes():
    for group in (
        ("tail", "double_root", "long_wave", "overshoot"),
        ("exact", "logarithmic", "unlimited", "heteroclinic"),
    ):
        looks = [LOOKS[name] for name in group]
        greys = sorted(lab(look.color, "normal")[0] for look in looks)
        assert np.diff(greys).min() > 8.0
        assert len({str(look.linestyle) for look in looks}) == len(looks)


@pytest.mark.parametrize("figure", ["fig10", "fig11", "fig12", "fig20"])
def test_every_figure_draws_a_curve_as_the_table_says(figure):
    given, drawn = sampled(figure)
    sample, found = Sample(given), 0
    expected = {
        name: (look.color, Line2D([], [], **look._asdict())._unscaled_dash_pattern)
        for name, look in LOOKS.items()
    }
    for line in (line for axes in drawn.axes for line in curves(axes)):
        variable, _ = sample.trace(np.asarray(line.get_ydata(), dtype=float))
        for name in (name for name in LOOKS if variable.endswith(f"_{name}")):
            assert (line.get_color(), line._unscaled_dash_pattern) == expected[name]
            found += 1
    assert found
