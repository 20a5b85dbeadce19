"""The one place for figure looks: sizes, colours, colour maps, saving.

The paper names the colours of its probes (black, blue, green, light blue, magenta, brown).  The
shades here keep those names and differ in lightness, and each has its own line style.  So the
curves stay apart in grey print and for colour-blind readers.
"""

import logging
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from string import ascii_lowercase
from typing import Any, NamedTuple

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.colors import Colormap, LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.rcsetup import cycler

from granular_fronts.output.files import complete_file

# In inches: 8.5 cm of a column of text, and 17.5 cm of a page.
COLUMN_WIDTH, PAGE_WIDTH = 8.5 / 2.54, 17.5 / 2.54
DOTS_PER_INCH = 200
PROBE_COLOURS = (
    "#000000",
    "#1a30c0",
    "#20a060",
    "#5cc0f5",
    "#c92fa4",
    "#5a2a05",
)
BLACK, BLUE, GREEN, LIGHT_BLUE, MAGENTA, BROWN = PROBE_COLOURS
DASHED, DOTTED, DASH_DOTTED = (0, (6, 1.5)), (0, (3, 1)), (0, (6, 1.5, 1, 1.5))
PROBE_STYLES = ("-", DASHED, DASH_DOTTED, DOTTED, (0, (6, 1, 1, 1, 1, 1)), (0, (1.5, 1)))
# What is clipped, failed or singled out.
ALARM_COLOUR = "#d8400c"


class Look(NamedTuple):
    """Label, colour and line of a curve, as keywords for `matplotlib.axes.Axes.plot`."""

    label: str
    color: str
    linestyle: Any


# The one table of looks: every curve that several figures show, by the name it has in the data.
LOOKS = {
    "exact": Look("exact front", BLACK, "-"),
    # Amplitude equations in time, and their fronts.
    "logarithmic": Look("logarithmic Burgers", BLUE, DASHED),
    "unlimited": Look(r"finite-$\alpha$ Burgers", GREEN, DASH_DOTTED),
    "dispersive": Look("logarithmic KdV–Burgers", MAGENTA, DOTTED),
    "heteroclinic": Look("logarithmic KdV–Burgers", MAGENTA, DOTTED),
    # Critical damping in its four meanings.
    "tail": Look("tail stops oscillating", BLACK, "-"),
    "double_root": Look("slowest tail roots merge", GREEN, DASH_DOTTED),
    "long_wave": Look(r"long-wave limit, $\mu = 2$", BLUE, DASHED),
    "overshoot": Look("overshoot too small to see", MAGENTA, DOTTED),
    "second_peak_leads": Look("second maximum higher", BROWN, "-"),
    "first_peak_stays_below": Look("first maximum below $\\delta$", BROWN, DASHED),
}
CONTINUUM_LOOKS = {name: LOOKS[name] for name in ("logarithmic", "unlimited", "heteroclinic")}
MODEL_LOOKS = {name: LOOKS[name] for name in ("logarithmic", "unlimited", "dispersive")}

CHAIN_COLOUR, EQUATION_COLOUR = BLACK, BLUE
# Exponents 3/2 and 1.1 in figure 4 of the paper; the limit is black.
EXPONENT_LOOKS = ((BLUE, DASHED), (GREEN, DASH_DOTTED))

# The font subsetter remarks on the fixed dates that make PDF files reproducible.
logging.getLogger("fontTools").setLevel(logging.ERROR)

# Letters of 7 points, and lines and marks in proportion, because figures are printed at their size.
_SETTINGS: dict[Any, Any] = {
    "figure.constrained_layout.use": True,
    "font.size": 7,
    "axes.titlesize": 7,
    "axes.titlepad": 4,
    "axes.labelsize": 7,
    "axes.labelpad": 3,
    "axes.linewidth": 0.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": cycler(color=PROBE_COLOURS, linestyle=PROBE_STYLES),
    "lines.linewidth": 0.9,
    "lines.markersize": 3,
    "lines.markeredgewidth": 0.6,
    "legend.frameon": False,
    "legend.fontsize": 7,
    "legend.handlelength": 2.5,
    "legend.columnspacing": 1.4,
    "pdf.fonttype": 42,
    "mathtext.fontset": "dejavusans",
    "image.interpolation": "nearest",
} | {
    f"{axis}tick.{name}": value
    for axis in "xy"
    for name, value in (
        ("labelsize", 7),
        ("major.size", 2.5),
        ("major.width", 0.5),
        ("major.pad", 2),
        ("minor.size", 1.5),
        ("minor.width", 0.4),
    )
}


@contextmanager
def looks_of_figures() -> Iterator[None]:
    """A context after which figures look as they did before it.

    `matplotlib.rc_context` would also undo what the backend of a notebook sets when the first
    figure starts it.
    """
    before = {name: matplotlib.rcParams[name] for name in _SETTINGS}
    try:
        yield
    finally:
        matplotlib.rcParams.update(before)


def new_panels(
    height: float, mosaic: list[Any], make: Callable[..., Figure], **shared: Any
) -> tuple[Figure, dict[str, Axes]]:
    """Make a figure, with a height in inches, of a mosaic of named panels.

    Panels below each other have the width of a column of text, others that of a page.  `shared` is
    whether all have the same axes, `sharex` or `sharey`.
    The figure is made by `matplotlib.pyplot.figure` where a notebook shows it.
    """
    matplotlib.rcParams.update(_SETTINGS)
    width = PAGE_WIDTH if any(len(row) > 1 for row in mosaic) else COLUMN_WIDTH
    figure = make(figsize=(width, height), dpi=DOTS_PER_INCH)
    return figure, figure.subplot_mosaic(mosaic, **shared)


def new_figure(height: float, mosaic: list[Any], **shared: Any) -> tuple[Figure, dict[str, Axes]]:
    """The same for a file: several panels have the letters (a), (b), … that its caption uses."""
    figure, panels = new_panels(height, mosaic, Figure, **shared)
    if len(panels) > 1:
        for letter, axes in zip(ascii_lowercase, panels.values(), strict=False):
            axes.set_title(f"({letter})", loc="left", fontweight="bold")
    return figure, panels


def fill_rows(names: Collection[str], columns: int) -> list[list[str]]:
    """Return rows of a mosaic with a panel for each name; the last one ends with empty places."""
    filled = [*names, *["."] * (-len(names) % columns)]
    return [filled[first : first + columns] for first in range(0, len(filled), columns)]


def compression_map() -> Colormap:
    """Colour map of relative displacements on a scale centred on 0: white at rest, gaps in red."""
    shades = [ALARM_COLOUR, "white", "#7f9bea", "#101a66"]
    steps = [0.0, 0.5, 0.75, 1.0]
    colours = LinearSegmentedColormap.from_list(
        "compression", list(zip(steps, shades, strict=True))
    )
    return colours.with_extremes(under=ALARM_COLOUR)


def velocity_map() -> Colormap:
    """Colour map of velocities, white at rest."""
    return LinearSegmentedColormap.from_list("velocity", ["white", "#74c69a", "#063d22"])


def save_figure(figure: Figure, pdf: Path | str, png: Path | str, datasets: Iterable[Any]) -> None:
    """Save both formats, each appearing under its name only when complete.

    Their keywords are the scenes of the datasets with the digests of their numbers.  The PDF
    carries no date, so that equal data give equal files.
    """
    keywords = " ".join(f"{one.attrs['scene']}:{one.attrs['data_digest']}" for one in datasets)
    # `savefig` would draw each format twice and arrange the panels anew for each.
    with complete_file(png) as unfinished:
        FigureCanvasAgg(figure).print_png(unfinished, metadata={"Keywords": keywords})
    figure.set_layout_engine("none")
    with complete_file(pdf) as unfinished:
        metadata = {"Keywords": keywords, "CreationDate": None}
        FigureCanvasPdf(figure).print_pdf(unfinished, metadata=metadata)
