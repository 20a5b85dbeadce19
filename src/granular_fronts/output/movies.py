"""A chain in motion: a figure that shows any time of the grid, and its moving picture."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import EllipseCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from PIL import Image

from granular_fronts import arguments
from granular_fronts.output.panels import (
    MARK_HEIGHT,
    contacts_open,
    draw_open_contacts,
    draw_snapshot,
    fix_ordinate,
    moving_parts,
    open_contacts,
)
from granular_fronts.output.style import CHAIN_COLOUR, compression_map, new_panels

if TYPE_CHECKING:
    import xarray as xr

HEIGHT = 3.8
DOTS_PER_INCH = 120
MILLISECONDS = 60
"""For which a frame is shown."""

ENDINGS = (".gif", ".png", ".webp")
"""Of files that may hold a moving picture."""

COLOURS = 64
"""Of lines and text, to which so few do no harm."""

BEADS_DRAWN = 42
"""As circles, of a longer chain every so many."""

FARTHEST = 0.35
"""How far a circle moves at most, as a share of the chain."""

FRAMES_PER_SAMPLE = 8
"""Of which one is looked at for its colours."""


class Movie:
    """A moving picture that notebooks play by themselves.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
    show : callable
        Puts what belongs to a row into the figure, and returns the artists that it may change.
    rows : sequence of int
        One for each frame.
    alternative : str
        What a reader who cannot see the picture should know.

    Attributes
    ----------
    figure, show, rows, alternative
        As above.
    """

    def __init__(
        self,
        figure: Figure,
        show: Callable[[int], Sequence[Artist]],
        rows: Sequence[int],
        alternative: str,
    ) -> None:
        self.figure, self.show, self.rows, self.alternative = figure, show, rows, alternative

    def write(self, path: Path | str) -> None:
        """Write the picture into a file.

        Parameters
        ----------
        path : Path or str
            Its ending names the format.

        Raises
        ------
        InputError
            If it ends in none of `ENDINGS`, or its folder is not there.
        """
        file = arguments.new_file("path", path)
        arguments.choice("ending of the file", file.suffix.lower(), ENDINGS)
        first, *others = self._with_few_colours(list(self.frames()))
        first.save(file, save_all=True, append_images=others, duration=MILLISECONDS, loop=0)

    def frames(self) -> Iterator[Image.Image]:
        """Draw the frames, what does not change once for all.

        Yields
        ------
        PIL.Image.Image
        """
        canvas = FigureCanvasAgg(self.figure)
        changing = self.show(self.rows[0])
        for artist in changing:
            artist.set_animated(True)
        try:
            canvas.draw()
            background = canvas.copy_from_bbox(self.figure.bbox)
            for row in self.rows:
                canvas.restore_region(background)
                for artist in self.show(row):
                    self.figure.draw_artist(artist)
                yield Image.fromarray(np.array(canvas.buffer_rgba())).convert("RGB")
        finally:
            for artist in changing:
                artist.set_animated(False)

    @staticmethod
    def _with_few_colours(frames: list[Image.Image]) -> list[Image.Image]:
        """The frames in the most frequent colours of all, the same in each."""
        sample = np.concatenate([np.asarray(frame) for frame in frames[-1::-FRAMES_PER_SAMPLE]])
        # Other methods mix the rare red of open contacts with the colours of the lines.
        palette = Image.fromarray(sample).quantize(COLOURS, Image.Quantize.MAXCOVERAGE)
        return [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]

    def _repr_html_(self) -> str:
        """The picture itself, so that a page needs no other file and no network."""
        with TemporaryDirectory() as folder:
            path = Path(folder, "movie.gif")
            self.write(path)
            picture = b64encode(path.read_bytes()).decode("ascii")
        return f'<img src="data:image/gif;base64,{picture}" alt="{self.alternative}">'


def moving_chain(motion: xr.Dataset) -> tuple[Figure, Callable[[int], Sequence[Artist]]]:
    """A figure of a motion on its space-time grid, and what shows a row of the grid in it.

    Circles are beads, where they are.  Below are relative displacements and velocities against the
    bead number.  Open contacts are marked at the lower edge, where the law lets them open.  What
    shows a row returns the artists that it has changed.
    """
    fields = moving_parts(motion, "_grid")
    opens = contacts_open(motion)
    mosaic = [["strip"], *([field] for field in fields for _ in range(3))]
    figure, panels = new_panels(HEIGHT, mosaic, partial(Figure, dpi=DOTS_PER_INCH))
    circles, move = _draw_strip(panels["strip"], fields)
    lines = {}
    for field, values in fields.items():
        lines[field] = draw_snapshot(panels[field], values[0], field, color=CHAIN_COLOUR)
        fix_ordinate(panels[field], values, opens=opens and field == "relative_displacement")
    upper = panels["relative_displacement"]
    upper.set(xlabel="", xlim=panels["velocity"].get_xlim())
    time = upper.set_title("$t$", loc="left")
    changing = [circles, *lines.values(), time]
    if opens:
        marks = draw_open_contacts(upper, fields["relative_displacement"][0])
        changing.append(marks)
        upper.legend(handles=[marks], loc="lower right", bbox_to_anchor=(1.0, 1.0))

    def show(row: int) -> Sequence[Artist]:
        move(row)
        for field, line in lines.items():
            line.set_ydata(fields[field][row])
        time.set_text(f"time $t = {float(motion['t_grid'][row]):g}$")
        if opens:
            beads = open_contacts(fields["relative_displacement"][row])
            marks.set_data(beads, np.full(beads.size, MARK_HEIGHT))
        return changing

    return figure, show


def _draw_strip(
    axes: Axes, fields: dict[str, xr.DataArray]
) -> tuple[EllipseCollection, Callable[[int], None]]:
    """Circles for beads, blue where compressed and red before a gap, and what moves them."""
    # All move by the same multiple of their displacements.
    u, velocity = fields.values()
    first = velocity.isel(bead=0).cumulative_integrate("t_grid").values
    # Contact n lies between beads n and n + 1.
    moved = first[:, np.newaxis] - np.cumsum(np.pad(u.values, [(0, 0), (1, 0)]), axis=1)
    count = velocity.sizes["bead"]
    every, scale = max(1, count // BEADS_DRAWN), FARTHEST * count / (np.abs(moved).max() or 1.0)
    places = np.arange(0, min(count, u.sizes["bead"]), every)
    circles = EllipseCollection(
        [every] * places.size,
        [every] * places.size,
        [0.0] * places.size,
        units="x",
        offsets=np.zeros((places.size, 2)),
        offset_transform=axes.transData,
        cmap=compression_map(),
        norm=Normalize(-float(u.max()), float(u.max())),
        edgecolors="black",
        linewidths=0.5,
    )
    axes.add_collection(circles)
    ends = scale * moved.min(), count + scale * moved.max()
    axes.set(xlim=(ends[0] - every, ends[1] + every), ylim=(-1, 1))
    axes.set_axis_off()
    if every > 1:
        axes.set_title(f"one bead in {every}", fontsize=8)

    def move(row: int) -> None:
        at = places + scale * moved[row, places]
        circles.set_offsets(np.stack([at, np.zeros(at.size)], axis=1))
        circles.set_array(u.values[row, places])

    return circles, move
