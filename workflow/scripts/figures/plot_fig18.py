"""Figure 18: where damping is weak, for four laws of damping; James (2021), section 3.1."""

from itertools import cycle

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from figure_step import run_figure
from granular_fronts.output.style import PROBE_COLOURS, new_figure

SHOWN_GAMMA = (0.03, 30.0)


def plot_fig18(data: xr.Dataset) -> Figure:
    """Draw γ of a front and e of a collision against the reference velocity.

    Parameters
    ----------
    data : xarray.Dataset
        Damping regimes.
    """
    figure, panels = new_figure(3.2, [["gamma", "restitution"]])
    for beta, colour in zip(data["beta"].values, cycle(PROBE_COLOURS), strict=False):
        law = data.sel(beta=beta)
        _draw_gamma(panels["gamma"], law, colour)
        label = rf"$\beta = {beta:g}$"
        panels["restitution"].semilogx(
            law["velocity_ratio"], law["restitution"], "-", color=colour, label=label
        )
    ends = float(data["velocity_ratio"][0]), float(data["velocity_ratio"][-1])
    panels["gamma"].set(
        xlabel="$v_p/v_c$",
        ylabel=r"$\gamma$ of the front",
        title="full: overdamped, dashed: oscillating",
        xlim=ends,
        ylim=SHOWN_GAMMA,
    )
    panels["restitution"].set(xlabel="$v_0/v_c$", ylabel="restitution $e$", xlim=ends, ylim=(0, 1))
    figure.legend(loc="outside upper center", ncols=min(6, data.sizes["beta"]))
    return figure


def _draw_gamma(axes: Axes, law: xr.Dataset, colour: str) -> None:
    """γ against velocity, full where fronts are overdamped and dashed where they oscillate."""
    oscillating = law["gamma"] < law["critical_gamma"]
    axes.loglog(law["velocity_ratio"], law["gamma"].where(~oscillating), "-", color=colour)
    axes.loglog(
        law["velocity_ratio"], law["gamma"].where(oscillating), linestyle=(0, (2, 1)), color=colour
    )


if __name__ == "__main__":
    run_figure(plot_fig18, globals().get("snakemake"))
