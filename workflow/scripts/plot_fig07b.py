"""Figure 7b: how far the ring is from its amplitude equations, over time.

The distances are defined in granular_fronts.comparison.
"""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_both_rings, finish_grid
from granular_fronts.style import EQUATION_COLOUR, UNLIMITED_COLOUR, save_figure
from step import run_step

EQUATIONS = {
    "logarithmic": ("(41)", EQUATION_COLOUR),
    "unlimited": ("(40)", UNLIMITED_COLOUR),
}
KINDS = {"sup": ("-", "largest"), "rms": ("--", "rms"), "floor": (":", "solvers")}
TITLES = {
    "relative_displacement": r"compression $u_{n,+}/\delta$",
    "velocity": r"velocity $\dot x_n/\delta^{(\alpha+1)/2}$",
}


def plot_fig07b(weak: Path, hertz: Path, pdf: Path, png: Path) -> None:
    """Draw distances and solver errors, a row for each exponent, a column for each field.

    Parameters
    ----------
    weak, hertz : Path
        The two periodic scenes.
    pdf, png : Path
        Files to write.
    """
    figure, rows = draw_both_rings(5.2, read_dataset(weak), read_dataset(hertz), draw_distances)
    for row in rows:
        row[0].set_ylabel("difference chain to equation")
    finish_grid(figure, rows[-1], "$t$")
    save_figure(figure, pdf, png)


def draw_distances(axes, data, field, exponent):
    """Distances of one field to both equations, and what the solvers contribute."""
    for kind, (style, words) in KINDS.items():
        for equation, (number, colour) in EQUATIONS.items():
            curve = data[f"{field}_{kind}_{equation}"].isel(t_grid=slice(1, None))
            label = f"{number} {words}"
            axes.semilogy(curve["t_grid"], curve, linestyle=style, color=colour, label=label)
    axes.set(xlim=(0, float(curve["t_grid"][-1])), ylim=(1e-8, 2))
    axes.set_title(f"{exponent}, {TITLES[field]}")


if __name__ == "__main__":
    run_step(plot_fig07b, globals().get("snakemake"))
