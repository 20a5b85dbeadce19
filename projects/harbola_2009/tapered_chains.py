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
"""

import numpy as np
import xarray as xr
from scipy.special import beta

from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.output.datasets import write_dataset
from granular_fronts.scenes.beads import Pattern
from granular_fronts.studies.strikers import struck_chain
from job import job

HALF_COLLISION = 0.4 * beta(0.4, 0.5)
"""Time of half a collision over z/v."""


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


def follow_one(taper, beads, tolerance):
    """Return largest compressions and their times by collisions, and those of the chain."""
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
    found = [follow_one(taper, beads, tolerance) for taper in tapers.values()]
    words = {"compression": "largest compression of a contact", "time": "time of it"}
    variables, dims = {}, ("chain", "contact")
    for index, (name, meaning) in enumerate(words.items()):
        series = [exact[index] for _, exact in found]
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
    chain = ("chain", [*tapers], {"long_name": "name of the chain"})
    return xr.Dataset(variables, {"chain": chain, "contact": np.arange(1, beads)})


if __name__ == "__main__":
    with job(snakemake):
        settings = snakemake.params.settings
        pulses = follow_pulses(**settings)
        write_dataset(pulses, snakemake.output.dataset, scene_id="pulses", config=settings)
