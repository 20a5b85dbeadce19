"""Draw docs/front.gif, the chain of figures 1 and 2 in motion: python docs/front_film.py."""

from pathlib import Path

import matplotlib.pyplot as plt
import yaml
from matplotlib.animation import FuncAnimation, PillowWriter

import granular_fronts as gf

DOCS = Path(__file__).parent
values = yaml.safe_load((DOCS.parent / "config/default.yaml").read_text(encoding="utf-8"))
scene = values["scenes"]["chain"]["initiation_underdamped"] | {"end_time": 1490}
scene["record"] = {"snapshots": [], "grid": {"step": 10}}
motion = gf.simulate_chain(scene).isel(bead=slice(None, -1))  # bead n with contact n
u, velocity, n = motion["relative_displacement_grid"], motion["velocity_grid"], motion["bead"]
moved = velocity.cumulative_integrate("t_grid")
places = 0.35 * n.size * moved / moved.max() + n  # all displacements times the same number

figure, (beads, upper, lower) = plt.subplots(3, figsize=(6.9, 3.8), layout="constrained")
circles = beads.scatter(n[::10], 0 * n[::10], 60, u[0, ::10], cmap="RdBu", vmin=-0.1, vmax=0.1)
beads.set(xlim=(0, 1.35 * n.size), title="one bead in 10: blue compressed, red before a gap")
beads.set(xticks=[], yticks=[], frame_on=False)
circles.set_edgecolor("black")
[compression] = upper.plot(n, u[0], "k.-", markersize=2.5, linewidth=0.6)
[speed] = lower.plot(n, velocity[0], "k.-", markersize=2.5, linewidth=0.6)
upper.set(xlim=(0, n.size), ylim=(-0.15, 0.15), ylabel="compression $u_n$")
lower.set(xlim=(0, n.size), ylim=(-0.01, 0.16), ylabel=r"velocity $\dot x_n$", xlabel="bead $n$")


def show(row):
    """Show the chain at one of the times of the grid."""
    circles.set(offsets=[(place, 0.0) for place in places[row, ::10]], array=u[row, ::10])
    compression.set_ydata(u[row])
    speed.set_ydata(velocity[row])
    upper.set_title(f"time t = {motion['t_grid'].values[row]:g}", loc="left")


film = FuncAnimation(figure, show, u["t_grid"].size)
film.save(DOCS / "front.gif", PillowWriter(fps=16), dpi=120)
