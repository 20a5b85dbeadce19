r"""Pulses in tapered chains of spheres, and the binary collision approximation.

Bead 1 strikes a chain of spheres at rest whose radii grow or shrink from bead to bead.  By Hertz
contact n has the factor :math:`r_n \propto (R_n R_{n+1}/(R_n + R_{n+1}))^{1/2}`, and
:math:`m_n \propto R_n^3`.  In the units used, those of the first bead, all of them begin with 1.

Binary collisions.  The approximation takes one contact at a time.  Bead n of velocity :math:`v_n`
meets the next one at rest, so that with the reduced mass :math:`\mu_n`

.. math::

    v_{n+1} = \frac{2 v_n}{1 + m_{n+1}/m_n}, \qquad
    z_n = \Bigl(\frac{5 \mu_n v_n^2}{4 r_n}\Bigr)^{2/5}, \qquad
    T_n = \frac{z_n}{v_n} \int_0^1 \frac{dx}{(1 - x^{5/2})^{1/2}} .

:math:`z_n` is the largest compression.  :math:`T_n` is the time until it, when both velocities are
the same, and the pulse passes from bead to bead in this time.

Loss.  If each mass is :math:`e^\varepsilon` times the one before, the pulse becomes similar to
itself.  Its energy :math:`E_n \propto r_n z_n^{5/2}` falls by the factor :math:`e^{-\Lambda}` per
contact.  Binary collisions give :math:`\Lambda = 2 \ln\cosh(\varepsilon/2)`.  With the ratio of
both losses, their compressions are too high by a part (ratio − 1) ε²/10 more with each contact.

Vanishing taper.  The pulse is a solitary wave of momentum :math:`P = (2 m_* E)^{1/2}`, where
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

from granular_fronts.accuracy import Estimate, estimate, variable_and_errors
from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.scenes.beads import Pattern
from granular_fronts.studies.strikers import struck_chain

HALF_COLLISION = 0.4 * beta(0.4, 0.5)
"""Time of half a collision over z/v."""

SHARE_OF_COMPRESSION = (13.0 / 15.0) ** 2.5
"""θ^(5/2) of spheres."""

BETWEEN = 40, 50, 60
"""Contacts between which the loss is measured; that between the first two checks it."""

METHOD = "change over other contacts, and the error of the motion"


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


def _follow(taper, beads, tolerance):
    """Return largest compressions and their times, by collisions, and those of the chain."""
    mass, factor = spheres(taper, beads)
    collisions = binary_collisions(mass, factor)
    scene = struck_chain(
        (1.5, 1.5, 0.0),
        {"count": beads, "mass": {"list": mass.tolist()}},
        float(1.2 * collisions[1][-1]),
        tolerance,
        {"snapshots": [], "arrival_level": 0.01, "extremes": True},
    )
    scene["contacts"] = {"elastic": {"list": factor.tolist()}}
    motion = simulate_chain(scene, "tapered chain").isel(bead=slice(0, -1))
    return collisions, (motion["first_peak"], motion["first_peak_time"])


def follow_pulses(tapers, beads, tolerance):
    """Compare pulses with binary collisions, along chains of named tapers.

    On (chain, contact): `compression`, `time`, each with `…_of_collisions`.
    """
    found = [_follow(taper, beads, tolerance) for taper in tapers.values()]
    words = {"compression": "largest compression of a contact", "time": "time of it"}
    variables = {}
    for index, (name, meaning) in enumerate(words.items()):
        series = [exact[index] for _, exact in found]
        variables[name] = (
            ("chain", "contact"),
            np.array([one.values for one in series]),
            {
                "long_name": meaning,
                "error_estimate": max(one.attrs["error_estimate"] for one in series),
                "error_method": series[0].attrs["error_method"],
            },
        )
        variables[f"{name}_of_collisions"] = (
            ("chain", "contact"),
            np.array([collisions[index] for collisions, _ in found]),
            {"long_name": f"{meaning} by binary collisions"},
        )
    return xr.Dataset(variables, {"chain": [*tapers], "contact": np.arange(1, beads)})


def measure_losses(tapers, beads, tolerance):
    """Return the loss of energy per contact over that of binary collisions, on (taper).

    `taper` is ε; `loss_ratio`, and `loss_ratio_theory` to leading order on either side; without
    dimensions `mass_of_wave` and `length_of_wave` of a solitary wave, m_*/m and p.
    """
    ratios = [_loss_ratio(taper, beads, tolerance) for taper in tapers]
    of_wave = [_constants_of_wave(points) for points in (32, 16)]
    meaning_of_loss = "loss of energy per contact over that of binary collisions"
    variables = variable_and_errors("loss_ratio", "taper", ratios, METHOD, meaning_of_loss)
    words = {"mass_of_wave": "P²/(2mE)", "length_of_wave": "P/(mc)"}
    for (name, meaning), fine, coarse in zip(words.items(), *of_wave, strict=True):
        number = estimate(fine, coarse)
        variables |= variable_and_errors(name, (), number, "half as many points", meaning)
    compressed = (0.5 * of_wave[0][1] * np.maximum(-np.array(tapers), 0.0)) ** 0.5
    variables["loss_ratio_theory"] = (
        "taper",
        of_wave[0][0] * (1.0 + 0.8 * SHARE_OF_COMPRESSION * compressed),
        {"long_name": f"{meaning_of_loss}, for vanishing taper"},
    )
    return xr.Dataset(variables, {"taper": tapers})


def _loss_ratio(taper, beads, tolerance):
    _, (compression, _) = _follow({"ratio": float(np.exp(taper / 3.0))}, beads, tolerance)
    first, middle, last = (float(compression.sel(bead=contact)) for contact in BETWEEN)

    def loss(start, stop, contacts):
        return -2.5 * np.log(stop / start) / contacts - taper / 6.0

    found = loss(first, last, BETWEEN[2] - BETWEEN[0])
    other = loss(first, middle, BETWEEN[1] - BETWEEN[0])
    moved = 5.0 * compression.attrs["error_estimate"] / last / (BETWEEN[2] - BETWEEN[0])
    return Estimate(found, abs(found - other) + moved) / (2.0 * np.log(np.cosh(0.5 * taper)))


def _constants_of_wave(points):
    """Return P²/(2mE) and P/(mc) of the solitary wave of speed 1."""
    u = np.maximum(solitary_wave(1.5, points).u, 0.0)
    momentum, energy = u.sum() / points, 0.9 * (u**2.5).sum() / points
    return momentum**2 / (2.0 * energy), momentum
