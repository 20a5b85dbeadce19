r"""Pulses in tapered chains of spheres, binary collisions, and the loss for vanishing taper.

Bead 1 strikes a chain of spheres at rest whose radii grow or shrink from bead to bead.  By Hertz
contact n has the factor :math:`r_n \propto (R_n R_{n+1}/(R_n + R_{n+1}))^{1/2}`, and
:math:`m_n \propto R_n^3`.  In the units used, those of the first bead, all of them begin with 1.

Binary collisions.  Bead n of velocity :math:`v_n` meets the next one at rest.  With the reduced
mass :math:`\mu_n` the largest compression and the time until it, in which the pulse passes, are

.. math::

    v_{n+1} = \frac{2 v_n}{1 + m_{n+1}/m_n}, \qquad
    z_n = \Bigl(\frac{5 \mu_n v_n^2}{4 r_n}\Bigr)^{2/5}, \qquad
    T_n = \frac{z_n}{v_n} \int_0^1 \frac{dx}{(1 - x^{5/2})^{1/2}} .

Loss.  If each mass is :math:`e^\varepsilon` times the one before, the pulse becomes similar to
itself.  Its energy :math:`E_n \propto r_n z_n^{5/2}` falls by the factor :math:`e^{-\Lambda}` per
contact.  Binary collisions give :math:`\Lambda = 2 \ln\cosh(\varepsilon/2)`.

The pulse is a solitary wave of momentum :math:`P = (2 m_* E)^{1/2}`, where
:math:`m_*/m = P^2/(2mE)` is a constant of such waves.  As the mass of its beads changes and its
energy almost not, P changes by Pε/2 per bead.  The beads behind keep the difference, and with it
the energy :math:`(P\varepsilon/2)^2/(2m)`.  Hence
:math:`\Lambda \to (m_*/m)\,\varepsilon^2/4`.  Binary collisions have :math:`m_* = m`.

Towards lighter beads those behind move forwards, with :math:`v = P|\varepsilon|/(2m)`, and are
compressed.  The length that the pulse holds is L = P/(mc), and it changes too, since
:math:`r_n \propto e^{\varepsilon n/6}`.  From :math:`c^5 \propto r^2 P/m^3` follows
:math:`dL/dn = -\varepsilon L/15`, which is 2/15 of v/c.  Thus they keep the compression
:math:`w = \theta v/c` with :math:`\theta = 1 - \tfrac45 \cdot \tfrac16`, and the energy
:math:`\tfrac25 w^{5/2}` besides.  The pressure :math:`w^{3/2}` behind changes the momentum by
:math:`w^{3/2}/c` per bead, a part of the order :math:`|\varepsilon|^{1/2}`.  The energy
:math:`v w^{3/2}/c` that follows cancels against the work of this pressure.  With P/(mc) = p and
m = c = 1

.. math::

    \Lambda \to \frac{m_*}{m} \frac{\varepsilon^2}{4}
    \Bigl(1 + \tfrac45 \theta^{5/2} (\tfrac12 p |\varepsilon|)^{1/2}\Bigr) .

Towards heavier beads gaps open behind the pulse, and the correction is of the order of ε.
"""

import numpy as np
import xarray as xr
from scipy.special import beta

from granular_fronts.accuracy import (
    Estimate,
    estimate,
    variable_and_errors,
)
from granular_fronts.chain.measures import peak_decay
from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.scenes.beads import Pattern
from granular_fronts.studies.strikers import struck_chain

HALF_COLLISION = 0.4 * beta(0.4, 0.5)
"""Time of half a collision over z/v."""

SHARE_OF_COMPRESSION = (13.0 / 15.0) ** 2.5
"""θ^(5/2) of spheres."""

BEADS, BETWEEN = 66, (40, 50, 60)
"""Contacts between which the loss is measured; that between the first two checks it."""

METHOD = "change over other contacts, and the error of the motion"
LOSS = "loss of energy per contact over that of binary collisions"


def spheres(taper, beads):
    """Return masses and factors of contacts of spheres whose radii have a taper, a pattern."""
    radius = values_along(Pattern(taper=taper), beads)
    return radius**3, np.sqrt(2.0 * radius[:-1] * radius[1:] / (radius[:-1] + radius[1:]))


def binary_collisions(mass, factor):
    """Return the largest compression of each contact, and when it comes, for a striker of speed 1.

    Examples
    --------
    >>> compression, time = binary_collisions(np.ones(3), np.ones(2))
    >>> np.round(compression, 4), np.round(time, 4)
    (array([0.8286, 0.8286]), array([1.2194, 2.4388]))
    """
    velocity = np.cumprod(np.append(1.0, 2.0 / (1.0 + mass[1:-1] / mass[:-2])))
    reduced = mass[:-1] * mass[1:] / (mass[:-1] + mass[1:])
    compression = (1.25 * reduced * velocity**2 / factor) ** 0.4
    return compression, np.cumsum(HALF_COLLISION * compression / velocity)


def follow_one(taper, tolerance):
    """Return largest compressions and their times by collisions, and the motion of the chain."""
    mass, factor = spheres(taper, BEADS)
    collisions = binary_collisions(mass, factor)
    scene = struck_chain(
        (1.5, 1.5, 0.0),
        {"count": BEADS, "mass": {"list": mass.tolist()}},
        float(1.2 * collisions[1][-1]),
        tolerance,
        {"snapshots": [], "arrival_level": 0.01, "extremes": True},
    )
    scene["contacts"] = {"elastic": {"list": factor.tolist()}}
    return collisions, simulate_chain(scene, "tapered chain")


def follow_pulses(chains, tapers, tolerance):
    """Compare pulses with binary collisions along named chains, and measure losses at tapers ε.

    On (chain, contact): `compression`, `time`, each with `…_of_collisions`.  On (taper):
    `loss_ratio`, the loss over that of collisions, and `loss_ratio_theory` as ε → 0; without
    dimensions `mass_of_wave`, m_*/m of a solitary wave.
    """
    found = [follow_one(taper, tolerance) for taper in chains.values()]
    variables, dims = {}, ("chain", "contact")
    for index, (name, recorded, meaning) in enumerate(
        (
            ("compression", "first_peak", "largest compression of a contact"),
            ("time", "first_peak_time", "time of the largest compression of a contact"),
        )
    ):
        series = [motion[recorded][:-1] for _, motion in found]
        attributes = {
            "long_name": meaning,
            "error_estimate": max(one.attrs["error_estimate"] for one in series),
            "error_method": series[0].attrs["error_method"],
        }
        variables[name] = (dims, np.array(series), attributes)
        variables[f"{name}_of_collisions"] = (
            dims,
            np.array([collisions[index] for collisions, _ in found]),
            {"long_name": f"{meaning} by binary collisions"},
        )
    ratios = [_loss_ratio(taper, tolerance) for taper in tapers]
    (mass, length), (coarse, _) = (_constants_of_wave(points) for points in (32, 16))
    of_wave, fewer = estimate(mass, coarse), "half as many points"
    variables |= variable_and_errors("loss_ratio", "taper", ratios, METHOD, LOSS)
    variables |= variable_and_errors("mass_of_wave", (), of_wave, fewer, "P²/(2mE)")
    compressed = (0.5 * length * np.maximum(-np.array(tapers), 0.0)) ** 0.5
    variables["loss_ratio_theory"] = (
        "taper",
        mass * (1.0 + 0.8 * SHARE_OF_COMPRESSION * compressed),
        {"long_name": f"{LOSS}, for vanishing taper"},
    )
    coordinates = {
        "chain": ("chain", [*chains], {"long_name": "name of the chain"}),
        "contact": np.arange(1, BEADS),
        "taper": ("taper", tapers, {"long_name": "logarithm of a mass over the one before"}),
    }
    return xr.Dataset(variables, coordinates)


def _loss_ratio(taper, tolerance):
    _, motion = follow_one({"ratio": float(np.exp(taper / 3.0))}, tolerance)
    other, found = (
        peak_decay(motion, BETWEEN[0], last) * 2.5 - taper / 6.0 for last in BETWEEN[1:]
    )
    change = Estimate(0.0, abs(found.value - other.value))
    return (found + change) / (2.0 * np.log(np.cosh(0.5 * taper)))


def _constants_of_wave(points):
    """Return P²/(2mE) and P/(mc) of the solitary wave of speed 1."""
    u = np.maximum(solitary_wave(1.5, points).u, 0.0)
    momentum, energy = u.sum() / points, 0.9 * (u**2.5).sum() / points
    return momentum**2 / (2.0 * energy), momentum
