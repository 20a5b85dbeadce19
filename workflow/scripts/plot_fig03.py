"""Figure 3: a front is initiated by constant pressure, strong damping; James (2021), figure 3."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import draw_probes, draw_spacetime
from granular_fronts.style import compression_map, new_figure, save_figure
from step import run_step


def plot_fig03(dataset: Path, pdf: Path, png: Path) -> None:
    """Draw relative displacements of the first beads, and of all beads in the (n, t) plane.

    Parameters
    ----------
    dataset : Path
        Scene initiation_overdamped.
    pdf, png : Path
        Files to write.
    """
    data = read_dataset(dataset)
    figure, panels = new_figure(4.0, [["transient", "displacement"]])
    draw_probes(panels["transient"], data, "transient")
    panels["transient"].legend(loc="lower right")
    draw_spacetime(
        panels["displacement"],
        data["relative_displacement_grid"].isel(bead=slice(None, -1)),
        colour_map=compression_map(),
        limits=(0.0, None),
        extend="neither",
        label="$u_n(t)$",
    )
    save_figure(figure, pdf, png)


if __name__ == "__main__":
    run_step(plot_fig03, globals().get("snakemake"))
