"""Figure 10: exact fronts, driven chains and continuum fronts; after James (2021), section 6.3."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.drawing import finish_grid
from granular_fronts.style import CHAIN_COLOUR, CONTINUUM_LOOKS, new_figure, save_figure
from step import run_step

FIELDS = {"relative_displacement": r"$u/\delta$", "velocity": r"$\dot x/\delta^{(\alpha+1)/2}$"}


def plot_fig10(scenes: list[Path], pdf: Path, png: Path) -> None:
    """Draw relative displacements and velocities of every scene.

    Parameters
    ----------
    scenes : list of Path
        Front scenes, one for each row.
    pdf, png : Path
        Files to write.
    """
    rows = [[f"{field} {row}" for field in FIELDS] for row in range(len(scenes))]
    figure, panels = new_figure(1.75 * len(rows), rows)
    for names, path in zip(rows, scenes, strict=True):
        data = read_dataset(path)
        for name, field in zip(names, FIELDS, strict=True):
            draw_roads(panels[name], data, field)
    finish_grid(figure, [panels[name] for name in rows[-1]], r"$\xi = n - ct$", columns=5)
    save_figure(figure, pdf, png)


def draw_roads(axes, data, field):
    """One field of one front: exact, driven, and the three continuum models."""
    driven = data[f"{field}_driven"]
    axes.plot(
        driven["xi_driven"],
        driven,
        ".",
        color="0.6",
        markersize=4,
        label="driven chain",
    )
    for front, (label, colour, line) in CONTINUUM_LOOKS.items():
        axes.plot(data["xi"], data[f"{field}_{front}"], color=colour, linestyle=line, label=label)
    axes.plot(data["xi"], data[field], "-", color=CHAIN_COLOUR, label="exact")
    law = rf"$\alpha = {data.attrs['alpha']:g}$, $\gamma c = {data.attrs['gamma']:.3g}$"
    axes.set(title=law, ylabel=FIELDS[field], xlim=(data["xi"][0], data["xi"][-1]))


if __name__ == "__main__":
    run_step(plot_fig10, globals().get("snakemake"))
