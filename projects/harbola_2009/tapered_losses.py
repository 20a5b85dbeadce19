r"""What a pulse in a tapered chain of spheres loses, and its limit for vanishing taper.

If each mass is :math:`e^\varepsilon` times the one before, the pulse becomes similar to
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

from granular_fronts.accuracy import Estimate, estimate, variable_and_errors
from granular_fronts.fronts.solitary_waves import solitary_wave
from granular_fronts.output.datasets import write_dataset
from job import job
from tapered_chains import follow_one

SHARE_OF_COMPRESSION = (13.0 / 15.0) ** 2.5
"""θ^(5/2) of spheres."""

BETWEEN, BEADS = (40, 50, 60), 66
"""Contacts between which the loss is measured; that between the first two checks it."""

METHOD = "change over other contacts, and the error of the motion"
LOSS = "loss of energy per contact over that of binary collisions"


def measure_losses(tapers, tolerance):
    """Return the loss of energy per contact over that of binary collisions, on (taper).

    `taper` is ε; `loss_ratio`, and `loss_ratio_theory` to leading order on either side; without
    dimensions `mass_of_wave`, m_*/m of a solitary wave.
    """
    ratios = [_loss_ratio(taper, tolerance) for taper in tapers]
    variables = variable_and_errors("loss_ratio", "taper", ratios, METHOD, LOSS)
    (mass, length), (coarse, _) = (_constants_of_wave(points) for points in (32, 16))
    method = "half as many points"
    variables |= variable_and_errors("mass_of_wave", (), estimate(mass, coarse), method, "P²/(2mE)")
    compressed = (0.5 * length * np.maximum(-np.array(tapers), 0.0)) ** 0.5
    variables["loss_ratio_theory"] = (
        "taper",
        mass * (1.0 + 0.8 * SHARE_OF_COMPRESSION * compressed),
        {"long_name": f"{LOSS}, for vanishing taper"},
    )
    coordinate = ("taper", tapers, {"long_name": "logarithm of a mass over the one before"})
    return xr.Dataset(variables, {"taper": coordinate})


def _loss_ratio(taper, tolerance):
    _, (compression, _) = follow_one({"ratio": float(np.exp(taper / 3.0))}, BEADS, tolerance)
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


if __name__ == "__main__":
    with job(snakemake):
        settings = snakemake.params.settings
        losses = measure_losses(**settings)
        write_dataset(losses, snakemake.output.dataset, scene_id="losses", config=settings)
