"""Draw results and the accurate answer."""

import numpy as np
from matplotlib import colormaps

from granular_fronts.output.style import CHAIN_COLOUR, EQUATION_COLOUR, new_figure

START = 0.01  # share of the largest u at which the drawn motion begins


def draw(problem, answer, results, findings):
    """Draw a contact in the middle against time, and the errors against the step."""
    figure, panels = new_figure(4.2, [["motion"], ["error"]])
    _draw_motion(panels["motion"], problem, answer, results)
    _draw_errors(panels["error"], findings)
    figure.suptitle(problem.title.replace(": ", "\n"), fontsize=7)
    return figure


def _draw_motion(axes, problem, answer, results):
    contact = max(1, problem.scene.beads.count // 2)
    u = answer["relative_displacement"].sel(contact=contact)
    axes.plot(answer["t"], u, "-", color=EQUATION_COLOUR, label="accurate")
    colours = colormaps["plasma"](np.linspace(0.85, 0.0, len(results)))
    for colour, result in zip(colours, results, strict=True):
        found = problem.relative_displacements(result.x)[:, contact - 1]
        axes.plot(result.t, found, ".", color=colour, markersize=2, label=f"$h = {result.step:g}$")
    moving = answer["t"].values[np.abs(u.values) > START * float(abs(u).max())]
    axes.set(xlabel="$t$", ylabel=f"$u_{{{contact}}}$", xlim=(moving[0], moving[-1]))
    axes.legend()


def _draw_errors(axes, findings):
    """Largest errors, with a line of slope 1 through the smallest step."""
    steps, errors = [one.step for one in findings], [one.error for one in findings]
    axes.loglog(steps, errors, "o", color=CHAIN_COLOUR)
    slope = [errors[-1] * step / steps[-1] for step in steps]
    axes.loglog(steps, slope, ":", color=CHAIN_COLOUR, label="order 1")
    axes.set(xlabel="$h$", ylabel="largest error")
    axes.set_xticks(steps, [f"{step:g}" for step in steps])
    axes.set_xticks([], minor=True)
    axes.legend()
