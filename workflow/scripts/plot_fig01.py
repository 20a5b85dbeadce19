"""Figure 1: a front is initiated by constant pressure, weak damping; James (2021), figure 1."""

from pathlib import Path

from granular_fronts.datasets import read_dataset
from granular_fronts.style import new_figure, save_figure
from step import run_step


def plot_fig01(dataset: Path, pdf: Path, png: Path) -> None:
    """Draw relative displacements of single beads and a snapshot of the velocities.

    Parameters
    ----------
    dataset : Path
        Scene initiation_underdamped.
    pdf, png : Path
        Files to write.
    """
    data = read_dataset(dataset)
    figure, panels = new_figure(4.8, [["steady", "snapshot"], ["transient", "transient"]])
    draw_probes(panels["steady"], data, "steady")
    label_peaks(panels["steady"])
    draw_probes(panels["transient"], data, "transient")
    panels["transient"].legend(loc="lower right")
    draw_velocities(panels["snapshot"], data)
    save_figure(figure, pdf, png)


def draw_probes(axes, data, name):
    """u_n(t) of every bead of a probe set."""
    probes = data[f"relative_displacement_{name}"]
    for bead in probes[f"bead_{name}"].values:
        curve = probes.sel({f"bead_{name}": bead})
        axes.plot(curve[f"t_{name}"], curve, label=f"$n = {bead}$")
    axes.set(xlabel="$t$", ylabel="$u_n(t)$", xlim=(curve[f"t_{name}"][0], curve[f"t_{name}"][-1]))


def label_peaks(axes):
    """Write each curve's label above its highest point, in its colour."""
    for line in axes.get_lines():
        t, u = line.get_data()
        axes.annotate(
            line.get_label(),
            (t[u.argmax()], u.max()),
            xytext=(0, 3),
            textcoords="offset points",
            ha="center",
            fontsize=7,
            color=line.get_color(),
        )


def draw_velocities(axes, data):
    """Velocities of all beads at the snapshot."""
    snapshot = data["velocity"].isel(t=0)
    axes.plot(snapshot["bead"], snapshot, ".-", color="black", markersize=2.5, linewidth=0.6)
    axes.set(xlabel="$n$", ylabel=r"$\dot x_n$", title=f"$t = {float(snapshot['t']):g}$")
    axes.set_xlim(0, snapshot["bead"][-1])


if __name__ == "__main__":
    run_step(plot_fig01, globals().get("snakemake"))
