r"""Fronts of the linear dashpot: critical damping, two widths, and how fast they form.

A front of the law (28) with β = 1, from compression 1 into a chain at rest, has the speed 1.

Long waves.  To fourth order in the wave number :math:`u = (1 + \tfrac1{12}\partial_\xi^2) u^\alpha
- \gamma u'`.  Its tail :math:`u - 1 \sim e^{\lambda\xi}` obeys :math:`\tfrac{\alpha}{12}\lambda^2 -
\gamma\lambda + \alpha - 1 = 0` and ceases to oscillate at :math:`\gamma_c = (\alpha(\alpha -
1)/3)^{1/2}`.

Two widths.  The width from u = 0.9 to 0.1 knows no oscillation.  A *settling* width goes
from u = ε to where u stays within ε of 1.  It falls at once where the first peak no longer exceeds
1 + ε, and grows from there on.  So it is least at the damping whose overshoot is ε.
"""

import numpy as np
import xarray as xr
from scipy.optimize import brentq

from granular_fronts.accuracy import Estimate, rounded, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.linear.critical_damping import critical_damping
from granular_fronts.fronts.solve import solve_front

ALPHA = 1.5
LEVELS = (0.1, 0.01, 1e-3, 1e-5)
WEAK = 0.1
"""Damping of the front that forms."""

SOUGHT = 1e-9
FOOT = 0.01
"""Compression at which the leading pulse begins."""


def shocks():
    """Return `width` on (gamma), `least_settling` on (level) and `transient` on (contact)."""
    critical = critical_damping(ALPHA, 1.0)
    dampings = [0.02, 0.05, WEAK, 0.2, 0.3, critical, 0.5]
    fronts = [solve_front(ALPHA, gamma, 1.0) for gamma in dampings]
    widths = [[one.attrs[f"width_10_90{part}"] for part in ("", "_error")] for one in fronts]
    least = [(overshooting(level, critical), 2.0 * SOUGHT) for level in LEVELS]
    weak = fronts[dampings.index(WEAK)]
    peaks = _forming()
    apart = [
        (peak - 1.0 - weak.attrs["first_peak"], peaks.attrs["error_estimate"])
        for peak in peaks.values
    ]
    variables = {}
    for name, dims, found, method, meaning in (
        ("width", "gamma", widths, "a refined front", "width from 0.9 to 0.1"),
        ("least_settling", "level", least, "the root", "damping of least settling width"),
        ("transient", "contact", apart, "halved steps", "first peak less that of the front"),
        ("pulse", (), _leading_pulse(weak), "the grid", "length of the leading pulse"),
    ):
        variables |= variable_and_errors(name, dims, found, method, meaning)
    coordinates = {"gamma": dampings, "level": list(LEVELS), "contact": peaks["bead"].values}
    return xr.Dataset(variables, coordinates, {"critical_damping": critical})


def overshooting(level, critical):
    """Return the damping below the critical one at which a front overshoots by a level."""
    return brentq(
        lambda gamma: solve_front(ALPHA, gamma, 1.0).attrs["overshoot"] - level,
        0.05,
        critical,
        xtol=SOUGHT,
    )


def _forming():
    """Return the first peaks at contacts of a chain that is pressed at its end."""
    scene = {
        "law": {"alpha": ALPHA, "beta": 1.0, "gamma": WEAK},
        "beads": 80,
        "boundary": {"kind": "pressure", "left": 1.0, "right": 0.0},
        "start": {"kind": "rest"},
        "end_time": 70.0,
        "tolerance": {"relative": 1e-10, "absolute": 1e-12},
        "record": {"snapshots": [], "arrival_level": 0.5, "extremes": True},
    }
    return simulate_chain(scene)["first_peak"][:60]


def _leading_pulse(front):
    """Return the length from the foot of a front to its first minimum."""
    xi, u = front["xi"].values, front["relative_displacement"].values
    foot, top = np.flatnonzero(u > FOOT)[-1], int(np.argmax(u))
    lowest = top - int(np.argmax(np.diff(u[top::-1]) > 0.0))
    return Estimate(float(xi[foot] - xi[lowest]), 2.0 * float(xi[1] - xi[0]))


def long_wave_critical_damping(alpha):
    """Return the damping at which the tail of the long-wave equation ceases to oscillate."""
    return (alpha * (alpha - 1.0) / 3.0) ** 0.5


def long_wave_over_exact(found):
    """Return the critical damping of long waves over that of the chain."""
    return rounded(long_wave_critical_damping(ALPHA) / found.attrs["critical_damping"], 8.0)


def width_over_least(found):
    """Return the 10–90 width at the critical damping over the least of all dampings."""
    at_critical = tabulated(found, "width", gamma=found.attrs["critical_damping"])
    return at_critical / tabulated(found.isel(gamma=int(np.argmin(found["width"].values))), "width")


def least_settling_over_critical(found, level):
    """Return the damping of least settling width over the critical one."""
    return tabulated(found, "least_settling", level=level) / found.attrs["critical_damping"]


def travelled(found, within):
    """Return the first contact from which on peaks are near that of the front, over the pulse."""
    far = np.flatnonzero(abs(found["transient"].values) > within)
    return Estimate(float(found["contact"][far[-1] + 1]), 0.0) / tabulated(found, "pulse")
