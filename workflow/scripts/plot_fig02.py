"""Figure 2: space-time diagrams of a front and its reflections; James (2021), figure 2."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_spacetime
from granular_fronts.style import compression_map, new_figure, save_figure, velocity_map
from step import run_step

# The paper clips its colours here: gaps wider than the largest compression are red.
CLIP = 0.14


def plot_fig02(dataset: Path, pdf: Path, png: Path) -> None:
    """Draw u_n(t) and the velocities in the (n, t) plane, through two reflections.

    Parameters
    ----------
    dataset : Path
        Scene initiation_underdamped.
    pdf, png : Path
        Files to write.
    """
    data = read_dataset(dataset)
    figure, panels = new_figure(4.4, [["displacement", "velocity"]])
    draw_spacetime(
        panels["displacement"],
        data["relative_displacement_grid"].isel(bead=slice(None, -1)),
        colour_map=compression_map(),
        limits=(-CLIP, CLIP),
        extend="min",
        label="$u_n(t)$",
    )
    draw_spacetime(
        panels["velocity"],
        data["velocity_grid"],
        colour_map=velocity_map(),
        limits=(0.0, None),
        extend="neither",
        label=r"$\dot x_n(t)$",
    )
    panels["velocity"].set_ylabel("")
    save_figure(figure, pdf, png)


if __name__ == "__main__":
    run_step(plot_fig02, globals().get("snakemake"))
