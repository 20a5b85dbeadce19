"""Attenuation of a pulse in a dimer over the mass ratio, and waves that leave nothing behind."""

import xarray as xr
from matplotlib.figure import Figure

from drawing import write_figure
from granular_fronts.output.style import PROBE_COLOURS, PROBE_STYLES, new_figure
from job import job

RATIOS = (1.0, 0.3, 0.1, 0.05, 0.03)


def jayaprakash_2011_ladder(found: xr.Dataset) -> Figure:
    """Draw the attenuation with both ladders, and the first waves.

    Parameters
    ----------
    found : xarray.Dataset
        Antiresonances, resonances and the attenuation between them.
    """
    figure, panels = new_figure(4.6, [["attenuation"], ["wave"]])
    attenuation, waves = panels.values()
    attenuation.semilogy(found["root"], found["attenuation"], "k.-", ms=2, lw=0.5)
    for ratio in found["antiresonance"].values:
        attenuation.axvline(ratio**-0.5, color="0.6", lw=0.5, zorder=0)
    strongest = found["resonance"] ** -0.5
    attenuation.plot(strongest, found["resonance_attenuation"], "o", mfc="none", ms=4)
    attenuation.set(
        xlabel=r"mass ratio $\varepsilon$, at equal distances of $\varepsilon^{-1/2}$",
        ylabel="attenuation per cell",
        xlim=(found["root"][0], found["root"][-1]),
        ylim=(1e-10, 0.1),
    )
    attenuation.set_xticks([ratio**-0.5 for ratio in RATIOS], [f"{ratio:g}" for ratio in RATIOS])
    for wave, color, style in zip(found["wave"], PROBE_COLOURS[:4], PROBE_STYLES, strict=False):
        label = rf"$\varepsilon$ = {float(found['antiresonance'].sel(order=wave['order'])):.4f}"
        waves.plot(wave["t"], wave / wave.max(), color=color, ls=style, label=label)
    waves.set(xlabel="time in units of a cell", ylabel=r"$u/\max u$", xlim=(-2.0, 2.0))
    figure.legend(*waves.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


if __name__ == "__main__":
    with job(snakemake):
        write_figure(
            jayaprakash_2011_ladder,
            snakemake.input.texts,
            snakemake.output,
            snakemake.params.shown,
            found=snakemake.input.found,
        )
