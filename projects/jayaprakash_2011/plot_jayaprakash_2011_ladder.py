"""Attenuation of a pulse in a dimer over the mass ratio, and waves that leave nothing behind."""

import xarray as xr
from matplotlib.figure import Figure

from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure

RATIOS = (1.0, 0.3, 0.1, 0.05, 0.03)


def plot_jayaprakash_2011_ladder(found: xr.Dataset) -> Figure:
    """Draw the attenuation with both ladders, and the first waves.

    Parameters
    ----------
    found : xarray.Dataset
        Antiresonances, resonances and the attenuation between them.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure, panels = new_figure(3.6, [["attenuation", "attenuation", "wave"]])
    axes = panels["attenuation"]
    axes.semilogy(found["root"], found["attenuation"], "k.-", ms=2, lw=0.7)
    for ratio in found["antiresonance"].values:
        axes.axvline(ratio**-0.5, color="0.6", lw=0.7, zorder=0)
    axes.plot(found["resonance"] ** -0.5, found["resonance_attenuation"], "o", mfc="none", ms=6)
    axes.set(
        xlabel=r"mass ratio $\varepsilon$, at equal distances of $\varepsilon^{-1/2}$",
        ylabel="attenuation per cell",
        xlim=(found["root"][0], found["root"][-1]),
        ylim=(1e-10, 0.1),
    )
    axes.set_xticks([ratio**-0.5 for ratio in RATIOS], [f"{ratio:g}" for ratio in RATIOS])
    for wave, color, style in zip(found["wave"], PROBE_COLOURS[:4], PROBE_STYLES, strict=False):
        ratio = float(found["antiresonance"].sel(order=wave["order"]))
        panels["wave"].plot(
            wave["t"],
            wave / wave.max(),
            color=color,
            ls=style,
            label=rf"$\varepsilon$ = {ratio:.4f}",
        )
    panels["wave"].set(xlabel="time in units of a cell", ylabel=r"$u/\max u$", xlim=(-2.0, 2.0))
    figure.legend(*panels["wave"].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure
