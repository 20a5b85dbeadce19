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

*Measurement.*  The phase is kπ at the k-th zero of :math:`\ddot y`, in which slow parts are smaller
by ε than in y.  The frequency is the slope of a spline through the phases of the first compression,
at the time of W.

Errors.  A frequency changes within its own period.  It is found again from the zeros at which
:math:`\ddot y` rises and from those at which it falls.  The larger difference is the error.
The edge of the spectrum is found again with half the steps of space and frequency.  The law is
found again with a tolerance three times larger; all sizes have the largest of its errors.
"""

import math

import numpy as np
import xarray as xr
from scipy.integrate import cumulative_trapezoid
from scipy.interpolate import CubicSpline

from granular_fronts.accuracy import Estimate, estimate, tabulated, variable_and_errors
from granular_fronts.chain.simulate import simulate_once
from granular_fronts.fronts.solitary_waves import POINTS_PER_BEAD, solitary_wave, start_in_waves

CENTRE, INTRUDER, BEADS, END = 8, 16, 42, 12.0
"""Contact at which the wave starts, bead of the intruder, beads, and time to the end for c = 1."""
SAMPLES = 24_000  # of the contacts around the intruder
PRESSED = 0.1  # part of W above which zeros belong to the first compression
SHARES = 0.99, 0.999  # of the energy of a force below its edge
LONG = 2**13  # beads of the period by which the spectrum is sampled


def softening(size):
    """Return by what the contact of two spheres is softer if one is smaller, by Hertz."""
    return math.sqrt(2.0 * size / (1.0 + size))


def find_oscillations(alpha, sizes, speeds, tolerance):
    """Find the frequency of intruders of some sizes, behind waves of some speeds.

    On (speed, size), each with its `…_error`: `frequency`, and `law`, with a computed W.  On
    (share): `edge` of the spectrum for c = 1.
    """
    looser = {key: 3.0 * value for key, value in tolerance.items()}
    frequency = [[_measure(alpha, size, speed, tolerance) for size in sizes] for speed in speeds]

    def by_law(speed, size):
        return estimate(*(_law(alpha, size, speed, one) for one in (tolerance, looser)))

    law = np.array([[by_law(speed, size) for size in sizes] for speed in speeds])
    law[..., 1] = law[..., 1].max(axis=1, keepdims=True)
    edges = [edge_of_spectrum(alpha, share) for share in SHARES]
    dims = ("speed", "size")
    variables = variable_and_errors(
        "frequency", dims, frequency, "rising or falling zeros", "angular frequency of the intruder"
    )
    variables |= variable_and_errors(
        "law", dims, law, "a larger tolerance", "angular frequency by the law of a light intruder"
    )
    variables |= variable_and_errors(
        "edge", ("share",), edges, "finer steps", "edge of the spectrum of the wave"
    )
    coordinates = {
        "speed": ("speed", speeds, {"long_name": "speed of the incident wave"}),
        "size": ("size", sizes, {"long_name": "radius of the intruder over that of the others"}),
        "share": ("share", list(SHARES), {"long_name": "share of energy below the edge"}),
    }
    return xr.Dataset(variables, coordinates, {"alpha": alpha})


def _measure(alpha, size, speed, tolerance):
    """Return the frequency at the largest compression."""
    around = [INTRUDER - 2, INTRUDER - 1, INTRUDER, INTRUDER + 1]
    probe = {"beads": around, "start": 0.0, "stop": END / speed, "step": END / speed / SAMPLES}
    factors = [{"contact": place, "factor": softening(size)} for place in around[1:3]]
    mass, record = {"impurity": {"bead": INTRUDER, "mass": size**3}}, {"probes": {"around": probe}}
    motion = _simulate(alpha, speed, BEADS, mass, factors, record, tolerance)
    times, u = motion["t_around"].values, motion["relative_displacement_around"].values
    forces = np.maximum(u, 0.0) ** alpha * [1.0, softening(size), softening(size), 1.0]
    acceleration = forces @ [1.0, -1.0 - 2.0 / size**3, 1.0 + 2.0 / size**3, -1.0]
    w = u[:, 1] + u[:, 2]
    pressed = w > PRESSED * w.max()
    zeros = CubicSpline(times[pressed], acceleration[pressed]).roots(extrapolate=False)
    return frequency_at(times[w.argmax()], zeros)


def frequency_at(time, zeros):
    """Return the frequency at a time, from successive zeros of an oscillation."""
    whole, *halves = (
        CubicSpline(zeros[first::step], np.pi * step * np.arange(zeros[first::step].size))(time, 1)
        for first, step in ((0, 1), (0, 2), (1, 2))
    )
    return Estimate(float(whole), float(np.abs(whole - halves).max()))


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


def _law(alpha, size, speed, tolerance):
    """Return ω of the law, with W of the chain whose intruder has no weight."""
    contact = INTRUDER - 1
    factors = {"contact": contact, "factor": softening(size) * 0.5**alpha}
    record = {"arrival_level": 0.01, "extremes": True}
    motion = _simulate(alpha, speed, BEADS - 1, 1.0, factors, record, tolerance)
    half = 0.5 * float(motion["first_peak"].sel(bead=contact))
    return math.sqrt((1.0 + 2.0 / size**3) * softening(size) * alpha * half ** (alpha - 1.0))


def edge_of_spectrum(alpha, share):
    """Return the frequency below which a share of the energy of the force of a wave lies, c = 1."""
    edges = []
    for finer in (2, 1):
        points, period = finer * POINTS_PER_BEAD, finer * LONG
        force = np.maximum(solitary_wave(alpha, points).u, 0.0) ** alpha
        omega = 2.0 * np.pi * np.fft.rfftfreq(points * period, 1.0 / points)
        spectrum = np.abs(np.fft.rfft(force, points * period)) ** 2
        energy = cumulative_trapezoid(spectrum, omega, initial=0.0)
        edges.append(np.interp(share * energy[-1], energy, omega))
    return estimate(*edges)


def ratio(found, over, under, size, share=SHARES[0]):
    """Return one number of an intruder over another one, c = 1, with the edge of a share."""
    chosen = found.sel(size=size, share=share, speed=1)
    return tabulated(chosen, over) / tabulated(chosen, under)


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
