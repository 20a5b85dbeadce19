"""Figure 7: ring and logarithmic Burgers equation, Hertz's law; James (2021), figure 7."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_comparison, snapshot_rows
from granular_fronts.style import new_figure, save_figure
from step import run_step


def plot_fig07(dataset: Path, pdf: Path, png: Path) -> None:
    """Draw relative displacements and velocities at every snapshot.

    Parameters
    ----------
    dataset : Path
        Periodic scene hertz.
    pdf, png : Path
        Files to write.
    """
    data = read_dataset(dataset)
    rows = snapshot_rows(data)
    figure, panels = new_figure(1.7 * len(rows), rows)
    draw_comparison(panels, data)
    save_figure(figure, pdf, png)


if __name__ == "__main__":
    run_step(plot_fig07, globals().get("snakemake"))
