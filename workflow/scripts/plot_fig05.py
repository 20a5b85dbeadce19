"""Figure 5: start of the comparison of ring and equation; James (2021), figure 5."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_both_rings, draw_chain_dots
from granular_fronts.style import save_figure
from step import run_step


def plot_fig05(weak: Path, hertz: Path, pdf: Path, png: Path) -> None:
    """Draw relative displacements and velocities at t = 0, a row for each exponent.

    Parameters
    ----------
    weak, hertz : Path
        The two periodic scenes.
    pdf, png : Path
        Files to write.
    """
    figure, rows = draw_both_rings(3.6, read_dataset(weak), read_dataset(hertz), draw_start)
    for axes in rows[-1]:
        axes.set_xlabel("$n$")
    save_figure(figure, pdf, png)


def draw_start(axes, data, field, exponent):
    """One field of all beads at t = 0."""
    draw_chain_dots(axes, data.sel(t=0.0), field)
    axes.annotate(exponent, (0.02, 0.86), xycoords="axes fraction")


if __name__ == "__main__":
    run_step(plot_fig05, globals().get("snakemake"))
