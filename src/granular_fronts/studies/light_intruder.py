r"""A light sphere among equal ones, which oscillates between its neighbours as a wave passes.

The *size* ρ of the intruder is its radius over that of the other spheres.  By Hertz it has the mass
:math:`\varepsilon = \rho^3`, and both its contacts are softer by :math:`\kappa =
\sqrt{2\rho/(1 + \rho)}`.  A solitary wave of speed c arrives in a chain at rest.

Let :math:`w = u_1 + u_2` and :math:`y = u_1 - u_2` of its contacts, with the forces
:math:`F_1, F_2`, and let :math:`G = F_0 - F_3` be that of the next ones.  Then exactly

.. math:: \ddot y = G - \Bigl(1 + \frac2\varepsilon\Bigr)(F_1 - F_2), \qquad
          F_1 - F_2 \approx \kappa\alpha\Bigl(\frac w2\Bigr)^{\alpha-1} y .

For small ε the neighbours are slow, and the frequency belongs to the compression w of the moment.
It is largest where w = W is:

.. math:: \omega^2 = \Bigl(1 + \frac2\varepsilon\Bigr)\kappa\alpha\Bigl(\frac W2\Bigr)^{\alpha-1} .

*Weightless intruder.*  As ε → 0 both contacts are one of the force :math:`\kappa(w/2)^\alpha`.
A chain with such a contact gives W, which makes ω known without any light bead.

The chain has no scale of its own, so that ω is proportional to c, and to the power
:math:`(\alpha-1)/(2\alpha)` of every force.

*Measurement.*  The zeros of :math:`\ddot y`, in which slow parts are smaller by ε than in y, give
the period around the time of W.  Behind W the contacts open, and later w has a second maximum.

Errors.  Every number is found again with a tolerance ten times larger, and from other samples.
"""

import math

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from granular_fronts.accuracy import Estimate, estimate, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_once
from granular_fronts.fronts.solitary_waves import POINTS_PER_BEAD, solitary_wave, start_in_waves

CENTRE, INTRUDER, BEADS, END = 8, 16, 42, 24.0
"""Contact at which the wave starts, bead of the intruder, beads, and time to the end for c = 1."""
SAMPLES = 24_000  # of the contacts around the intruder; one run uses the even ones, one the odd
SHARE, PADDED = 0.99, 2**16  # of the energy of a force below its edge; points of its spectrum

MEANINGS = {
    "frequency": "angular frequency of the intruder",
    "before": "amplitude of y before the contacts open",
    "after": "amplitude of y after they have opened",
    "force_before": "amplitude of the difference of forces before",
    "force_after": "amplitude of the difference of forces after",
    "law": "angular frequency by the law of a light intruder",
}


def softening(size):
    """Return by what the contact of two spheres is softer if one is smaller, by Hertz."""
    return math.sqrt(2.0 * size / (1.0 + size))


def find_oscillations(alpha, sizes, speeds, tolerance):
    """Find frequency and amplitudes of intruders of some sizes, behind waves of some speeds.

    On (speed, size), each with its `…_error`: `frequency`, and `law`, its closed form.  `before`
    and `after` are amplitudes of y in the first compression and the second, if there is one.
    `force_before` and `force_after` are those of the difference of both forces.  `edge` is that of
    the spectrum, without dimension.
    """
    looser = {key: 10.0 * value for key, value in tolerance.items()}

    def both(speed, size):
        found = (_measure(alpha, size, speed, *how) for how in ((tolerance, 0), (looser, 1)))
        return [estimate(*pair) for pair in zip(*found, strict=True)]

    table = np.array([[both(speed, size) for size in sizes] for speed in speeds])
    variables = variable_and_errors(
        "edge", (), edge_of_spectrum(alpha), "a coarser grid", "edge of the spectrum of the wave"
    )
    dims, method = ("speed", "size"), "a tolerance ten times larger, other samples"
    for place, (name, meaning) in enumerate(MEANINGS.items()):
        variables |= variable_and_errors(name, dims, table[:, :, place], method, meaning)
    coordinates = {
        "speed": ("speed", speeds, {"long_name": "speed of the incident wave"}),
        "size": ("size", sizes, {"long_name": "radius of the intruder over that of the others"}),
    }
    return xr.Dataset(variables, coordinates, {"alpha": alpha})


def _measure(alpha, size, speed, tolerance, offset):
    """Return the numbers of `MEANINGS`, from every second sample."""
    around = [INTRUDER - 2, INTRUDER - 1, INTRUDER, INTRUDER + 1]
    probe = {"beads": around, "start": 0.0, "stop": END / speed, "step": END / speed / SAMPLES}
    factors = [{"contact": place, "factor": softening(size)} for place in around[1:3]]
    mass, record = {"impurity": {"bead": INTRUDER, "mass": size**3}}, {"probes": {"around": probe}}
    motion = _simulate(alpha, speed, BEADS, mass, factors, record, tolerance)
    times, u = motion["t_around"].values, motion["relative_displacement_around"].values
    law = frequency_of_law(alpha, size, speed, tolerance)
    return *_read(alpha, size, times[offset::2], u[offset::2]), law


def _simulate(alpha, speed, beads, mass, factors, record, tolerance):
    scene = {
        "law": {"alpha": alpha, "beta": alpha, "gamma": 0.0},
        "beads": {"count": beads, "mass": mass},
        "contacts": {"elastic": {"impurity": factors}},
        "boundary": {"kind": "pressure", "left": 0.0, "right": 0.0},
        "start": start_in_waves(alpha, beads, [(CENTRE, speed)]),
        "end_time": END / speed,
        "tolerance": tolerance,
        "record": {"snapshots": []} | record,
    }
    return simulate_once(scene, "light intruder")


def _read(alpha, size, times, u):
    """Return frequency and amplitudes."""
    forces = np.maximum(u, 0.0) ** alpha * [1.0, softening(size), softening(size), 1.0]
    w, y, difference = u[:, 1] + u[:, 2], u[:, 1] - u[:, 2], forces[:, 1] - forces[:, 2]
    acceleration = forces[:, 0] - forces[:, 3] - (1.0 + 2.0 / size**3) * difference
    first = w.argmax()
    gap = first + int(np.argmin(w[first:] > 0.0))
    closed = (w > 0.5 * w[gap:].max()) & (times > times[gap])
    zeros = CubicSpline(times[:gap], acceleration[:gap]).roots(extrapolate=False)
    nearest = np.abs(0.5 * (zeros[2:] + zeros[:-2]) - times[first]).argmin()
    frequency = 2.0 * math.pi / (zeros[nearest + 2] - zeros[nearest])
    return (
        frequency,
        np.abs(acceleration[:gap]).max() / frequency**2,
        np.abs(y[closed]).max(initial=0.0),
        np.abs(difference[:gap]).max(),
        np.abs(difference[closed]).max(initial=0.0),
    )


def frequency_of_law(alpha, size, speed, tolerance):
    """Return ω of the closed form, with W of the chain whose intruder has no weight."""
    contact = INTRUDER - 1
    factors = {"contact": contact, "factor": softening(size) * 0.5**alpha}
    record = {"arrival_level": 0.01, "extremes": True}
    motion = _simulate(alpha, speed, BEADS - 1, 1.0, factors, record, tolerance)
    half = 0.5 * float(motion["first_peak"].sel(bead=contact))
    return math.sqrt((1.0 + 2.0 / size**3) * softening(size) * alpha * half ** (alpha - 1.0))


def edge_of_spectrum(alpha):
    """Return the frequency below which a share of the energy of the force of a wave lies, c = 1."""
    edges = []
    for points in (2 * POINTS_PER_BEAD, POINTS_PER_BEAD):
        force = np.maximum(solitary_wave(alpha, points).u, 0.0) ** alpha
        energy = np.cumsum(np.abs(np.fft.rfft(force, PADDED)) ** 2)
        omega = 2.0 * np.pi * np.fft.rfftfreq(PADDED, 1.0 / points)
        edges.append(np.interp(SHARE * energy[-1], energy, omega))
    return estimate(*edges)


def ratio(found, over, under, size):
    """Return one number of an intruder over another one, c = 1."""
    return tabulated(chosen := found.sel(size=size, speed=1), over) / tabulated(chosen, under)


def least_over_edge(found):
    """Return the least frequency of all sizes over the edge of the spectrum, c = 1."""
    return min(ratio(found, "frequency", "edge", size) for size in found["size"].values)


def power_of_size(found, first, last):
    """Return the power of the size by which the frequency changes from one size to another."""
    near, far = (tabulated(found.sel(size=size, speed=1), "frequency") for size in (first, last))
    return _power(far / near, last / first)


def power_of_force(found, size):
    """Return the power of the force of the incident wave by which the frequency grows."""
    slow, fast = found["speed"].values[[0, -1]]
    weak, strong = (tabulated(found.sel(size=size, speed=one), "frequency") for one in (slow, fast))
    alpha = found.attrs["alpha"]
    return _power(strong / weak, (fast / slow) ** (2.0 * alpha / (alpha - 1.0)))


def _power(change, factor):
    return Estimate(math.log(change.value), change.error / change.value) / math.log(factor)
