"""Draw a front that starts, crosses the chain and is reflected: a moving picture, and a still."""

from pathlib import Path

import matplotlib.pyplot as plt
import xarray as xr

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import complete_file
from granular_fronts.output.plot import animate, chain
from granular_fronts.output.provenance import write_provenance
from granular_fronts.output.style import DOTS_PER_INCH, save_figure
from step import run_step

FRAMES = 151
CROSSINGS = 2.0
"""How long the picture lasts, in times that the front needs to reach the free end."""

STILLS = (0.6, 1.15, 1.6)
"""Times of the still, in the same unit: before the reflection, and twice after it."""


def animate_front(dataset: Path, gif: Path, pdf: Path, png: Path, provenance: Path) -> None:
    """Write the moving picture, the same at three times for print, and what they were made from.

    Parameters
    ----------
    dataset : Path
        Scene initiation_underdamped, with the arrival times of the front.
    gif : Path
        The moving picture.
    pdf, png : Path
        The still.
    provenance : Path
        The JSON file that says what they were made from.
    """
    plt.rcdefaults()  # Whatever looks the user's own matplotlibrc asks for.
    motion = read_dataset(dataset)
    crossing = float(motion["arrival_time"].max())
    with complete_file(gif) as unfinished:
        animate(motion.sel(t_grid=slice(0.0, CROSSINGS * crossing)), FRAMES).write(unfinished)
    chain(at_times(motion, [share * crossing for share in STILLS]))
    figure = plt.gcf()
    figure.set_dpi(DOTS_PER_INCH)
    save_figure(figure, pdf, png, [motion])
    plt.close(figure)
    write_provenance(provenance, [gif, pdf, png], [motion])


def at_times(motion: xr.Dataset, times: list[float]) -> xr.Dataset:
    """A motion whose snapshots are the moments of its space-time grid nearest to some times."""
    fields = motion[["relative_displacement_grid", "velocity_grid"]]
    moments = fields.sel(t_grid=times, method="nearest").rename(
        relative_displacement_grid="relative_displacement", velocity_grid="velocity", t_grid="t"
    )
    return moments.assign_attrs(motion.attrs)


if __name__ == "__main__":
    run_step(animate_front, globals().get("snakemake"))
