"""Figure 7: ring and logarithmic Burgers equation, Hertz's law; James (2021), figure 7."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_comparison
from granular_fronts.style import save_figure
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
    save_figure(draw_comparison(read_dataset(dataset)), pdf, png)


if __name__ == "__main__":
    run_step(plot_fig07, globals().get("snakemake"))
