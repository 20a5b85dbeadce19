"""Figure 7b: how far the ring is from its amplitude equations, over time.

The distances are defined in granular_fronts.comparison.
"""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import FIELD_LABELS
from granular_fronts.style import EQUATION_COLOUR, UNLIMITED_COLOUR, new_figure, save_figure
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
    scenes = {r"$\alpha = 1.1$": read_dataset(weak), r"$\alpha = 3/2$": read_dataset(hertz)}
    rows = [[f"{title} {field}" for field in FIELD_LABELS] for title in scenes]
    figure, panels = new_figure(5.2, rows)
    for names, (title, data) in zip(rows, scenes.items(), strict=True):
        for name, field in zip(names, FIELD_LABELS, strict=True):
            draw_distances(panels[name], data, field)
            panels[name].set_title(f"{title}, {TITLES[field]}")
    for row in rows:
        panels[row[0]].set_ylabel("difference chain to equation")
    for name in rows[-1]:
        panels[name].set_xlabel("$t$")
    panels[rows[0][0]].legend(ncols=2, loc="center right", fontsize=7)
    save_figure(figure, pdf, png)


def draw_distances(axes, data, field):
    """Distances of one field to both equations, and what the solvers contribute."""
    for equation, (number, colour) in EQUATIONS.items():
        for kind, (style, words) in KINDS.items():
            curve = data[f"{field}_{kind}_{equation}"].isel(t_grid=slice(1, None))
            label = f"{number} {words}"
            axes.semilogy(curve["t_grid"], curve, linestyle=style, color=colour, label=label)
    axes.set(xlim=(0, float(curve["t_grid"][-1])), ylim=(1e-8, 2))


if __name__ == "__main__":
    run_step(plot_fig07b, globals().get("snakemake"))
