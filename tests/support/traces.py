"""What a figure shows, traced to the variables of its sample.

`describe` says for each panel of which variables its curves and colours are, found by the numbers
alone, since those of a sample occur once.  To write what all figures show to
`tests/references/figures.yaml`, run ::

    PYTHONPATH=workflow/scripts/figures python tests/support/traces.py

and look at each line that it changes before you keep it.
"""

from pathlib import Path

import numpy as np
import yaml
from figure_samples import SAMPLES
from matplotlib.collections import PolyCollection
from matplotlib.ticker import FixedFormatter, FuncFormatter
from pictures import annotations, curves, panels, sampled

REFERENCE = Path(__file__).parents[1] / "references" / "figures.yaml"


class Sample:
    """The numbers of the datasets of a figure, and the variables that they belong to."""

    def __init__(self, given):
        self.places, twice = {}, set()
        for prefix, data in named_datasets(given):
            for name, values in data.data_vars.items():
                if values.dtype.kind == "f":
                    for number, place in zip(values.values.ravel(), places_of(values), strict=True):
                        twice |= {number} & self.places.keys()
                        self.places[number] = prefix + name, place
        # Flags are whole numbers, which many variables have.
        for number in {*twice, 0.0, 1.0} & self.places.keys():
            del self.places[number]

    def trace(self, numbers):
        """The variable behind some numbers with the place of each, or else what they are."""
        for sign, word in ((1.0, ""), (-1.0, "-")):
            found = [self.places.get(sign * number) for number in numbers]
            if found and all(found) and len({name for name, _ in found}) == 1:
                return word + found[0][0], [place for _, place in found]
        if len(numbers) <= 3:
            return str([float(f"{number:.6g}") for number in numbers]), []
        # Rounding differs between machines, and at nothing it is all there is.
        first, last, total = (round(one, 9) + 0.0 for one in (*numbers[[0, -1]], numbers.sum()))
        return f"[{first:.6g}, …, {last:.6g}] of sum {total:.6g}", []

    def curve(self, line):
        """Label and look of a curve and its variables, which are read in the same places."""
        x, y = (np.asarray(values, dtype=float) for values in line.get_data())
        seen = np.isfinite(x) & np.isfinite(y)
        (across, x_places), (up, y_places) = self.trace(x[seen]), self.trace(y[seen])
        if not x_places:
            across = dimension_of(x[seen], y_places) or across
        if not y_places:
            up = dimension_of(y[seen], x_places) or up
        for one, other in zip(x_places, y_places, strict=False):
            assert all(one[name] == other[name] for name in one.keys() & other.keys()), (up, across)
        label = "" if line.get_label().startswith("_") else f"{line.get_label()}: "
        look = [line.get_color(), line.get_linestyle(), line.get_marker()]
        look += ["hollow"] * (line.get_markerfacecolor() == "white")
        words = " ".join(str(word) for word in look if word not in ("None", None))
        return f"{label}{up} over {across}{common(y_places or x_places)}; {words}"

    def rule(self, line):
        """Where a straight line crosses a panel."""
        x, y = line.get_data()
        return self.trace(np.array([x[0] if x[0] == x[-1] else y[0]], dtype=float))[0]

    def plane(self, mesh, offset):
        """Scale and variable of a coloured plane, each number in the cell of its coordinates."""
        corners = mesh.get_coordinates()
        x, y = corners[0, :, 0] + offset, corners[:, 0, 1]
        values = np.ma.filled(mesh.get_array(), np.nan).reshape(y.size - 1, x.size - 1)
        rows, columns = np.nonzero(np.isfinite(values))
        name, places = self.trace(values[rows, columns])
        for place, row, column in zip(places, rows, columns, strict=bool(places)):
            inside = [
                x[column] < at < x[column + 1] or y[row] < at < y[row + 1]
                for at in place.values()
                if isinstance(at, float | int | np.number)
            ]
            assert sum(inside) >= 2, name
        bar, norm = mesh.colorbar, mesh.norm
        label = (bar.ax.get_xlabel() or bar.ax.get_ylabel()) if bar else ""
        if bar and not label:
            label = ", ".join(text.get_text() for text in bar.ax.get_xticklabels())
        scale = f"{type(norm).__name__} {norm.vmin:.6g} to {norm.vmax:.6g}"
        return f"{label}: {name}{common(places)}; {scale}"


def named_datasets(given):
    """The datasets of a figure, and what the names of their variables begin with."""
    for name, one in given.items():
        if isinstance(one, list):
            yield from ((f"{name}{row}.", data) for row, data in enumerate(one))
        else:
            yield f"{name}." if len(given) > 1 else "", one


def places_of(values):
    """Coordinates of each number of a variable, by dimension."""
    for index in np.ndindex(values.shape):
        yield {name: values[name].values[k] for name, k in zip(values.dims, index, strict=True)}


def dimension_of(numbers, places):
    """The dimension whose coordinates some numbers are in the places of others, if there is one."""
    for name in places[0] if places else ():
        if all(place[name] == number for place, number in zip(places, numbers, strict=True)):
            return name
    return None


def common(places):
    """In words, the coordinates that several places share."""
    same = (name for name in (places or [{}])[0] if len({place[name] for place in places}) == 1)
    return "".join(f" at {name} {places[0][name]}" for name in same)


def describe(figure):
    """What each panel of a figure shows, and the legend and the note outside the panels."""
    given, drawn = sampled(figure)
    sample = Sample(given)
    shown = {name: panel(sample, axes) for name, axes in panels(drawn).items()}
    outside = [*map(entries, drawn.legends), drawn.get_supxlabel()]
    return shown | ({"outside": [*filter(None, outside)]} if any(outside) else {})


def panel(sample, axes):
    """What a panel shows, part after part."""
    offset = 1.0 if axes.get_xlabel().endswith("- 1$") else 0.0
    lines, drawn = axes.get_lines(), curves(axes)
    planes = [each for each in axes.collections if hasattr(each, "get_coordinates")]
    rows = isinstance(axes.yaxis.get_major_formatter(), FixedFormatter | FuncFormatter)
    parts = [
        ("x", [f"{axes.get_xlabel()} {scale(axes.get_xscale(), axes.get_xlim(), axes, 'x')}"]),
        ("y", [f"{axes.get_ylabel()} {scale(axes.get_yscale(), axes.get_ylim(), axes, 'y')}"]),
        ("title", [axes.get_title(where) for where in ("center", "left", "right")]),
        ("legend", [axes.get_legend() and entries(axes.get_legend())]),
        ("text", annotations(axes)),
        ("rows", [" | ".join(text.get_text() for text in axes.get_yticklabels())] if rows else []),
        ("curve", [sample.curve(line) for line in drawn if np.size(line.get_xdata())]),
        ("rule", [sample.rule(line) for line in lines if line not in drawn]),
        ("band", [extent(each) for each in axes.collections if isinstance(each, PolyCollection)]),
        ("colours", [sample.plane(each, offset) for each in planes]),
    ]
    return [
        f"{name} {text}".replace("\n", " / ") for name, texts in parts for text in texts if text
    ]


def scale(kind, limits, axes, side):
    """Kind of an axis, and its limits where the script sets them."""
    left_to_matplotlib = getattr(axes, f"get_autoscale{side}_on")()
    return kind if left_to_matplotlib else "{} {:.4g} to {:.4g}".format(kind, *limits)


def extent(band):
    """Corners of what is filled between curves."""
    x, y = np.concatenate([path.vertices for path in band.get_paths()]).T
    return f"{x.min():.6g} to {x.max():.6g}, {y.min():.6g} to {y.max():.6g}"


def entries(legend):
    """Title and entries of a legend."""
    texts = [legend.get_title(), *legend.get_texts()]
    return " | ".join(filter(None, (text.get_text() for text in texts)))


if __name__ == "__main__":
    shown = {figure: describe(figure) for figure in SAMPLES}
    # A line for each panel.
    options = {"sort_keys": False, "allow_unicode": True, "default_flow_style": None}
    REFERENCE.write_text(yaml.safe_dump(shown, width=10**6, **options), encoding="utf-8")
