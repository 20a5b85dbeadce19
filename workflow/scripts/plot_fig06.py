"""Figure 6: ring and logarithmic Burgers equation, alpha = 1.1; James (2021), figure 6."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_comparison
from granular_fronts.style import save_figure
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
    save_figure(draw_comparison(read_dataset(dataset)), pdf, png)


if __name__ == "__main__":
    run_step(plot_fig06, globals().get("snakemake"))
