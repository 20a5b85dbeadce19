"""Figure 6: ring and logarithmic Burgers equation, alpha = 1.1; James (2021), figure 6."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_comparison, snapshot_rows
from granular_fronts.style import new_figure, save_figure
from step import run_step


def plot_fig06(dataset: Path, pdf: Path, png: Path) -> None:
    """Draw relative displacements and velocities at every snapshot.

    Parameters
    ----------
    dataset : Path
        Periodic scene weak.
    pdf, png : Path
        Files to write.
    """
    data = read_dataset(dataset)
    rows = snapshot_rows(data)
    figure, panels = new_figure(1.7 * len(rows), rows)
    draw_comparison(panels, data)
    save_figure(figure, pdf, png)


if __name__ == "__main__":
    run_step(plot_fig06, globals().get("snakemake"))
