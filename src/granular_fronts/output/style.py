"""The one place for figure looks: sizes, colours, colour maps, saving.

The paper names the colours of its probes (black, blue, green, light blue, magenta, brown).  The
shades here keep those names and differ in lightness, and each has its own line style.  So the
curves stay apart in grey print and for colour-blind readers.
"""

import logging
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.colors import Colormap
from matplotlib.figure import Figure
from matplotlib.rcsetup import cycler

from granular_fronts.output.files import complete_file
from granular_fronts.output.provenance import source_of

TEXT_WIDTH = 6.9
DOTS_PER_INCH = 200
PROBE_COLOURS = ("#000000", "#1447c4", "#1a8f3c", "#46b4ea", "#d02fb4", "#8a4a12")
PROBE_STYLES = ("-", (0, (6, 1.5)), "-.", (0, (3, 1)), (0, (6, 1, 1, 1, 1, 1)), (0, (1.5, 1)))
CHAIN_COLOUR, EQUATION_COLOUR, UNLIMITED_COLOUR = "#000000", "#1447c4", "#1a8f3c"
HETEROCLINIC_COLOUR = "#d02fb4"
# Label, colour and line of each continuum front, by the name it has in the data.
CONTINUUM_LOOKS = {
    "logarithmic": ("(45)", EQUATION_COLOUR, (0, (6, 1.5))),
    "unlimited": ("(46)", UNLIMITED_COLOUR, "-."),
    "heteroclinic": ("heteroclinic", HETEROCLINIC_COLOUR, (0, (3, 1))),
}
# The same of each amplitude equation in time.
MODEL_LOOKS = {
    "logarithmic": ("(41)", EQUATION_COLOUR, (0, (6, 1.5))),
    "unlimited": ("(40)", UNLIMITED_COLOUR, "-."),
    "dispersive": ("(55)", HETEROCLINIC_COLOUR, (0, (3, 1))),
}
# Exponents 3/2 and 1.1 in figure 4 of the paper; the limit is black.
EXPONENT_COLOURS = ("#1447c4", "#1a8f3c")
# What is clipped, failed or singled out.
ALARM_COLOUR = "#d01c1c"
# Whose solver it is, in figure 14.
PACKAGE_COLOURS = {
    "ours": "#000000",
    "upwind": "#d01c1c",
    "scilab": "#d01c1c",
    "scipy": "#1447c4",
    "numbalsoda": "#1a8f3c",
    "sundials": "#8a4a12",
    "diffrax": "#d02fb4",
    "lammps": "#c47700",
}
PACKAGE_LINES: dict[str, Any] = {
    "upwind": "-",
    "scilab": (0, (4, 1)),
    "scipy": "-",
    "numbalsoda": (0, (6, 1.5)),
    "sundials": (0, (2, 1)),
    "diffrax": (0, (6, 1, 1, 1, 1, 1)),
    "lammps": "-.",
}

# The font subsetter remarks on the fixed dates that make PDF files reproducible.
logging.getLogger("fontTools").setLevel(logging.ERROR)

_SETTINGS: dict[Any, Any] = {
    "figure.constrained_layout.use": True,
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": cycler(color=PROBE_COLOURS, linestyle=PROBE_STYLES),
    "lines.linewidth": 1.2,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "legend.handlelength": 3.0,
    "pdf.fonttype": 42,
    "mathtext.fontset": "cm",
    "image.interpolation": "nearest",
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


figure_for_files = partial(Figure, dpi=DOTS_PER_INCH)
"""What makes a figure that is saved, and that no notebook shows."""


def new_figure(
    height: float,
    mosaic: list[Any],
    make: Callable[..., Figure] = figure_for_files,
) -> tuple[Figure, dict[str, Axes]]:
    """Make a figure of text width, with a height in inches, and a mosaic of named panels.

    It is made by `matplotlib.pyplot.figure` where a notebook shows it.
    """
    matplotlib.rcParams.update(_SETTINGS)
    figure = make(figsize=(TEXT_WIDTH, height))
    return figure, figure.subplot_mosaic(mosaic)


def fill_rows(names: Collection[str], columns: int) -> list[list[str]]:
    """Return rows of a mosaic with a panel for each name; the last one ends with empty places."""
    filled = [*names, *["."] * (-len(names) % columns)]
    return [filled[first : first + columns] for first in range(0, len(filled), columns)]


def compression_map() -> Colormap:
    """Colour map of relative displacements: darker with compression, wide-open gaps in red."""
    return matplotlib.colormaps["bone_r"].with_extremes(under=ALARM_COLOUR)


def velocity_map() -> Colormap:
    """Colour map of velocities, light at rest."""
    return matplotlib.colormaps["viridis_r"]


def save_figure(figure: Figure, pdf: Path, png: Path, datasets: Iterable[Any]) -> None:
    """Save both formats, each appearing under its name only when complete.

    Their keywords are the sources of the datasets, see `provenance`.  The PDF carries no date, so
    that equal data give equal files.
    """
    keywords = " ".join(":".join(source_of(dataset).values()) for dataset in datasets)
    # `savefig` would draw each format twice and arrange the panels anew for each.
    with complete_file(png) as unfinished:
        FigureCanvasAgg(figure).print_png(unfinished, metadata={"Keywords": keywords})
    figure.set_layout_engine("none")
    with complete_file(pdf) as unfinished:
        metadata = {"Keywords": keywords, "CreationDate": None}
        FigureCanvasPdf(figure).print_pdf(unfinished, metadata=metadata)
