"""Figure 5: start of the comparison of ring and equation; James (2021), figure 5."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import FIELD_LABELS, draw_chain_dots
from granular_fronts.style import new_figure, save_figure
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
    scenes = {r"$\alpha = 1.1$": read_dataset(weak), r"$\alpha = 3/2$": read_dataset(hertz)}
    rows = [[f"{title} {field}" for field in FIELD_LABELS] for title in scenes]
    figure, panels = new_figure(3.6, rows)
    for names, (title, data) in zip(rows, scenes.items(), strict=True):
        for name, field in zip(names, FIELD_LABELS, strict=True):
            draw_chain_dots(panels[name], data.sel(t=0.0), field)
            panels[name].annotate(title, (0.02, 0.88), xycoords="axes fraction")
            panels[name].set_ylim(bottom=0.0)
    for name in rows[-1]:
        panels[name].set_xlabel("$n$")
    save_figure(figure, pdf, png)


if __name__ == "__main__":
    run_step(plot_fig05, globals().get("snakemake"))
